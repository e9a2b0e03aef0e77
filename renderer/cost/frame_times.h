// What a frame takes, methods in turns, so that the machine's moods meet all of them.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/target.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"

#include <functional>
#include <span>
#include <vector>

namespace renderer::cost {

/// A method and how it is asked to draw.
struct Turn {
    methods::Method* method = nullptr;
    bool light_moves = true; ///< a degree a frame around the body; else it rests
};

struct TurnOptions {
    int rounds = 7;
    int frames = 4;      ///< of a turn
    double slow = 0.3;   ///< seconds: whoever takes longer for a frame draws one frame a turn ...
    int slow_rounds = 2; ///< ... and in the first rounds only
};

/// Seconds of one frame, one value a round, by the clock and of the processor (all threads).
struct FrameTimes {
    std::vector<double> clock, processor;
};

/// All turns, round after round, each round beginning with the next one.  Before the first round
/// everybody draws a frame that does not count: it compiles shaders.
/// The frames are drawn into `target`, under the first light of `scene`.
/// Errors: those of the methods' `update`; OpenGL's own.
Expected<std::vector<FrameTimes>> take_turns(std::span<const Turn> turns,
                                             const Scene& scene,
                                             const gpu::Target& target,
                                             const TurnOptions& options = {},
                                             const std::function<void(double)>& progress = {});

/// Of all threads of this process.
double processor_seconds();

} // namespace renderer::cost
