// Lengths, optical coefficients, angles and colours as types.  Conventions:
// docs/conventions.md#units
#pragma once

#include <numbers>

namespace renderer {

struct Millimetres {
    double value{};
    bool operator==(const Millimetres&) const = default;
};

struct PerMillimetre {
    double value{};
};

struct Radians {
    double value{};
};

constexpr Radians from_degrees(double degrees) {
    return {degrees * std::numbers::pi / 180.0};
}

/// Optical thickness: how many mean free paths fit into `thickness`.  Dimensionless.
constexpr double operator*(PerMillimetre extinction, Millimetres thickness) {
    return extinction.value * thickness.value;
}

/// Scene light: linear, Rec. 709 primaries, 1 = reference white.
struct LinearRgb {
    float r{}, g{}, b{};
    bool operator==(const LinearRgb&) const = default;
};

/// What a display is sent: encoded, 0..1.
struct EncodedRgb {
    float r{}, g{}, b{};
    bool operator==(const EncodedRgb&) const = default;
};

/// One optical coefficient per colour channel.
struct RgbPerMillimetre {
    double r{}, g{}, b{};
    bool operator==(const RgbPerMillimetre&) const = default;
};

} // namespace renderer
