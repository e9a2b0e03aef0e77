// Every method is made from one subject, which hands out thickness fields that are traced once.
#include "experiment/stimuli/scene_renderer.h"

#include "experiment/reference_dials.h"
#include "experiment/stimuli/lit_scene.h"
#include "experiment/stimuli/recipe.h"
#include "experiment/text_files.h"
#include "experiment/traced_fields.h"
#include "protocols/digest.h"
#include "renderer/expected.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/image_files.h"
#include "renderer/methods/catalogue.h"
#include "renderer/pictures/choice_change.h"
#include "renderer/pictures/picture.h"
#include "renderer/stopwatch.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace experiment::stimuli {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;
namespace methods = renderer::methods;
namespace pictures = renderer::pictures;
namespace shading = renderer::shading;

using protocols::Picture;
using protocols::Rendering;
using renderer::Expected;

namespace {

renderer::LinearRgb colour_of(const std::array<double, 3>& rgb) {
    return {static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2])};
}

/// The scene with the coefficients that the condition has of its own there, if it has any.
renderer::Scene
as_shaded(renderer::Scene scene, const Rendering& rendering, const protocols::SceneId& id) {
    if (const auto own = rendering.k.find(id.value); own != rendering.k.end()) {
        auto& k = scene.material.reflectance;
        k.ambient = colour_of(own->second.ambient);
        k.diffuse = colour_of(own->second.diffuse);
        k.specular = colour_of(own->second.specular);
        k.scatter = colour_of(own->second.scatter);
    }
    return scene;
}

} // namespace

/// A picture as drawn, before its brightness is matched.
struct SceneRenderer::Drawn {
    Picture picture;
    imaging::LinearImage image;
    PictureRecord record;
};

fs::path png_file(const StudyFolder& folder, const Picture& picture) {
    return folder.stimuli() / (protocols::picture_path(picture) + ".png");
}

fs::path exr_file(const StudyFolder& folder, const Picture& picture) {
    return folder.stimuli() / (protocols::picture_path(picture) + ".exr");
}

Expected<SceneRenderer> SceneRenderer::prepare(const protocols::Study& study,
                                               const protocols::Scene& scene,
                                               LoadedModel model,
                                               int samples,
                                               const std::function<void(double)>& progress) {
    // Neighbours in one block of coefficients, and in one line of the cache.
    model.mesh = renderer::geometry::along_morton_curve(model.mesh);
    SceneRenderer scene_renderer(study, scene, std::move(model), samples);
    if (auto prepared = scene_renderer.prepare_contenders(progress); !prepared)
        return tl::unexpected(prepared.error());
    return scene_renderer;
}

Expected<void> SceneRenderer::prepare_contenders(const std::function<void(double)>& progress) {
    const auto seen = seen_scene(*study_, *scene_, model_.mesh);
    if (!seen)
        return tl::unexpected(seen.error());
    auto surface = shading::Surface::upload(model_.mesh);
    if (!surface)
        return tl::unexpected(surface.error());
    TracedFields fields(model_, progress);
    const methods::Subject subject{
        .mesh = model_.mesh,
        .surface = *surface,
        .material = seen->material,
        .placement = seen->placement,
        .field = [&](const auto& options) { return fields.field(options); },
        .progress = progress};
    for (const auto& condition : study_->conditions) {
        const auto* rendering = std::get_if<Rendering>(&condition.source);
        if (rendering == nullptr)
            continue;
        if (rendering->method == reference_method) {
            if (!is_closed_and_oriented(renderer::geometry::examine(model_.mesh)))
                return tl::unexpected(fmt::format("condition \"{}\": the reference walks in closed "
                                                  "surfaces only, and {} has holes",
                                                  condition.id.value, model_.record.file));
            contenders_.push_back({&condition, nullptr, {}});
            continue;
        }
        const renderer::Stopwatch watch;
        auto method = methods::prepare_method(rendering->method, rendering->dials, subject);
        if (!method)
            return tl::unexpected(
                fmt::format("condition \"{}\": {}", condition.id.value, method.error()));
        contenders_.push_back(
            {&condition, std::move(*method), fields.seconds_alone(watch.seconds())});
    }
    return {};
}

Expected<std::vector<SceneRenderer::Drawn>>
SceneRenderer::draw_all(const protocols::Variant& variant) {
    const auto scene = lit_scene(*study_, *scene_, variant, model_.mesh);
    if (!scene)
        return tl::unexpected(scene.error());
    std::vector<Drawn> drawn;
    for (auto& contender : contenders_) {
        auto one = contender.method != nullptr ? draw(contender, *scene)
                                               : draw_reference(*contender.condition, *scene);
        if (!one)
            return tl::unexpected(one.error());
        one->picture = {scene_->id, variant.id, contender.condition->id};
        one->record.dials = dials(std::get<Rendering>(contender.condition->source));
        one->record.width = study_->width;
        one->record.height = study_->height;
        one->record.model = model_.record;
        drawn.push_back(std::move(*one));
    }
    return drawn;
}

Expected<SceneRenderer::Drawn> SceneRenderer::draw(Contender& contender,
                                                   const renderer::Scene& scene) const {
    const auto shaded =
        as_shaded(scene, std::get<Rendering>(contender.condition->source), scene_->id);
    const renderer::Stopwatch watch;
    auto image = pictures::render_picture(*contender.method, shaded, study_->width, study_->height,
                                          samples_);
    if (!image)
        return tl::unexpected(image.error());
    PictureRecord record;
    record.frame_milliseconds = 1000.0 * watch.seconds() / samples_;
    record.precompute_seconds = contender.precompute_seconds;
    record.bytes_per_vertex = contender.method->cost().bytes_per_vertex;
    if (const auto decision = contender.method->decision(); !decision.empty())
        record.decision = decision;
    record.predicted_change = contender.method->predicted_change();
    const auto changed = pictures::measured_change(*contender.method, shaded, *image, samples_);
    if (!changed)
        return tl::unexpected(changed.error());
    record.measured_change = *changed;
    return Drawn{{}, std::move(*image), std::move(record)};
}

