// What can be had by more or less light is not an error: path-traced pictures are met at equal
// brightness.
#include "experiment/cost/picture_comparison.h"

#include "renderer/cost/picture_error.h"
#include "renderer/expected.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/errors.h"
#include "renderer/imaging/flip.h"
#include "renderer/pictures/choice_change.h"
#include "renderer/pictures/fitting.h"
#include "renderer/pictures/picture.h"

#include <algorithm>
#include <array>
#include <utility>

namespace experiment::cost {

namespace imaging = renderer::imaging;
namespace methods = renderer::methods;
namespace pictures = renderer::pictures;

using imaging::LinearImage;
using renderer::Expected;
using renderer::LinearRgb;
using renderer::cost::relative_error;

namespace {

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

Expected<LinearImage> as_bright_as_truth(const LinearImage& image, const Lit& lit) {
    const auto gain = imaging::brightness_gain(image, lit.truth->image, lit.mask);
    if (!gain)
        return tl::unexpected(gain.error());
    return imaging::brightened(image, *gain);
}

/// `as_drawn`, `reference` and `flip`.
Expected<void> compare_with_truth(const LinearImage& image, const Lit& lit, LightErrors& errors) {
    const auto& truth = lit.truth->image;
    const auto as_drawn = relative_error(image, truth, lit.mask);
    if (!as_drawn)
        return tl::unexpected(as_drawn.error());
    const auto bright = as_bright_as_truth(image, lit);
    if (!bright)
        return tl::unexpected(bright.error());
    const auto reference = relative_error(*bright, truth, lit.mask);
    if (!reference)
        return tl::unexpected(reference.error());
    errors.as_drawn = *as_drawn;
    errors.reference = *reference;
    errors.flip = mean_flip(*bright, truth, lit.mask);
    return {};
}

} // namespace

Expected<LightErrors>
compare_picture(methods::Method& method, const Lit& lit, bool has_law, int samples) {
    const auto image = pictures::render_picture(method, lit.scene, lit.width, lit.height, samples);
    if (!image)
        return tl::unexpected(image.error());
    LightErrors errors;
    errors.decision = method.decision();
    errors.predicted_change = method.predicted_change();
    const auto changed = pictures::measured_change(method, lit.scene, *image, samples);
    if (!changed)
        return tl::unexpected(changed.error());
    errors.measured_change = *changed;
    if (has_law) {
        const auto law = relative_error(*image, lit.exact, lit.mask);
        if (!law)
            return tl::unexpected(law.error());
        errors.law = *law;
    }
    if (lit.truth)
        if (auto done = compare_with_truth(*image, lit, errors); !done)
            return tl::unexpected(done.error());
    return errors;
}

Expected<std::vector<double>>
fitted_errors(methods::Method& method, std::span<const Lit> lights, int samples) {
    if (std::ranges::any_of(lights, [](const Lit& lit) { return !lit.truth; }))
        return {};
    std::vector<std::array<LinearImage, 4>> terms;
    pictures::ReflectanceFit fit;
    for (const auto& lit : lights) {
        auto drawn = pictures::term_pictures(method, lit.scene, lit.width, lit.height, samples);
        if (!drawn)
            return tl::unexpected(drawn.error());
        if (auto added = fit.add_training_light({*drawn, lit.truth->image}); !added)
            return tl::unexpected(added.error());
        terms.push_back(std::move(*drawn));
    }
    const auto best = fit.best().reflectance;
    std::vector<double> errors;
    for (std::size_t i = 0; i < lights.size(); ++i) {
        const auto bright = as_bright_as_truth(sum_of(terms[i], best), lights[i]);
        if (!bright)
            return tl::unexpected(bright.error());
        const auto error = relative_error(*bright, lights[i].truth->image, lights[i].mask);
        if (!error)
            return tl::unexpected(error.error());
        errors.push_back(*error);
    }
    return errors;
}

} // namespace experiment::cost
