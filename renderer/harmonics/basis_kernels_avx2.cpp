// Registers of 32 bytes.  Compiled with -mavx2; called only where the processor has it.
#include "renderer/harmonics/basis_kernel.h"

namespace renderer::harmonics {

constinit const BlockKernels avx2_kernels = kernels_of<32>(UnrolledBands{});

} // namespace renderer::harmonics
