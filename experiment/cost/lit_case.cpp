// Pictures are as large as the path-traced one, which may be there at the study's size.
#include "experiment/cost/lit_case.h"

#include "experiment/stimuli/lit_scene.h"
#include "renderer/expected.h"
#include "renderer/imaging/brightness.h"
#include "renderer/pictures/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace experiment::cost {

namespace imaging = renderer::imaging;
namespace methods = renderer::methods;
namespace pictures = renderer::pictures;

using renderer::Expected;

namespace {

std::vector<std::size_t> pixels_of_both(const imaging::LinearImage& exact,
                                        const std::optional<Truth>& truth) {
    auto coverage = exact.coverage;
    if (truth)
        std::ranges::transform(coverage, truth->image.coverage, coverage.begin(),
                               [](float a, float b) { return std::min(a, b); });
    return imaging::covered_pixels(coverage);
}

LightCase words_of(const protocols::Variant& variant, const Lit& lit) {
    return {.id = variant.id.value,
            .label = variant.label.empty() ? variant.id.value : variant.label,
            .width = lit.width,
            .height = lit.height,
            .noise_floor = lit.truth ? std::optional(lit.truth->noise_floor) : std::nullopt,
            .reference = lit.truth ? lit.truth->words : "",
            .choice = {}};
}

Expected<Lit> lit_by(const SceneCase& measured,
                     const protocols::Variant& variant,
                     methods::Method& exact,
                     std::optional<Truth> truth) {
    Lit lit;
    lit.truth = std::move(truth);
    lit.width = lit.truth ? lit.truth->image.width : measured.small.width;
    lit.height = lit.truth ? lit.truth->image.height : measured.small.height;
    const auto& sized = lit.width == measured.study.width ? measured.study : measured.small;
    auto scene = stimuli::lit_scene(sized, measured.scene, variant, measured.model.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    lit.scene = std::move(*scene);
    auto drawn =
        pictures::render_picture(exact, lit.scene, lit.width, lit.height, measured.options.samples);
    if (!drawn)
        return tl::unexpected(drawn.error());
    lit.exact = std::move(*drawn);
    lit.mask = pixels_of_both(lit.exact, lit.truth);
    if (lit.mask.empty())
        return tl::unexpected(fmt::format("scene \"{}\": the object covers no pixel wholly, "
                                          "expected larger pictures (--size)",
                                          measured.scene.id.value));
    lit.about = words_of(variant, lit);
    return lit;
}

} // namespace

Expected<std::vector<Lit>>
light_up(const SceneCase& measured, methods::Method& exact, const Reporting& report) {
    std::vector<Lit> all;
    for (const auto& variant : measured.variants) {
        auto truth = truth_of(measured.study, measured.small, measured.scene, variant,
                              measured.model, measured.options.truth, [&](double done) {
                                  report("following light",
                                         (static_cast<double>(all.size()) + done) /
                                             static_cast<double>(measured.variants.size()));
                              });
        if (!truth)
            return tl::unexpected(truth.error());
        auto lit = lit_by(measured, variant, exact, std::move(*truth));
        if (!lit)
            return tl::unexpected(lit.error());
        all.push_back(std::move(*lit));
    }
    return all;
}

} // namespace experiment::cost
