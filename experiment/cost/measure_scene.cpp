// Prepared one after the other, timed in turns, then compared light by light.
#include "experiment/cost/measure_scene.h"

#include "experiment/cost/choices.h"
#include "experiment/cost/lit_case.h"
#include "experiment/cost/picture_comparison.h"
#include "experiment/cost/preparation.h"
#include "experiment/cost/timing.h"
#include "experiment/stimuli/lit_scene.h"
#include "renderer/cost/held_out_thickness.h"
#include "renderer/expected.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/imaging/brightness.h"
#include "renderer/pictures/picture.h"

#include <fmt/format.h>

#include <utility>

namespace experiment::cost {

namespace methods = renderer::methods;
namespace pictures = renderer::pictures;
namespace shading = renderer::shading;

using protocols::Scene;
using protocols::Study;
using protocols::Variant;
using renderer::Expected;
using renderer::cost::HeldOutThickness;

namespace {

constexpr std::uint64_t held_out_seed = 2; // thickness is traced along directions of seed 1

/// The part of the whole that a step is, for its progress.
Reporting part_of(const Reporting& report, double from, double to) {
    return [&report, from, to](const std::string& what, double done) {
        report(what, from + (to - from) * done);
    };
}

class Measurement {
  public:
    Measurement(const SceneCase& measured, const Reporting& report)
        : measured_(measured), report_(report) {}

    Expected<SceneCost> carry_out();

  private:
    Expected<void> prepare_settings();
    Expected<void> light_the_scene();
    void compare_thickness();
    void compare_pictures();
    Expected<void> choose_points();

    Expected<HeldOutThickness> held_out_thickness(const Study& sized, std::uint64_t seed) const;
    Expected<double> law_error_at_full_size(methods::Method& method, const Variant& variant) const;
    Expected<double> error_at_full_size(std::size_t r, std::size_t light) const;

    methods::Method& method(std::size_t r) const { return *prepared_.contestants[r].method; }

    void remark(const std::string& text) { result_.remarks.push_back(text); }

    void not_known(std::size_t r, const std::string& what, const std::string& why) {
        remark(fmt::format("{}: no error of {}: {}", full_name(result_.rows[r]), what, why));
    }

    /// Before the row at which `done` of all rows are.
    static double share(std::size_t done, std::size_t all) {
        return static_cast<double>(done) / static_cast<double>(all);
    }

