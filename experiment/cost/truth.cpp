// The study's own reference first, then what an earlier run has left, then the tracer.
#include "experiment/cost/truth.h"

#include "experiment/stimuli/lit_scene.h"
#include "experiment/stimuli/reference_file.h"
#include "experiment/stimuli/reference_recipe.h"
#include "renderer/cost/picture_error.h"
#include "renderer/expected.h"
#include "renderer/imaging/brightness.h"
#include "renderer/reference/convergence.h"

#include <fmt/format.h>

#include <chrono>
#include <system_error>

namespace experiment::cost {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;
namespace reference = renderer::reference;

using protocols::Scene;
using protocols::Study;
using protocols::Variant;
using renderer::Expected;

namespace {

constexpr std::uint64_t seed = 1;

fs::path file_in(const fs::path& folder, const Scene& scene, const Variant& variant) {
    const auto name = variant.id.value.empty() ? std::string("picture") : variant.id.value;
    return folder / scene.id.value / (name + ".exr");
}

bool is_there(const fs::path& file) {
    std::error_code ignored;
    return fs::exists(file, ignored);
}

Truth truth_from(const reference::Film& film, const std::string& origin) {
    Truth truth{.image = reference::picture(film), .words = {}};
    const auto mask = imaging::covered_pixels(truth.image.coverage);
    const auto halves = reference::halves(film);
    auto half_difference = truth.image;
    for (const auto i : mask) {
        const auto &a = halves.even.pixels[i], &b = halves.odd.pixels[i];
        const auto off = [](float x, float mean_a, float mean_b) {
            return x + (mean_a - mean_b) / 2;
        };
        const auto& x = truth.image.pixels[i];
        half_difference.pixels[i] = {off(x.r, a.r, b.r), off(x.g, a.g, b.g), off(x.b, a.b, b.b)};
    }
    truth.noise_floor = renderer::cost::relative_rms(half_difference, truth.image, mask);
    truth.words = fmt::format("{} x {} pixels, {} samples each, {}", film.width, film.height,
                              static_cast<std::uint64_t>(film.batches) << film.log2_batch, origin);
    return truth;
}

Expected<Truth> stored(const fs::path& file, const std::string& recipe, const Study& study) {
    return stimuli::film_to_go_on_with(file, recipe, study, seed).map([&](const auto& film) {
        return truth_from(film, "from " + file.string());
    });
}

Expected<Truth> traced(const Study& small,
                       const Scene& scene,
                       const Variant& variant,
                       const LoadedModel& model,
                       const fs::path& file,
                       const std::string& recipe,
                       double seconds,
                       const std::function<void(double)>& progress) {
    const auto lit = stimuli::lit_scene(small, scene, variant, model.mesh);
    if (!lit)
        return tl::unexpected(lit.error());
    const auto picture = reference::picture_of_scene(model.mesh, *lit);
    if (!picture)
        return tl::unexpected(picture.error());
    auto film = reference::blank_film(small.width, small.height, seed);
    reference::StopRule rule;
    rule.least_batches = 2; // what the time allows, with its error beside it
    rule.time_budget = std::chrono::duration<double>(seconds);
    const auto outcome =
        reference::render(*picture, film, rule, {},
                          [&](const reference::Progress& state) { progress(state.fraction); });
    if (!outcome)
        return tl::unexpected(outcome.error());
    std::error_code ignored; // what matters is whether the file can be written
    fs::create_directories(file.parent_path(), ignored);
    if (auto written = stimuli::write_reference(file, {film, recipe}); !written)
        return tl::unexpected(written.error());
    return truth_from(film, fmt::format("made in {:.0f} s", outcome->seconds));
}

} // namespace

Expected<std::optional<Truth>> truth_of(const Study& study,
                                        const Study& small,
                                        const Scene& scene,
                                        const Variant& variant,
                                        const LoadedModel& model,
                                        const TruthPlaces& places,
                                        const std::function<void(double)>& progress) {
    const auto found = [](Truth truth) { return std::optional(std::move(truth)); };
    const auto full = file_in(places.study.root / "reference", scene, variant);
    if (is_there(full))
        return stored(full, stimuli::reference_recipe(study, scene, variant, model.record, {}),
                      study)
            .map(found);
    const auto own = file_in(places.own, scene, variant);
    const auto recipe = stimuli::reference_recipe(small, scene, variant, model.record, {});
    if (is_there(own))
        return stored(own, recipe, small).map(found);
    if (places.seconds <= 0)
        return std::nullopt;
    return traced(small, scene, variant, model, own, recipe, places.seconds, progress).map(found);
}

} // namespace experiment::cost
