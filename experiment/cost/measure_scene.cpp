// Prepared one after the other, timed in turns, then compared light by light.
#include "experiment/cost/measure_scene.h"

#include "experiment/cost/choices.h"
#include "experiment/cost/contestants.h"
#include "experiment/cost/shared_transfers.h"
#include "experiment/stimuli/lit_scene.h"
#include "experiment/traced_fields.h"
#include "renderer/cost/frame_times.h"
#include "renderer/cost/picture_error.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/harmonics/directions.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/errors.h"
#include "renderer/imaging/flip.h"
#include "renderer/methods/body_radiance.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/choice_change.h"
#include "renderer/methods/fitting.h"
#include "renderer/methods/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>

namespace experiment::cost {

namespace imaging = renderer::imaging;
namespace methods = renderer::methods;

using imaging::LinearImage;
using protocols::Scene;
using protocols::Study;
using protocols::Variant;
using renderer::LinearRgb;
template <class T>
using Expected = tl::expected<T, std::string>;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::uint64_t held_out_seed = 2; // thickness is traced along directions of seed 1

Study at_size(Study study, int longer_edge) {
    const double scale =
        std::min(1.0, static_cast<double>(longer_edge) / std::max(study.width, study.height));
    study.width = std::max(1, static_cast<int>(std::lround(scale * study.width)));
    study.height = std::max(1, static_cast<int>(std::lround(scale * study.height)));
    return study;
}

/// A light of the scene with what its pictures are compared with.
struct Lit {
    renderer::Scene scene;
    int width = 0, height = 0;
    LinearImage exact; ///< the same law with traced thickness
    std::optional<Truth> truth;
    std::vector<std::size_t> mask;
};

LinearImage sum_of(const std::array<LinearImage, 4>& terms, const renderer::Reflectance& k) {
    auto sum = terms[0];
    const std::array<LinearRgb, 4> weights{k.ambient, k.diffuse, k.specular, k.scatter};
    for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
        LinearRgb light{};
        for (std::size_t t = 0; t < terms.size(); ++t) {
            const auto& p = terms[t].pixels[i];
            light = {light.r + weights[t].r * p.r, light.g + weights[t].g * p.g,
                     light.b + weights[t].b * p.b};
        }
        sum.pixels[i] = light;
    }
    return sum;
}

double
mean_flip(const LinearImage& test, const LinearImage& truth, const std::vector<std::size_t>& mask) {
    const auto flip = imaging::ldr_flip(test, truth, imaging::default_pixels_per_degree);
    double sum = 0;
    for (const auto i : mask)
        sum += static_cast<double>(flip.values[i]);
    return sum / static_cast<double>(mask.size());
}

