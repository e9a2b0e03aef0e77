// Every pixel of every light is one equation for each channel.
#include "renderer/pictures/fitting.h"

#include "renderer/contract.h"
#include "renderer/imaging/brightness.h"
#include "renderer/pictures/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace renderer::pictures {

namespace {

using imaging::LinearImage;

constexpr std::array channels_of_rgb{&LinearRgb::r, &LinearRgb::g, &LinearRgb::b};

double channel(LinearRgb colour, std::size_t c) {
    return static_cast<double>(colour.*channels_of_rgb[c]);
}

LinearRgb& coefficient(Reflectance& k, Term term) {
    switch (term) {
    case Term::Ambient:
        return k.ambient;
    case Term::Diffuse:
        return k.diffuse;
    case Term::Specular:
        return k.specular;
    case Term::Scatter:
        break;
    }
    return k.scatter;
}

/// One pixel of one channel: the terms' values and the target's.
struct Sample {
    NonnegativeLeastSquares::Weights terms{};
    double target = 0;

    double weight() const { return 1 / (target * target + 0.01); }

    bool is_finite() const {
        return std::isfinite(target) && std::all_of(terms.begin(), terms.end(), [](double term) {
                   return std::isfinite(term);
               });
    }
};

Sample sample(const LightPictures& pictures, std::size_t pixel, std::size_t c) {
    Sample sample;
    sample.target = channel(pictures.target.pixels[pixel], c);
    for (std::size_t j = 0; j < sample.terms.size(); ++j)
        sample.terms[j] = channel(pictures.terms[j].pixels[pixel], c);
    return sample;
}

bool is_like(const LinearImage& image, const LinearImage& other) {
    const auto pixels =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    return image.width == other.width && image.height == other.height &&
           image.pixels.size() == pixels && image.coverage.size() == pixels;
}

/// The pixels that every picture covers wholly.
Expected<std::vector<std::size_t>> common_pixels(const LightPictures& pictures) {
    auto coverage = pictures.target.coverage;
    for (const auto& term : pictures.terms) {
        if (!is_like(term, pictures.target))
            return tl::make_unexpected(fmt::format(
                "a picture of {} x {} pixels beside a target of {} x {}, expected one "
                "size",
                term.width, term.height, pictures.target.width, pictures.target.height));
        std::transform(coverage.begin(), coverage.end(), term.coverage.begin(), coverage.begin(),
                       [](float a, float b) { return std::min(a, b); });
    }
    const auto pixels = imaging::covered_pixels(coverage);
    if (pixels.empty())
        return tl::make_unexpected(
            "no pixel that the pictures and their target all cover, expected "
            "the same object in the same view");
    return pixels;
}

/// Hands every pixel of every channel to `take(channel, sample)`; the answer is their number.
template <class Take>
Expected<std::size_t> for_each_sample(const LightPictures& pictures, Take&& take) {
    const auto pixels = common_pixels(pictures);
    if (!pixels)
        return tl::make_unexpected(pixels.error());
    const auto width = static_cast<std::size_t>(pictures.target.width);
    for (const auto pixel : *pixels)
        for (std::size_t c = 0; c < 3; ++c) {
            const auto one = sample(pictures, pixel, c);
            if (!one.is_finite())
                return tl::make_unexpected(
                    fmt::format("pixel ({}, {}) is not a number, expected light", pixel % width,
                                pixel / width));
            take(c, one);
        }
    return pixels->size();
}

} // namespace

std::string_view name(Term term) {
    constexpr std::array<std::string_view, 4> names{"ambient", "diffuse", "specular", "scatter"};
    return names[static_cast<std::size_t>(term)];
}

Expected<void> ReflectanceFit::add_training_light(const LightPictures& pictures) {
    auto channels = channels_; // a bad picture leaves no half of itself behind
    const auto pixels = for_each_sample(pictures, [&](std::size_t c, Sample one) {
        const double root = std::sqrt(one.weight());
        for (auto& term : one.terms)
            term *= root;
        channels[c].add_equation(one.terms, one.target * root);
    });
    if (!pixels)
        return tl::make_unexpected(pixels.error());
    channels_ = channels;
    pixels_ += *pixels;
    return {};
}

ReflectanceFit::Result ReflectanceFit::best() const {
    EXPECTS(pixels_ > 0);
    Result result;
    std::array<bool, 4> absent{true, true, true, true};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto solution = channels_[c].solve();
        result.training_error.rgb[c] = solution.squared_error / static_cast<double>(pixels_);
        for (const auto term : all_terms) {
            const auto j = static_cast<std::size_t>(term);
            coefficient(result.reflectance, term).*channels_of_rgb[c] =
                static_cast<float>(solution.x[j]);
            absent[j] = absent[j] && solution.absent[j];
        }
    }
    for (const auto term : all_terms)
        if (absent[static_cast<std::size_t>(term)])
            result.absent.push_back(term);
    return result;
}

Expected<RelativeError> fit_error(const Reflectance& k, const LightPictures& pictures) {
    RelativeError error;
    Reflectance weights = k;
    const auto pixels = for_each_sample(pictures, [&](std::size_t c, const Sample& one) {
        double sum = 0;
        for (const auto term : all_terms)
            sum +=
                one.terms[static_cast<std::size_t>(term)] * channel(coefficient(weights, term), c);
        error.rgb[c] += one.weight() * (sum - one.target) * (sum - one.target);
    });
    if (!pixels)
        return tl::make_unexpected(pixels.error());
    for (auto& each : error.rgb)
        each /= static_cast<double>(*pixels);
    return error;
}

Expected<std::array<LinearImage, 4>>
term_pictures(methods::Method& method, const Scene& scene, int width, int height, int samples) {
    std::array<LinearImage, 4> pictures;
    for (const auto term : all_terms) {
        auto alone = scene;
        alone.material.reflectance = {.ambient = {},
                                      .diffuse = {},
                                      .specular = {},
                                      .scatter = {},
                                      .shininess = scene.material.reflectance.shininess};
        coefficient(alone.material.reflectance, term) = {1, 1, 1};
        auto picture = render_picture(method, alone, width, height, samples);
        if (!picture)
            return tl::make_unexpected(picture.error());
        pictures[static_cast<std::size_t>(term)] = std::move(*picture);
    }
    return pictures;
}

} // namespace renderer::pictures
