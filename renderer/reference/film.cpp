// Means and their errors from sums over batches.
#include "renderer/reference/film.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>

namespace renderer::reference {

namespace {

LinearRgb rgb(const Spectrum<3>& light) {
    return {static_cast<float>(light[0]), static_cast<float>(light[1]),
            static_cast<float>(light[2])};
}

template <class LightAt>
imaging::LinearImage picture_of(const Film& film, LightAt&& light_at) {
    imaging::LinearImage image{film.width, film.height, {}, {}};
    const double samples = std::ldexp(static_cast<double>(film.batches), film.log2_batch);
    for (std::size_t i = 0; i < film.sum.size(); ++i) {
        image.pixels.push_back(rgb(light_at(i)));
        image.coverage.push_back(static_cast<float>(film.covered[i] / samples));
    }
    return image;
}

Spectrum<3> scaled(const Spectrum<3>& light, double factor) {
    return {factor * light[0], factor * light[1], factor * light[2]};
}

} // namespace

Film blank_film(int width, int height, std::uint64_t seed, int log2_batch) {
    EXPECTS(width > 0 && height > 0);
    EXPECTS(log2_batch >= 0 && log2_batch <= 16);
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    const std::vector<Spectrum<3>> dark(pixels, Spectrum<3>{});
    return {width, height, seed, log2_batch, 0, dark, dark, dark, std::vector<double>(pixels, 0.0)};
}

void add(Film& film, std::size_t pixel, const PixelBatch& batch) {
    for (std::size_t k = 0; k < 3; ++k) {
        const double light = batch.mean[k];
        film.sum[pixel][k] += light;
        film.squares[pixel][k] += light * light;
        if (film.batches % 2 == 1)
            film.odd[pixel][k] += light;
    }
    film.covered[pixel] += batch.covered;
}

Spectrum<3> mean(const Film& film, std::size_t pixel) {
    EXPECTS(film.batches > 0);
    return scaled(film.sum[pixel], 1.0 / film.batches);
}

Spectrum<3> standard_error(const Film& film, std::size_t pixel) {
    EXPECTS(film.batches > 1);
    const double n = film.batches;
    Spectrum<3> error;
    for (std::size_t k = 0; k < 3; ++k) {
        const double average = film.sum[pixel][k] / n;
        const double variance = film.squares[pixel][k] / n - average * average;
        error[k] = std::sqrt(std::max(variance, 0.0) / (n - 1)); // in this order NaN stays
    }
    return error;
}

imaging::LinearImage picture(const Film& film) {
    return picture_of(film, [&](std::size_t i) { return mean(film, i); });
}

imaging::LinearImage error_picture(const Film& film) {
    return picture_of(film, [&](std::size_t i) { return standard_error(film, i); });
}

Halves halves(const Film& film) {
    EXPECTS(film.batches > 1);
    const double odd = film.batches / 2, even = film.batches - odd;
    return {picture_of(film,
                       [&](std::size_t i) {
                           Spectrum<3> rest;
                           for (std::size_t k = 0; k < 3; ++k)
                               rest[k] = film.sum[i][k] - film.odd[i][k];
                           return scaled(rest, 1 / even);
                       }),
            picture_of(film, [&](std::size_t i) { return scaled(film.odd[i], 1 / odd); })};
}

} // namespace renderer::reference
