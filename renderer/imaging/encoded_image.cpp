// Quantisation to code values, plain and dithered.
#include "renderer/imaging/encoded_image.h"

#include "renderer/contract.h"
#include "renderer/imaging/colour.h"

#include <cmath>

namespace renderer::imaging {

namespace {

std::size_t pixel_count(const LinearImage& image) {
    EXPECTS(image.width >= 0 && image.height >= 0);
    const auto count =
        static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    EXPECTS(image.pixels.size() == count);
    return count;
}

// Bayer's 8 x 8 matrix by its bits: those of x ^ y and y, interleaved from the last to the first.
// Thresholds (rank + 1/2) / 64 lie symmetrically about 1/2, so that dither shifts no mean.
double bayer_threshold(unsigned x, unsigned y) {
    unsigned rank = 0;
    for (unsigned bit = 0; bit < 3; ++bit)
        rank = rank << 2U | (((x ^ y) >> bit & 1U) << 1U) | (y >> bit & 1U);
    return (rank + 0.5) / 64;
}

std::uint16_t dithered_code(float light, double threshold) {
    return static_cast<std::uint16_t>(
        std::floor(srgb_from_linear(static_cast<double>(light)) * 255 + threshold));
}

} // namespace

LinearRgb light_at(const EncodedImage& image, std::size_t pixel) {
    EXPECTS(image.bits == 8 || image.bits == 16);
    EXPECTS(3 * pixel + 2 < image.codes.size());
    const double greatest = image.bits == 8 ? 255 : 65535;
    const auto light = [&](std::size_t channel) {
        return static_cast<float>(linear_from_srgb(image.codes[3 * pixel + channel] / greatest));
    };
    return {light(0), light(1), light(2)};
}

EncodedImage encode_16bit(const LinearImage& opaque) {
    EncodedImage image{opaque.width, opaque.height, 16, {}};
    image.codes.reserve(3 * pixel_count(opaque));
    for (const auto& light : opaque.pixels)
        for (const float channel : {light.r, light.g, light.b})
            image.codes.push_back(code_16bit(srgb_from_linear(static_cast<double>(channel))));
    return image;
}

EncodedImage encode_8bit(const LinearImage& opaque) {
    EncodedImage image{opaque.width, opaque.height, 8, {}};
    image.codes.reserve(3 * pixel_count(opaque));
    const auto width = static_cast<std::size_t>(opaque.width);
    for (std::size_t pixel = 0; pixel < opaque.pixels.size(); ++pixel) {
        const auto& light = opaque.pixels[pixel];
        const double threshold = bayer_threshold(static_cast<unsigned>(pixel % width % 8),
                                                 static_cast<unsigned>(pixel / width % 8));
        for (const float channel : {light.r, light.g, light.b})
            image.codes.push_back(dithered_code(channel, threshold));
    }
    return image;
}

} // namespace renderer::imaging
