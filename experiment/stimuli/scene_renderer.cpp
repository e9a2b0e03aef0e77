// Every method is made from one subject, which hands out thickness fields that are traced once.
#include "experiment/stimuli/scene_renderer.h"

#include "experiment/materials.h"
#include "experiment/staging.h"
#include "experiment/stimuli/recipe.h"
#include "experiment/text_files.h"
#include "experiment/traced_fields.h"
#include "protocols/digest.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/image_files.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/picture.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace experiment::stimuli {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;
namespace methods = renderer::methods;

using protocols::Picture;
using protocols::Rendering;
template <class T>
using Expected = tl::expected<T, std::string>;

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
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
    SceneRenderer scene_renderer(study, scene, std::move(model), samples);
    const auto material = material_of(study, scene);
    if (!material)
        return tl::unexpected(fmt::format("no material \"{}\"", scene.material));
    scene_renderer.material_ = *material;
    if (auto prepared = scene_renderer.prepare_contenders(progress); !prepared)
        return tl::unexpected(prepared.error());
    return scene_renderer;
}

Expected<void> SceneRenderer::prepare_contenders(const std::function<void(double)>& progress) {
    auto surface = methods::Surface::upload(model_.mesh);
    if (!surface)
        return tl::unexpected(surface.error());
    TracedFields fields(model_, progress);
    const methods::Subject subject{
        .mesh = model_.mesh,
        .surface = *surface,
        .material = material_,
        .placement = seen().placement,
        .field = [&](const auto& options) { return fields.field(options); },
        .progress = progress};
    for (const auto& condition : study_->conditions) {
        const auto* rendering = std::get_if<Rendering>(&condition.source);
        if (rendering == nullptr)
            continue;
        const auto start = Clock::now();
        auto method = methods::prepare_method(rendering->method, rendering->dials, subject);
        if (!method)
            return tl::unexpected(
                fmt::format("condition \"{}\": {}", condition.id.value, method.error()));
        contenders_.push_back(
            {&condition, std::move(*method), seconds_since(start) + fields.take_seconds_saved()});
    }
    return {};
}

renderer::Scene SceneRenderer::seen() const {
    auto scene = staged(*scene_, renderer::geometry::bounding_sphere(model_.mesh),
                        static_cast<double>(study_->width) / study_->height);
    scene.material = material_;
    return scene;
}

renderer::Scene SceneRenderer::lit_by(const protocols::Variant& variant) const {
    auto scene = seen();
    scene.lights = lights_of(variant, scene.camera);
    return scene;
}

Expected<std::vector<SceneRenderer::Drawn>>
SceneRenderer::draw_all(const protocols::Variant& variant) {
    const auto scene = lit_by(variant);
    std::vector<Drawn> drawn;
    for (auto& contender : contenders_) {
        const auto start = Clock::now();
        auto image = methods::render_picture(*contender.method, scene, study_->width,
                                             study_->height, samples_);
        if (!image)
            return tl::unexpected(image.error());
        PictureRecord record;
        record.frame_milliseconds = 1000.0 * seconds_since(start) / samples_;
        record.dials = dials(std::get<Rendering>(contender.condition->source));
        record.width = study_->width;
        record.height = study_->height;
        record.model = model_.record;
        record.precompute_seconds = contender.precompute_seconds;
        record.bytes_per_vertex = contender.method->cost().bytes_per_vertex;
        drawn.push_back({{scene_->id, variant.id, contender.condition->id},
                         std::move(*image),
                         std::move(record)});
    }
    return drawn;
}

Expected<std::map<Picture, PictureRecord>> SceneRenderer::render(const protocols::Variant& variant,
                                                                 const StudyFolder& folder) {
    auto drawn = draw_all(variant);
    if (!drawn)
        return tl::unexpected(drawn.error());
    std::vector<imaging::NamedImage> pictures;
    for (const auto& one : *drawn)
        pictures.push_back({one.picture.condition.value, one.image});
    const auto mask = imaging::covered_pixels(drawn->front().image.coverage);
    const auto matches = imaging::match_brightness(pictures, mask);
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

} // namespace experiment::stimuli
