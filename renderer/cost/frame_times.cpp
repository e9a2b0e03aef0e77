// Everybody waits for the last pixel of a frame before the next begins.
#include "renderer/cost/frame_times.h"

#include "renderer/gpu/context.h"
#include "renderer/stopwatch.h"
#include "renderer/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>

namespace renderer::cost {

namespace {

struct Seconds {
    double clock = 0, processor = 0;
};

void move_light(Scene& scene, int frame) {
    const double angle = from_degrees(frame).value;
    scene.lights.front().place = DirectionalLight{{std::sin(angle), 0.3, -std::cos(angle)}};
}

Expected<void> draw_frame(const Turn& turn, const Scene& scene) {
    if (auto ready = turn.method->update(scene); !ready)
        return ready;
    turn.method->draw(scene);
    gpu::finish();
    return {};
}

/// Of one frame.  The first is drawn before the clock starts: it takes up what others have changed.
Expected<Seconds> seconds_of_a_frame(const Turn& turn, Scene scene, int first_frame, int frames) {
    if (turn.light_moves)
        move_light(scene, first_frame - 1);
    if (const auto drawn = draw_frame(turn, scene); !drawn)
        return tl::unexpected(drawn.error());
    const Stopwatch watch;
    const double processor = processor_seconds();
    for (int i = 0; i < frames; ++i) {
        if (turn.light_moves)
            move_light(scene, first_frame + i);
        if (const auto drawn = draw_frame(turn, scene); !drawn)
            return tl::unexpected(drawn.error());
    }
    return Seconds{watch.seconds() / frames, (processor_seconds() - processor) / frames};
}

} // namespace

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

Expected<std::vector<FrameTimes>> take_turns(std::span<const Turn> turns,
                                             const Scene& scene,
                                             const gpu::Target& target,
                                             const TurnOptions& options,
                                             const std::function<void(double)>& progress) {
    std::vector<FrameTimes> times(turns.size());
    std::vector<bool> is_slow(turns.size(), false);
    const auto drawing = target.draw_into();
    for (int round = -1; round < options.rounds; ++round)
        for (std::size_t i = 0; i < turns.size(); ++i) {
            const auto k = (i + static_cast<std::size_t>(round + 1)) % turns.size();
            if (is_slow[k] && round >= options.slow_rounds)
                continue;
            target.clear();
            const int frames = round < 0 || is_slow[k] ? 1 : options.frames;
            const auto seconds = seconds_of_a_frame(turns[k], scene, 7 * (round + 1), frames);
            if (!seconds)
                return tl::unexpected(seconds.error());
            if (round < 0) {
                is_slow[k] = seconds->clock > options.slow;
            } else {
                times[k].clock.push_back(seconds->clock);
                times[k].processor.push_back(seconds->processor);
            }
            if (progress)
                progress(
                    (round + 1 + static_cast<double>(i + 1) / static_cast<double>(turns.size())) /
                    (options.rounds + 1));
        }
    if (auto good = gpu::check("timing frames"); !good)
        return tl::unexpected(good.error());
    return times;
}

} // namespace renderer::cost
