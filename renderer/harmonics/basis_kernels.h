// Evaluation of blocks of directions, for each number of bands and each set of instructions.
#pragma once

namespace renderer::harmonics {

constexpr int most_unrolled_bands = 10;

/// Directions of a block: each coordinate, and each value, is one line of cache and one register of
/// the widest kind.
template <class T>
constexpr int lanes = 64 / static_cast<int>(sizeof(T));

/// Takes blocks of directions (x of all, y of all, z of all), leaves blocks of values.  `constants`
/// are those of renderer/harmonics/basis_polynomials.h; memory is aligned to 64 bytes.
template <class T>
using BlockKernel =
    void (*)(const T* directions, unsigned long blocks, const T* constants, T* values);

/// [bands - 1].
struct BlockKernels {
    BlockKernel<double> in_double[most_unrolled_bands];
    BlockKernel<float> in_float[most_unrolled_bands];
};

extern const BlockKernels baseline_kernels; ///< for every processor of the kind
extern const BlockKernels avx2_kernels;
extern const BlockKernels avx512_kernels;

/// Blocks of one direction.
struct SingleKernels {
    BlockKernel<double> in_double[most_unrolled_bands];
};

extern const SingleKernels single_kernels;

} // namespace renderer::harmonics
