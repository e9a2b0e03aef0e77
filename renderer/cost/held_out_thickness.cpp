// The truth is traced once and serves all methods.
#include "renderer/cost/held_out_thickness.h"

#include "renderer/harmonics/directions.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace renderer::cost {

Expected<HeldOutThickness> HeldOutThickness::prepare(methods::Method& exact,
                                                     shading::Law law,
                                                     Scene scene,
                                                     int width,
                                                     int height,
                                                     int lights,
                                                     std::uint64_t seed) {
    HeldOutThickness held_out;
    held_out.law_ = law;
    held_out.width_ = width;
    held_out.height_ = height;
    scene.lights.resize(1);
    for (const auto& direction : harmonics::fibonacci_directions(lights, seed).directions) {
        scene.lights.front().place = DirectionalLight{direction};
        auto seen = seen_thickness(exact, law, scene, width, height);
        if (!seen)
            return tl::make_unexpected(seen.error());
        held_out.lit_.push_back({scene, std::move(*seen)});
    }
    return held_out;
}

Expected<double> HeldOutThickness::error_of(methods::Method& method) const {
    std::vector<double> test, truth;
    std::size_t unknown = 0;
    for (const auto& lit : lit_) {
        const auto seen = seen_thickness(method, law_, lit.scene, width_, height_);
        if (!seen)
            return tl::make_unexpected(seen.error());
        for (std::size_t i = 0; i < seen->size(); ++i)
            if ((*seen)[i] && lit.exact[i]) {
                test.push_back(*(*seen)[i]);
                truth.push_back(*lit.exact[i]);
                unknown += std::isfinite(test.back()) && std::isfinite(truth.back()) ? 0 : 1;
            }
    }
    if (test.empty())
        return tl::make_unexpected("no pixel shows its thickness, expected larger pictures");
    if (unknown > 0)
        return tl::make_unexpected(
            fmt::format("the thickness is no number at {} of {} pixels", unknown, test.size()));
    if (std::ranges::all_of(truth, [](double length) { return length == 0; }))
        return tl::make_unexpected("the exact thickness is 0 at every pixel");
    return relative_rms(test, truth);
}

} // namespace renderer::cost