/// In this order one traced field serves whoever wants as many bands or fewer.
std::vector<std::size_t> most_bands_first(const std::vector<Setting>& settings) {
    std::vector<std::size_t> order(settings.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto bands = [&](std::size_t i) {
        const auto found = settings[i].dials.find("bands");
        const auto* number =
            found == settings[i].dials.end() ? nullptr : std::get_if<std::int64_t>(&found->second);
        return number == nullptr ? std::int64_t{0} : *number;
    };
    std::ranges::stable_sort(order, std::ranges::greater(), bands);
    return order;
}

class Measurement {
  public:
    Measurement(const Study& study,
                const Scene& scene,
                const std::vector<Variant>& variants,
                LoadedModel model,
                const MeasureOptions& options,
                const Reporting& report)
        : study_(study), small_(at_size(study, options.size)), scene_(scene), variants_(variants),
          model_(std::move(model)), options_(options), report_(report) {}

    Expected<SceneCost> carry_out();

  private:
    Expected<void> prepare();
    Expected<void> time_frames();
    Expected<void> light_up();
    Expected<void> compare_thickness();
    Expected<void> compare_pictures();
    Expected<void> choose_points();

    Expected<void> compare_pictures_of(std::size_t r);
    Expected<LightErrors> errors_of(methods::Method& method, const Lit& lit, bool has_law);
    Expected<void> add_fitted(methods::Method& method, Row& row);
    Expected<double> error_at_full_size(std::size_t r, std::size_t light);
    Expected<double> law_error_at_full_size(std::size_t r, const Variant& variant);
    Expected<double> thickness_error(std::size_t r, int width, int height, std::uint64_t seed);

    bool has_law(std::size_t r) const { return result_.rows[r].dials.contains("law"); }

    methods::Law law() const {
        return options_.law == "paper" ? methods::Law::Paper : methods::Law::Physical;
    }

    void remark(const std::string& text) { result_.remarks.push_back(text); }

    void report(const std::string& what, double from, double to, double done) const {
        report_(what, from + (to - from) * done);
    }

    const Study& study_;
    Study small_;
    const Scene& scene_;
    const std::vector<Variant>& variants_;
    LoadedModel model_;
    const MeasureOptions& options_;
    const Reporting& report_;
    SceneCost result_;
    std::vector<Contestant> contestants_;
    Contestant exact_, bare_; ///< what the others are measured by
    std::vector<Lit> lit_;
};

Expected<SceneCost> Measurement::carry_out() {
    model_.mesh = renderer::geometry::along_morton_curve(model_.mesh);
    result_ = {.id = scene_.id.value,
               .label = scene_.label.empty() ? scene_.id.value : scene_.label,
               .model = model_.record.file,
               .vertices = model_.record.vertices,
               .triangles = model_.record.triangles,
               .frame_width = study_.width,
               .frame_height = study_.height,
               .lights = {},
               .rows = {},
               .remarks = {}};
    auto done = prepare()
                    .and_then([&] { return time_frames(); })
                    .and_then([&] { return light_up(); })
                    .and_then([&] { return compare_thickness(); })
                    .and_then([&] { return compare_pictures(); })
                    .and_then([&] { return choose_points(); });
    if (!done)
        return tl::unexpected(done.error());
    for (const auto& text : model_.remarks)
        remark(text);
    return std::move(result_);
}

Expected<void> Measurement::prepare() {
    const auto settings = settings_of(options_.methods, options_.law, options_.presets_only);
    if (!settings)
        return tl::unexpected(settings.error());
    const auto seen = stimuli::seen_scene(study_, scene_, model_.mesh);
    if (!seen)
        return tl::unexpected(seen.error());
    const auto surface = methods::Surface::upload(model_.mesh);
    if (!surface)
        return tl::unexpected(surface.error());
    TracedFields fields(model_, {}, FieldsKept::Nowhere);
    SharedTransfers transfers(model_.mesh, seen->material.medium,
                              methods::mm_per_unit(seen->placement));
    const methods::Subject subject{
        .mesh = model_.mesh,
        .surface = *surface,
        .material = seen->material,
        .placement = seen->placement,
        .field = [&](const auto& asked) { return fields.field(asked); },
        .progress = {},
        .transfer = [&](const auto& asked) { return transfers.field(asked); }};
    const auto make = [&](const Setting& setting) -> Expected<Contestant> {
        const auto start = Clock::now();
        auto method = setting.method->prepare(setting.dials, subject);
        const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
        const auto alone = fields.seconds_alone(elapsed + transfers.seconds_saved());
        if (!method)
            return tl::unexpected(method.error());
        return Contestant{setting, std::move(*method), alone};
    };
    for (auto* base : {&exact_, &bare_}) {
        auto made = make(preset_of(base == &exact_ ? methods::exact_method : methods::bare_method,
                                   options_.law));
        if (!made)
            return tl::unexpected(made.error());
        *base = std::move(*made);
    }
    std::vector<std::optional<Contestant>> made(settings->size());
    std::size_t done = 0;
    for (const auto i : most_bands_first(*settings)) {
        const auto& setting = (*settings)[i];
        report("preparing " + setting.method->name, 0, 0.45,
               static_cast<double>(done++) / static_cast<double>(settings->size()));
        if (auto contestant = make(setting))
            made[i] = std::move(*contestant);
        else
            remark(fmt::format("{} {}: not measured: {}", setting.method->label, setting.words,
                               contestant.error()));
    }
    for (auto& contestant : made)
        if (contestant) {
            result_.rows.push_back(row_of(*contestant));
            contestants_.push_back(std::move(*contestant));
        }
    return {};
}

Expected<void> Measurement::time_frames() {
    auto scene = stimuli::lit_scene(study_, scene_, variants_.front(), model_.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    scene->lights.resize(1); // one light is what the moving one is measured with
    const auto target = renderer::gpu::Target::create(study_.width, study_.height);
    if (!target)
        return tl::unexpected(target.error());
    std::vector<renderer::cost::Turn> turns{{bare_.method.get(), true}};
    for (const auto& contestant : contestants_)
        for (const bool moves : {true, false})
            turns.push_back({contestant.method.get(), moves});
    const auto times = renderer::cost::take_turns(
        turns, *scene, *target, {.rounds = options_.rounds},
        [&](double done) { report("drawing frames in turns", 0.45, 0.65, done); });
    if (!times)
        return tl::unexpected(times.error());
    const auto milliseconds = [](renderer::cost::Spread s) {
        return renderer::cost::Spread{1000 * s.lower, 1000 * s.median, 1000 * s.upper};
    };
    const auto chosen = [&](const renderer::cost::FrameTimes& time) -> const std::vector<double>& {
        return options_.by_processor ? time.processor : time.clock;
    };
    for (std::size_t r = 0; r < contestants_.size(); ++r) {
        const auto& moving = (*times)[1 + 2 * r];
        auto& row = result_.rows[r];
        row.frame_ms = milliseconds(renderer::cost::spread_of(chosen(moving)));
        row.resting_ms = milliseconds(renderer::cost::spread_of(chosen((*times)[2 + 2 * r])));
        row.to_bare = renderer::cost::spread_of(
            renderer::cost::ratios(chosen(moving), chosen(times->front())));
        row.clock_ms = 1000 * renderer::cost::quantile(moving.clock, 0.5);
        const auto cost = contestants_[r].method->cost();
        row.bytes_per_vertex = cost.bytes_per_vertex;
        row.bytes_per_light = cost.bytes_per_light;
    }
    return {};
}

/// The exact picture and the path-traced one of every light.
Expected<void> Measurement::light_up() {
    for (std::size_t i = 0; i < variants_.size(); ++i) {
        const auto& variant = variants_[i];
        auto truth =
            truth_of(study_, small_, scene_, variant, model_, options_.truth, [&](double done) {
                report("following light", 0.65, 0.8,
                       (static_cast<double>(i) + done) / static_cast<double>(variants_.size()));
            });
        if (!truth)
            return tl::unexpected(truth.error());
        Lit lit{.scene = {},
                .width = *truth ? (*truth)->image.width : small_.width,
                .height = *truth ? (*truth)->image.height : small_.height,
                .exact = {},
                .truth = std::move(*truth),
                .mask = {}};
        const auto& sized = lit.width == study_.width ? study_ : small_;
        auto scene = stimuli::lit_scene(sized, scene_, variant, model_.mesh);
        if (!scene)
            return tl::unexpected(scene.error());
        lit.scene = std::move(*scene);
        auto exact = methods::render_picture(*exact_.method, lit.scene, lit.width, lit.height,
                                             options_.samples);
        if (!exact)
            return tl::unexpected(exact.error());
        lit.exact = std::move(*exact);
        auto coverage = lit.exact.coverage;
        if (lit.truth)
            std::ranges::transform(coverage, lit.truth->image.coverage, coverage.begin(),
                                   [](float a, float b) { return std::min(a, b); });
        lit.mask = imaging::covered_pixels(coverage);
        if (lit.mask.empty())
            return tl::unexpected(fmt::format("scene \"{}\": the object covers no pixel wholly, "
                                              "expected larger pictures (--size)",
                                              scene_.id.value));
        result_.lights.push_back(
            {.id = variant.id.value,
             .label = variant.label.empty() ? variant.id.value : variant.label,
             .width = lit.width,
             .height = lit.height,
             .noise_floor = lit.truth ? std::optional(lit.truth->noise_floor) : std::nullopt,
             .reference = lit.truth ? lit.truth->words : "",
             .choice = {}});
        lit_.push_back(std::move(lit));
    }
    return {};
}

/// Under light from all around that no variant has, and no coefficient was fitted to.
Expected<double>
Measurement::thickness_error(std::size_t r, int width, int height, std::uint64_t seed) {
    const auto held_out =
        renderer::harmonics::fibonacci_directions(options_.held_out_lights, seed).directions;
    auto scene = lit_.front().scene;
    scene.lights.resize(1);
    std::vector<double> seen, exact;
    for (const auto& direction : held_out) {
        scene.lights.front().place = renderer::DirectionalLight{direction};
        const auto a =
            renderer::cost::seen_thickness(*contestants_[r].method, law(), scene, width, height);
        if (!a)
            return tl::unexpected(a.error());
        const auto b = renderer::cost::seen_thickness(*exact_.method, law(), scene, width, height);
        if (!b)
            return tl::unexpected(b.error());
        for (std::size_t i = 0; i < a->size(); ++i)
            if (!std::isnan((*a)[i]) && !std::isnan((*b)[i])) {
                seen.push_back((*a)[i]);
                exact.push_back((*b)[i]);
            }
    }
    return renderer::cost::relative_rms(seen, exact);
}

Expected<void> Measurement::compare_thickness() {
    for (std::size_t r = 0; r < contestants_.size(); ++r) {
        if (!contestants_[r].setting.method->scatters_by_thickness)
            continue;
        report("comparing thickness", 0.8, 0.87,
               static_cast<double>(r) / static_cast<double>(contestants_.size()));
        const auto error = thickness_error(r, small_.width, small_.height, held_out_seed);
        if (!error) {
            remark("no error of thickness: " + error.error());
            break;
        }
        result_.rows[r].thickness = *error;
    }
    return {};
}

Expected<LightErrors>
Measurement::errors_of(methods::Method& method, const Lit& lit, bool has_law) {
    const auto image =
        methods::render_picture(method, lit.scene, lit.width, lit.height, options_.samples);
    if (!image)
        return tl::unexpected(image.error());
    LightErrors errors;
    errors.decision = method.decision();
    errors.predicted_change = method.predicted_change();
    const auto changed = methods::measured_change(method, lit.scene, *image, options_.samples);
    if (!changed)
        return tl::unexpected(changed.error());
    errors.measured_change = *changed;
    if (has_law)
        errors.law = renderer::cost::relative_rms(*image, lit.exact, lit.mask);
    if (!lit.truth)
        return errors;
    const auto& truth = lit.truth->image;
    errors.as_drawn = renderer::cost::relative_rms(*image, truth, lit.mask);
    const auto gain = imaging::brightness_gain(*image, truth, lit.mask);
    if (!gain)
        return tl::unexpected(gain.error());
    const auto bright = imaging::brightened(*image, *gain);
    errors.reference = renderer::cost::relative_rms(bright, truth, lit.mask);
    errors.flip = mean_flip(bright, truth, lit.mask);
    return errors;
}

/// One set of coefficients for all lights of the scene together.
Expected<void> Measurement::add_fitted(methods::Method& method, Row& row) {
    if (std::ranges::any_of(lit_, [](const Lit& lit) { return !lit.truth; }))
        return {};
    std::vector<std::array<LinearImage, 4>> terms;
    methods::ReflectanceFit fit;
    for (const auto& lit : lit_) {
        auto drawn =
            methods::term_pictures(method, lit.scene, lit.width, lit.height, options_.samples);
        if (!drawn)
            return tl::unexpected(drawn.error());
        if (auto added = fit.add_training_light({*drawn, lit.truth->image}); !added)
            return added;
        terms.push_back(std::move(*drawn));
    }
    const auto best = fit.best().reflectance;
    for (std::size_t i = 0; i < lit_.size(); ++i) {
        const auto image = sum_of(terms[i], best);
        const auto& truth = lit_[i].truth->image;
        const auto gain = imaging::brightness_gain(image, truth, lit_[i].mask);
        if (!gain)
            return tl::unexpected(gain.error());
        row.lights[i].fitted =
            renderer::cost::relative_rms(imaging::brightened(image, *gain), truth, lit_[i].mask);
    }
    return {};
}

Expected<void> Measurement::compare_pictures_of(std::size_t r) {
    auto& method = *contestants_[r].method;
    auto& row = result_.rows[r];
    for (const auto& lit : lit_) {
        auto errors = errors_of(method, lit, has_law(r));
        if (!errors)
            return tl::unexpected(errors.error());
        row.lights.push_back(std::move(*errors));
    }
    return add_fitted(method, row);
}

Expected<void> Measurement::compare_pictures() {
    for (std::size_t r = 0; r < contestants_.size(); ++r) {
        report("comparing pictures", 0.87, 0.99,
               static_cast<double>(r) / static_cast<double>(contestants_.size()));
        if (auto done = compare_pictures_of(r); !done)
            return tl::unexpected(fmt::format("{}: {}", full_name(result_.rows[r]), done.error()));
    }
    return {};
}

Expected<double> Measurement::law_error_at_full_size(std::size_t r, const Variant& variant) {
    const auto scene = stimuli::lit_scene(study_, scene_, variant, model_.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    const auto draw = [&](const Contestant& contestant) {
        return methods::render_picture(*contestant.method, *scene, study_.width, study_.height,
                                       2 * options_.samples);
    };
    const auto exact = draw(exact_);
    if (!exact)
        return tl::unexpected(exact.error());
    const auto image = draw(contestants_[r]);
    if (!image)
        return tl::unexpected(image.error());
    return renderer::cost::relative_rms(*image, *exact, imaging::covered_pixels(exact->coverage));
}

/// At the size and with twice the samples of the study's pictures; thickness under other lights
/// once more.  Another path-traced picture there is not.
Expected<double> Measurement::error_at_full_size(std::size_t r, std::size_t light) {
    return options_.wish.error == ErrorKind::Law
               ? law_error_at_full_size(r, variants_[light])
               : thickness_error(r, study_.width, study_.height, held_out_seed + 1);
}

Expected<void> Measurement::choose_points() {
    const auto kind = options_.wish.error;
    for (std::size_t i = 0; i < lit_.size(); ++i) {
        auto& choice = result_.lights[i].choice;
        choice = choose(result_, i, options_.wish);
        if (!choice || (kind != ErrorKind::Law && kind != ErrorKind::Thickness))
            continue;
        const auto measured = error_at_full_size(choice->row, i);
        if (!measured)
            return tl::unexpected(measured.error());
        choice->measured = *measured;
    }
    report("done", 0, 1, 1);
    return {};
}

} // namespace

Expected<SceneCost> measure_scene(const Study& study,
                                  const Scene& scene,
                                  const std::vector<Variant>& variants,
                                  LoadedModel model,
                                  const MeasureOptions& options,
                                  const Reporting& report) {
    return Measurement(study, scene, variants, std::move(model), options, report).carry_out();
}

} // namespace experiment::cost
