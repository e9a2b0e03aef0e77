// Bands come and go over 150 ms, so that no change of their number is seen as a jump.
#pragma once

#include <span>
#include <vector>

namespace renderer::thickness {

/// A weight for each band, which moves toward 1 for the bands that are wanted and toward 0 for the
/// others, all the way in 150 ms, at a steady pace from wherever it is.  Multiply y_lm(L) by weight
/// l.  State and time come from outside: no clock.
class BandFade {
  public:
    /// Starts at rest with the first `bands` of `available` bands shown.
    /// Errors: EXPECTS 1 <= bands <= available.
    BandFade(int available, int bands);

    /// Errors: EXPECTS 1 <= wanted <= available and seconds >= 0.
    void advance(int wanted, double seconds);

    /// weights()[l] of band l, 0..1, never growing with l.
    std::span<const double> weights() const { return weights_; }

    /// Bands that have to be fetched: those with a weight above 0.
    int bands() const;

  private:
    std::vector<double> weights_;
};

} // namespace renderer::thickness
