// Registers of 64 bytes.  Compiled with -mavx512f; called only where the processor has it.
#include "renderer/harmonics/basis_kernel.h"

namespace renderer::harmonics {

constinit const BlockKernels avx512_kernels = kernels_of<64>(UnrolledBands{});

} // namespace renderer::harmonics
