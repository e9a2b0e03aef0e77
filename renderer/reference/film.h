// What a picture under way knows of every pixel: enough to go on from, and to say how sure it is.
//
// Samples come in batches, every pixel has the same number of them; a pixel's standard error is
// that of the mean of its batches.
#pragma once

#include "renderer/imaging/linear_image.h"
#include "renderer/reference/medium.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace renderer::reference {

/// Row-major, top row first; light is premultiplied by coverage.
struct Film {
    int width = 0, height = 0;
    std::uint64_t seed = 1;
    int log2_batch = 4;               ///< a batch is 2^log2_batch samples
    std::uint32_t batches = 0;        ///< of every pixel, so far
    std::vector<Spectrum<3>> sum;     ///< of batch means
    std::vector<Spectrum<3>> squares; ///< of batch means
    std::vector<Spectrum<3>> odd;     ///< of every second batch's mean
    std::vector<double> covered;      ///< samples that met the body
    std::uint64_t paths = 0;
    std::uint64_t leaks = 0;
};

/// Nothing on it yet.  Errors: EXPECTS sizes above 0 and log2_batch in 0..16.
Film blank_film(int width, int height, std::uint64_t seed, int log2_batch = 4);

/// One batch of one pixel.
struct PixelBatch {
    Spectrum<3> mean{};
    double covered = 0;
};

/// Adds the next batch of a pixel; `batches` is counted by who adds them to all pixels.
void add(Film& film, std::size_t pixel, const PixelBatch& batch);

/// Errors: EXPECTS a batch.
Spectrum<3> mean(const Film& film, std::size_t pixel);

/// Of the mean.  Errors: EXPECTS two batches.
Spectrum<3> standard_error(const Film& film, std::size_t pixel);

/// The mean picture.
imaging::LinearImage picture(const Film& film);

/// The standard error of each pixel as a picture.
imaging::LinearImage error_picture(const Film& film);

/// Two pictures that share no sample: the even batches' and the odd ones'.  Errors: EXPECTS two
/// batches.
struct Halves {
    imaging::LinearImage even, odd;
};

Halves halves(const Film& film);

} // namespace renderer::reference
