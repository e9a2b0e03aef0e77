// False colours for lengths and differences, the scale beside them, and what they are read from.
#pragma once

#include "renderer/scene.h"
#include "renderer/units.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace experiment::viewer {

/// The colour at `t`, 0..1 (what lies outside is clipped): dark violet over red to pale yellow, a
/// path of constant chroma along which lightness and hue grow evenly in Oklab, so that equal steps
/// look equal.  In the gamut of sRGB, linear.  Source: [Ottosson2020].
renderer::LinearRgb false_colour(double t);

/// The least of 1, 2 and 5 times a power of ten that is not below `value` by more than a
/// thousandth; 1 for what is not positive.
double round_scale(double value);

/// A material that makes thickness readable in a picture: nothing but scattered light of 1, and a
/// transport coefficient that grows with the channel, sigma_tr = (1, 2, 3)/`reach`, so that under
/// the physical law a thickness d gives I (exp(-d/reach), exp(-2 d/reach), exp(-3 d/reach)),
/// whatever brightness I the light has there.  `reach` is about the body's size: nothing then
/// leaves float's range.
renderer::Material thickness_probe(renderer::Millimetres reach);

/// Thickness in mm of a pixel drawn with the probe: reach ln(r/g).  Nothing where nothing was
/// drawn, and where the channels do not follow one length: g^2 = r b to 1 part in 1,000.
/// Slow twin of show.frag.
std::optional<double> thickness_of(std::span<const float, 4> rgba, renderer::Millimetres reach);

/// What a picture drawn with the probe holds.
struct ThicknessSeen {
    std::size_t pixels = 0;    ///< of the body
    std::size_t known = 0;     ///< of those, with a thickness
    double mean = 0, most = 0; ///< mm, over `known`
};

/// Whether what was drawn is dimmed by a thickness: 99 % of the body's pixels have one.  True of a
/// picture without the body.
bool has_thickness(const ThicknessSeen& seen);

ThicknessSeen thickness_seen(std::span<const float> rgba, renderer::Millimetres reach);

/// How much two pictures differ where either shows the body: the largest of the channels'
/// differences, linear light.
struct ErrorSeen {
    double mean = 0, most = 0;
};

ErrorSeen error_seen(std::span<const float> left_rgba, std::span<const float> right_rgba);

/// Whether the method can be told to attenuate by the physical law, under which alone the picture
/// of the probe can be read.
bool has_physical_law(std::string_view method);

} // namespace experiment::viewer
