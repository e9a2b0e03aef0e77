// Percentiles of a stream of lengths, in memory that does not grow with the stream.
#pragma once

#include <cstdint>
#include <vector>

namespace renderer::thickness {

/// A histogram of positive numbers in bins of 1/256 of a binary octave, from 2^-32 to 2: the
/// exponent and the first 8 bits of the significand are the bin.  Weights are integers, so sums are
/// the same in every order, and so for every number of threads.
class LengthHistogram {
  public:
    LengthHistogram();

    /// Counts `length`; what is not above 2^-32 is not counted, what is 2 or more is in the last
    /// bin.
    void add(float length, std::uint64_t weight);

    LengthHistogram& operator+=(const LengthHistogram& other);

    /// The length below which `fraction` (0..1) of the weight lies, between bin edges in
    /// proportion; 0 when nothing was counted.
    double percentile(double fraction) const;

  private:
    std::vector<std::uint64_t> weights_;
};

} // namespace renderer::thickness
