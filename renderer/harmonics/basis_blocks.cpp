// The choice of a kernel, once for each processor.
#include "renderer/harmonics/basis_blocks.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis_polynomials.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <type_traits>

namespace renderer::harmonics {

namespace {

std::vector<InstructionSet> found_instruction_sets() {
    std::vector<InstructionSet> found{InstructionSet::Baseline};
#ifdef PAIRLIGHT_WIDE_REGISTERS
    if (__builtin_cpu_supports("avx2"))
        found.push_back(InstructionSet::Avx2);
    if (__builtin_cpu_supports("avx512f"))
        found.push_back(InstructionSet::Avx512);
#endif
    return found;
}

const BlockKernels& kernels(InstructionSet set) {
#ifdef PAIRLIGHT_WIDE_REGISTERS
    if (set == InstructionSet::Avx512)
        return avx512_kernels;
    if (set == InstructionSet::Avx2)
        return avx2_kernels;
#endif
    EXPECTS(set == InstructionSet::Baseline);
    return baseline_kernels;
}

template <class T>
BlockKernel<T> kernel(InstructionSet set, int bands) {
    const auto n = static_cast<std::size_t>(bands - 1);
    if constexpr (std::is_same_v<T, double>)
        return kernels(set).in_double[n];
    else
        return kernels(set).in_float[n];
}

} // namespace

std::string_view name_of(InstructionSet set) {
    switch (set) {
    case InstructionSet::Avx2:
        return "AVX2";
    case InstructionSet::Avx512:
        return "AVX-512";
    case InstructionSet::Baseline:
        break;
    }
    return "baseline";
}

std::span<const InstructionSet> instruction_sets() {
    static const auto found = found_instruction_sets();
    return found;
}

template <class T>
std::vector<DirectionBlock<T>> in_blocks(std::span<const glm::dvec3> directions) {
    constexpr auto width = static_cast<std::size_t>(lanes<T>);
    std::vector<DirectionBlock<T>> blocks((directions.size() + width - 1) / width);
    for (std::size_t j = 0; j < blocks.size() * width; ++j) {
        const auto s = j < directions.size() ? directions[j] : glm::dvec3(0, 0, 1);
        EXPECTS(std::abs(glm::length(s) - 1) <= 1e-6);
        auto& block = blocks[j / width];
        block.x.at[j % width] = static_cast<T>(s.x);
        block.y.at[j % width] = static_cast<T>(s.y);
        block.z.at[j % width] = static_cast<T>(s.z);
    }
    return blocks;
}

template <class T>
void evaluate_blocks(int bands,
                     std::span<const DirectionBlock<T>> directions,
                     std::span<Line<T>> values,
                     InstructionSet set) {
    EXPECTS(bands >= 1 && bands <= most_unrolled_bands);
    EXPECTS(values.size() == directions.size() * static_cast<std::size_t>(bands * bands));
    if (!directions.empty())
        kernel<T>(set, bands)(directions.front().x.at, directions.size(),
                              polynomial_constants<T>(bands).data(), values.front().at);
}

template std::vector<DirectionBlock<float>> in_blocks(std::span<const glm::dvec3>);
template std::vector<DirectionBlock<double>> in_blocks(std::span<const glm::dvec3>);
template void evaluate_blocks(int,
                              std::span<const DirectionBlock<float>>,
                              std::span<Line<float>>,
                              InstructionSet);
template void evaluate_blocks(int,
                              std::span<const DirectionBlock<double>>,
                              std::span<Line<double>>,
                              InstructionSet);

} // namespace renderer::harmonics