    const SceneCase& measured_;
    const Reporting& report_;
    SceneCost result_;
    Prepared prepared_;
    std::vector<Lit> lit_;
};

SceneCost about(const SceneCase& measured) {
    const auto& scene = measured.scene;
    const auto& record = measured.model.record;
    return {.id = scene.id.value,
            .label = scene.label.empty() ? scene.id.value : scene.label,
            .model = record.file,
            .vertices = record.vertices,
            .triangles = record.triangles,
            .frame_width = measured.study.width,
            .frame_height = measured.study.height,
            .lights = {},
            .rows = {},
            .remarks = {}};
}

Expected<SceneCost> Measurement::carry_out() {
    result_ = about(measured_);
    auto ready = prepare_settings()
                     .and_then([&] {
                         return time_frames(measured_, prepared_, result_.rows,
                                            part_of(report_, 0.45, 0.65));
                     })
                     .and_then([&] { return light_the_scene(); });
    if (!ready)
        return tl::unexpected(ready.error());
    compare_thickness();
    compare_pictures();
    if (auto chosen = choose_points(); !chosen)
        return tl::unexpected(chosen.error());
    report_("done", 1);
    return std::move(result_);
}

Expected<void> Measurement::prepare_settings() {
    auto prepared = prepare(measured_, part_of(report_, 0, 0.45),
                            [&](const std::string& text) { remark(text); });
    if (!prepared)
        return tl::unexpected(prepared.error());
    prepared_ = std::move(*prepared);
    for (const auto& contestant : prepared_.contestants)
        result_.rows.push_back(row_of(contestant));
    return {};
}

Expected<void> Measurement::light_the_scene() {
    auto lit = light_up(measured_, *prepared_.exact.method, part_of(report_, 0.65, 0.8));
    if (!lit)
        return tl::unexpected(lit.error());
    lit_ = std::move(*lit);
    for (const auto& light : lit_)
        result_.lights.push_back(light.about);
    return {};
}

/// Under light from all around that no variant has, and no coefficient was fitted to.
Expected<HeldOutThickness> Measurement::held_out_thickness(const Study& sized,
                                                           std::uint64_t seed) const {
    const auto law =
        measured_.options.sweep.law == "paper" ? shading::Law::Paper : shading::Law::Physical;
    return HeldOutThickness::prepare(*prepared_.exact.method, law, lit_.front().scene, sized.width,
                                     sized.height, measured_.options.held_out_lights, seed);
}

void Measurement::compare_thickness() {
    const auto held_out = held_out_thickness(measured_.small, held_out_seed);
    if (!held_out)
        return remark("no error of thickness: " + held_out.error());
    auto& rows = result_.rows;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        if (!prepared_.contestants[r].setting.method->scatters_by_thickness)
            continue;
        part_of(report_, 0.8, 0.87)("comparing thickness", share(r, rows.size()));
        if (const auto error = held_out->error_of(method(r)))
            rows[r].thickness = *error;
        else
            not_known(r, "thickness", error.error());
    }
}

void Measurement::compare_pictures() {
    const int samples = measured_.options.samples;
    auto& rows = result_.rows;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        part_of(report_, 0.87, 0.99)("comparing pictures", share(r, rows.size()));
        for (const auto& lit : lit_) {
            auto errors = compare_picture(method(r), lit, rows[r].dials.contains("law"), samples);
            if (!errors)
                not_known(r, "the picture " + lit.about.label, errors.error());
            rows[r].lights.push_back(errors ? std::move(*errors) : LightErrors());
        }
        const auto fitted = fitted_errors(method(r), lit_, samples);
        if (!fitted)
            not_known(r, "fitted pictures", fitted.error());
        else
            for (std::size_t i = 0; i < fitted->size(); ++i)
                rows[r].lights[i].fitted = (*fitted)[i];
    }
}

Expected<double> Measurement::law_error_at_full_size(methods::Method& method,
                                                     const Variant& variant) const {
    const auto& study = measured_.study;
    const auto scene = stimuli::lit_scene(study, measured_.scene, variant, measured_.model.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    const auto draw = [&](methods::Method& drawn) {
        return pictures::render_picture(drawn, *scene, study.width, study.height,
                                        2 * measured_.options.samples);
    };
    const auto exact = draw(*prepared_.exact.method);
    if (!exact)
        return tl::unexpected(exact.error());
    const auto image = draw(method);
    if (!image)
        return tl::unexpected(image.error());
    return renderer::cost::relative_error(*image, *exact,
                                          renderer::imaging::covered_pixels(exact->coverage));
}

/// At the size and with twice the samples of the study's pictures; thickness under other lights
/// once more.  Another path-traced picture there is not.
Expected<double> Measurement::error_at_full_size(std::size_t r, std::size_t light) const {
    if (measured_.options.wish.error == ErrorKind::Law)
        return law_error_at_full_size(method(r), measured_.variants[light]);
    return held_out_thickness(measured_.study, held_out_seed + 1)
        .and_then([&](const auto& held_out) { return held_out.error_of(method(r)); });
}

Expected<void> Measurement::choose_points() {
    const auto& wish = measured_.options.wish;
    for (std::size_t i = 0; i < lit_.size(); ++i) {
        auto& choice = result_.lights[i].choice;
        choice = choose(result_, i, wish);
        if (!choice || (wish.error != ErrorKind::Law && wish.error != ErrorKind::Thickness))
            continue;
        const auto measured = error_at_full_size(choice->row, i);
        if (!measured)
            return tl::unexpected(measured.error());
        choice->measured = *measured;
    }
    return {};
}

} // namespace

Expected<SceneCost> measure_scene(const Study& study,
                                  const Scene& scene,
                                  const std::vector<Variant>& variants,
                                  LoadedModel model,
                                  const MeasureOptions& options,
                                  const Reporting& report) {
    model.mesh = renderer::geometry::along_morton_curve(model.mesh);
    const SceneCase measured{.study = study,
                             .small = at_size(study, options.size),
                             .scene = scene,
                             .variants = variants,
                             .model = model,
                             .options = options};
    return Measurement(measured, report).carry_out();
}

} // namespace experiment::cost