Expected<SceneRenderer::Drawn> SceneRenderer::draw_reference(const protocols::Condition& condition,
                                                             const renderer::Scene& scene) const {
    const renderer::Stopwatch watch;
    auto picture = renderer::reference::reference_picture(
        model_.mesh, scene, study_->width, study_->height,
        reference_run(std::get<Rendering>(condition.source).dials));
    if (!picture)
        return tl::unexpected(
            fmt::format("condition \"{}\": {}", condition.id.value, picture.error()));
    PictureRecord record;
    record.decision = fmt::format("{} samples, standard error {:.3g} % of the mean",
                                  picture->samples, 100 * picture->outcome.state.relative_error);
    record.frame_milliseconds = 1000.0 * watch.seconds();
    return Drawn{{}, std::move(picture->image), std::move(record)};
}

/// Brightness is that of the reference, where there is one.
std::optional<double> SceneRenderer::reference_mean(const std::vector<Drawn>& drawn,
                                                    std::span<const std::size_t> mask) const {
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (contenders_[i].method == nullptr && !mask.empty())
            return imaging::mean_luminance(drawn[i].image, mask);
    return std::nullopt;
}

/// Pixels that every picture covers wholly: the reference's samples lie elsewhere than OpenGL's.
std::vector<std::size_t> SceneRenderer::common_mask(const std::vector<Drawn>& drawn) {
    auto coverage = drawn.front().image.coverage;
    for (const auto& one : drawn)
        std::ranges::transform(coverage, one.image.coverage, coverage.begin(),
                               [](float a, float b) { return std::min(a, b); });
    return imaging::covered_pixels(coverage);
}

Expected<std::map<Picture, PictureRecord>> SceneRenderer::render(const protocols::Variant& variant,
                                                                 const StudyFolder& folder) {
    auto drawn = draw_all(variant);
    if (!drawn)
        return tl::unexpected(drawn.error());
    std::vector<imaging::NamedImage> pictures;
    for (const auto& one : *drawn)
        pictures.push_back({one.picture.condition.value, one.image});
    const auto mask = common_mask(*drawn);
    const auto matches = imaging::match_brightness(pictures, mask, reference_mean(*drawn, mask));
    if (!matches)
        return tl::unexpected(fmt::format("scene \"{}\", variant \"{}\": {}", scene_->id.value,
                                          variant.id.value, matches.error()));

    std::error_code failure;
    fs::create_directories(png_file(folder, drawn->front().picture).parent_path(), failure);
    if (failure)
        return tl::unexpected(
            fmt::format("{}: cannot be written: {}", folder.stimuli().string(), failure.message()));

    std::map<Picture, PictureRecord> records;
    for (std::size_t i = 0; i < drawn->size(); ++i) {
        auto& [picture, image, record] = (*drawn)[i];
        const auto& match = (*matches)[i];
        const auto png = png_file(folder, picture);
        const std::vector<imaging::TextEntry> texts{
            {"stimulus:id", protocols::picture_path(picture)},
            {"Software", PAIRLIGHT_PROGRAM_VERSION}};
        const auto encoded = imaging::encode_16bit(
            imaging::composite_over_grey(image, match.gain, study_->surround.code));
        const auto shown_mean =
            imaging::check_encoded_mean(picture.condition.value, encoded, mask, match.target);
        if (!shown_mean)
            return tl::unexpected(fmt::format("{}: {}", png.string(), shown_mean.error()));
        auto written = imaging::write_png(png, encoded, texts).and_then([&] {
            return imaging::write_exr(exr_file(folder, picture), image, texts);
        });
        if (!written)
            return tl::unexpected(written.error());
        const auto bytes = read_text_file(png);
        if (!bytes)
            return tl::unexpected(bytes.error());
        record.png_sha256 = protocols::sha256_hexadecimal(*bytes);
        record.brightness = {match.mean_before, match.target, match.gain, match.clipped_share};
        records.emplace(picture, std::move(record));
    }
    return records;
}

Expected<std::vector<Fit>>
SceneRenderer::fit(const std::vector<protocols::Variant>& variants,
                   const protocols::VariantId& held_out,
                   const std::map<protocols::VariantId, imaging::LinearImage>& targets) {
    std::vector<Fit> fits;
    for (auto& contender : contenders_) {
        if (contender.method == nullptr)
            continue;
        pictures::ReflectanceFit best;
        std::optional<pictures::LightPictures> test;
        for (const auto& variant : variants) {
            const auto scene = lit_scene(*study_, *scene_, variant, model_.mesh);
            if (!scene)
                return tl::unexpected(scene.error());
            auto terms = pictures::term_pictures(*contender.method, *scene, study_->width,
                                                 study_->height, samples_);
            if (!terms)
                return tl::unexpected(terms.error());
            pictures::LightPictures pictures{std::move(*terms), targets.at(variant.id)};
            if (variant.id == held_out)
                test = std::move(pictures);
            else if (auto added = best.add_training_light(pictures); !added)
                return tl::unexpected(
                    fmt::format("variant \"{}\": {}", variant.id.value, added.error()));
        }
        const auto result = best.best();
        Fit fit{scene_->id, contender.condition->id, result, {}};
        if (test) {
            const auto error = pictures::fit_error(result.reflectance, *test);
            if (!error)
                return tl::unexpected(error.error());
            fit.held_out_error = *error;
        }
        fits.push_back(std::move(fit));
    }
    return fits;
}

} // namespace experiment::stimuli
