// Real spherical harmonics of many directions, a register full at a time.  Conventions:
// docs/conventions.md#sh
//
// Values are those of `evaluate` (renderer/harmonics/basis.h), to the last bit in double, wherever
// a direction stands in its block and whatever instructions the processor has.  [Sloan2013]
#pragma once

#include "renderer/harmonics/basis_kernels.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace renderer::harmonics {

/// One number of every direction of a block.
template <class T>
struct alignas(64) Line {
    T at[static_cast<std::size_t>(lanes<T>)];
};

template <class T>
struct DirectionBlock {
    Line<T> x, y, z;
};

/// Directions in blocks, in their order; +z fills the last.  T is float or double.
/// Errors: EXPECTS unit vectors (1e-6).
template <class T>
std::vector<DirectionBlock<T>> in_blocks(std::span<const glm::dvec3> directions);

enum class InstructionSet { Baseline, Avx2, Avx512 };

std::string_view name_of(InstructionSet set); ///< "baseline", "AVX2", "AVX-512"

/// What this processor has, the fastest last.
std::span<const InstructionSet> instruction_sets();

/// Evaluates every basis function of the first `bands` bands in every direction.
/// Shapes: value i of a block's directions is values[block * bands^2 + i].
/// Units:  as those of `evaluate`.  In the direction that the T's point to, wherever it is, they
/// err by at most 2e-15 in double and 7e-7 in float up to five bands, 1.2e-14 and 1.8e-6 up to ten.
/// Errors: EXPECTS 1 <= bands <= most_unrolled_bands and the size of `values`.
template <class T>
void evaluate_blocks(int bands,
                     std::span<const DirectionBlock<T>> directions,
                     std::span<Line<T>> values,
                     InstructionSet set = instruction_sets().back());

/// The values in one direction, one in every `lanes` of a block.
class LaneValues {
  public:
    LaneValues(const Line<double>* lines, std::size_t lane) : lines_(lines), lane_(lane) {}

    double operator[](std::size_t i) const { return lines_[i].at[lane_]; }

  private:
    const Line<double>* lines_;
    std::size_t lane_;
};

/// Calls visit(j, y) for every directions[j] in turn; y[i] is value i.  Blocks are evaluated as
/// many at once as stay in the first level of cache. Errors: those of in_blocks and
/// evaluate_blocks.
template <class Visit>
void for_each_basis(int bands, std::span<const glm::dvec3> directions, Visit visit) {
    constexpr auto width = static_cast<std::size_t>(lanes<double>);
    const auto n = static_cast<std::size_t>(bands) * static_cast<std::size_t>(bands);
    const std::size_t most_blocks = std::max<std::size_t>(1, 256 / n); // 16 kB of values
    std::vector<Line<double>> values(most_blocks * n);
    for (std::size_t first = 0; first < directions.size(); first += most_blocks * width) {
        const auto some =
            directions.subspan(first, std::min(most_blocks * width, directions.size() - first));
        const auto blocks = in_blocks<double>(some);
        evaluate_blocks<double>(bands, blocks, std::span(values).first(blocks.size() * n));
        for (std::size_t j = 0; j < some.size(); ++j)
            visit(first + j, LaneValues(&values[j / width * n], j % width));
    }
}

} // namespace renderer::harmonics
