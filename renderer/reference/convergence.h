// When a picture is good enough, how long that takes, and the loop that waits for it.
#pragma once

#include "renderer/reference/path_tracer.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace renderer::reference {

/// A pixel is good when the 95 % half-width of its mean, in every channel, is at most `relative`
/// times the mean or `of_mean` times the mask's mean light, whichever is more; the picture when
/// `share` of the mask's pixels are.
struct StopRule {
    double relative = 0.005;
    double of_mean = 0.001;
    double share = 0.995;
    std::uint32_t least_batches = 16; ///< fewer say too little about their spread
    std::uint32_t most_batches = 1u << 20;
    std::optional<std::chrono::duration<double>> time_budget; ///< then the best so far
};

/// How far a film is.
struct Convergence {
    bool converged = false;
    double good_share = 0;     ///< of the mask's pixels
    double needed_batches = 0; ///< in all, predicted from the spread so far
    double relative_error = 0; ///< root mean square standard error over the mask's mean light
};

/// Errors: EXPECTS a mask and two batches.
Convergence judge(const Film& film, const std::vector<std::size_t>& mask, const StopRule& rule);

struct Progress {
    double fraction = 0; ///< of the predicted work, 0..1
    Convergence so_far;
};

struct Outcome {
    Convergence state;
    double seconds = 0;
    bool out_of_time = false;
};

/// Adds batches to `film` until the rule is met or its time or batches are used up; a film that has
/// some already is continued.  The mask is the pixels the body covers wholly.
/// Errors: no pixel wholly covered; more leaks than one path in 10^6, with their number.
Expected<Outcome> render(const Picture& picture,
                         Film& film,
                         const StopRule& rule = {},
                         const TracerTactics& tactics = {},
                         const std::function<void(const Progress&)>& progress = {});

} // namespace renderer::reference
