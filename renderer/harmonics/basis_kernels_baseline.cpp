// Registers of 16 bytes, which the compiler builds from what there is; and single numbers.
#include "renderer/harmonics/basis_kernel.h"

namespace renderer::harmonics {

namespace {

template <int... Before>
constexpr SingleKernels singles_of(std::integer_sequence<int, Before...>) {
    return {{evaluate_blocks_of<double, 1, sizeof(double), Before + 1>...}};
}

} // namespace

constinit const BlockKernels baseline_kernels = kernels_of<16>(UnrolledBands{});
constinit const SingleKernels single_kernels = singles_of(UnrolledBands{});

} // namespace renderer::harmonics
