// The sRGB curve.
#include "renderer/imaging/colour.h"

#include "renderer/contract.h"

#include <algorithm>
#include <cmath>

namespace renderer::imaging {

namespace {

// The two pieces meet to 3e-8 with the standard's rounded constants; an exact join would be another
// curve than everybody's.
constexpr double linear_knee = 0.0031308;
constexpr double encoded_knee = 0.04045;
constexpr double knee_slope = 12.92;
constexpr double offset = 0.055;
constexpr double exponent = 2.4;

float encode_channel(float light) {
    return static_cast<float>(srgb_from_linear(static_cast<double>(light)));
}

float decode_channel(float encoded) {
    return static_cast<float>(linear_from_srgb(static_cast<double>(encoded)));
}

double nearest_code(double encoded, double greatest) {
    EXPECTS(encoded >= 0 && encoded <= 1);
    return std::floor(encoded * greatest + 0.5);
}

} // namespace

double srgb_from_linear(double light) {
    EXPECTS(!std::isnan(light));
    const double shown = std::clamp(light, 0.0, 1.0);
    if (shown <= linear_knee)
        return knee_slope * shown;
    return (1 + offset) * std::pow(shown, 1 / exponent) - offset;
}

double linear_from_srgb(double encoded) {
    EXPECTS(encoded >= 0 && encoded <= 1);
    if (encoded <= encoded_knee)
        return encoded / knee_slope;
    return std::pow((encoded + offset) / (1 + offset), exponent);
}

EncodedRgb encode(LinearRgb light) {
    return {encode_channel(light.r), encode_channel(light.g), encode_channel(light.b)};
}

LinearRgb decode(EncodedRgb encoded) {
    return {decode_channel(encoded.r), decode_channel(encoded.g), decode_channel(encoded.b)};
}

std::uint8_t code_8bit(double encoded) {
    return static_cast<std::uint8_t>(nearest_code(encoded, 255));
}

std::uint16_t code_16bit(double encoded) {
    return static_cast<std::uint16_t>(nearest_code(encoded, 65535));
}

double luminance(LinearRgb light) {
    return 0.2126 * static_cast<double>(light.r) + 0.7152 * static_cast<double>(light.g) +
           0.0722 * static_cast<double>(light.b);
}

} // namespace renderer::imaging
