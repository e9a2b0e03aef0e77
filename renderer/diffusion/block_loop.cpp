// Blocks by oneTBB.
#include "renderer/diffusion/block_loop.h"

#include "renderer/contract.h"
#include "renderer/geometry/ray_scene.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace renderer::diffusion {

bool for_each_block(std::size_t count,
                    std::size_t per_block,
                    const std::function<bool(double)>& progress,
                    const std::function<void(std::size_t, std::size_t)>& work) {
    EXPECTS(per_block >= 1);
    std::atomic<bool> stopped{false};
    std::mutex mutex;
    std::size_t finished = 0;
    const std::size_t blocks = (count + per_block - 1) / per_block;
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        if (stopped)
            return;
        // far ends of exponentials, and Embree, are slow with denormals
        const geometry::DenormalsAreZero guard;
        const std::size_t begin = block * per_block, end = std::min(count, begin + per_block);
        work(begin, end);
        const std::lock_guard lock(mutex);
        finished += end - begin;
        if (progress && !stopped &&
            !progress(static_cast<double>(finished) / static_cast<double>(count)))
            stopped = true;
    });
    return !stopped;
}

} // namespace renderer::diffusion
