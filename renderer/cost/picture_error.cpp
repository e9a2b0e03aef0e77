// The clearest channel tells the most of a thickness.
#include "renderer/cost/picture_error.h"

#include "renderer/contract.h"
#include "renderer/pictures/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace renderer::cost {

namespace {

double channel(const LinearRgb& colour, int c) {
    return static_cast<double>(c == 0 ? colour.r : c == 1 ? colour.g : colour.b);
}

double channel(const RgbPerMillimetre& colour, int c) {
    return c == 0 ? colour.r : c == 1 ? colour.g : colour.b;
}

/// The one with the least sigma_tr above 0, or none: light gets farthest in it, and the most of its
/// thickness is told.
int clearest_channel(const Medium& medium) {
    const auto sigma = effective_transport(medium);
    int clearest = -1;
    for (int c = 0; c < 3; ++c)
        if (channel(sigma, c) > 0 && (clearest < 0 || channel(sigma, c) < channel(sigma, clearest)))
            clearest = c;
    return clearest;
}

} // namespace

double relative_rms(const imaging::LinearImage& test,
                    const imaging::LinearImage& truth,
                    std::span<const std::size_t> mask) {
    EXPECTS(test.width == truth.width && test.height == truth.height);
    double difference = 0, squares = 0;
    for (const auto i : mask) {
        EXPECTS(i < truth.pixels.size());
        for (int c = 0; c < 3; ++c) {
            const double x = channel(test.pixels[i], c), y = channel(truth.pixels[i], c);
            difference += (x - y) * (x - y);
            squares += y * y;
        }
    }
    return std::sqrt(difference / squares);
}

double relative_rms(std::span<const double> test, std::span<const double> truth) {
    EXPECTS(test.size() == truth.size());
    double difference = 0, squares = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        difference += (test[i] - truth[i]) * (test[i] - truth[i]);
        squares += truth[i] * truth[i];
    }
    return std::sqrt(difference / squares);
}

Expected<double> relative_error(const imaging::LinearImage& test,
                                const imaging::LinearImage& truth,
                                std::span<const std::size_t> mask) {
    const auto unknown = std::ranges::count_if(mask, [&](std::size_t i) {
        const auto& p = test.pixels.at(i);
        return !std::isfinite(p.r) || !std::isfinite(p.g) || !std::isfinite(p.b);
    });
    if (unknown > 0)
        return tl::make_unexpected(
            fmt::format("{} of {} pixels are no number", unknown, mask.size()));
    const double error = relative_rms(test, truth, mask);
    if (std::isnan(error))
        return tl::make_unexpected("the picture that it is measured by is black, or no number");
    return error;
}

Expected<std::vector<std::optional<double>>>
seen_thickness(methods::Method& method, shading::Law law, Scene scene, int width, int height) {
    const int c = law == shading::Law::Paper ? 1 : clearest_channel(scene.material.medium);
    if (c < 0)
        return tl::make_unexpected("the medium absorbs nothing, and all light comes through any "
                                   "thickness: expected a sigma_a above 0 in some channel");
    auto& k = scene.material.reflectance;
    k.ambient = k.diffuse = k.specular = {};
    k.scatter = {1, 1, 1};
    for (auto& light : scene.lights)
        light.intensity = {1, 1, 1};
    const auto picture = pictures::render_picture(method, scene, width, height, 1);
    if (!picture)
        return tl::make_unexpected(picture.error());
    std::vector<std::optional<double>> thickness(picture->pixels.size());
    for (std::size_t i = 0; i < thickness.size(); ++i)
        if (picture->coverage[i] == 1.0F) {
            const double left = channel(picture->pixels[i], c);
            thickness[i] = law == shading::Law::Paper // a NaN stays one: it is not below 1e-300
                               ? 1 - left
                               : -std::log(left < 1e-300 ? 1e-300 : left);
        }
    return thickness;
}

} // namespace renderer::cost
