// Loops over blocks of independent work on all threads, which say how far they are and can be
// stopped.
#pragma once

#include <cstddef>
#include <functional>

namespace renderer::diffusion {

/// Calls `work(begin, end)` for blocks of at most `per_block` that together make 0..count, on all
/// threads and in no order, and `progress(fraction)` after each, by one thread at a time.
/// Returns false when progress did: then some blocks were left out.
bool for_each_block(std::size_t count,
                    std::size_t per_block,
                    const std::function<bool(double)>& progress,
                    const std::function<void(std::size_t begin, std::size_t end)>& work);

} // namespace renderer::diffusion
