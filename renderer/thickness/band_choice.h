// How many bands a picture needs: as few as leave it unchanged to the eye, for this light and this
// view.  "Only what the scene needs."
//
// All directions here are in the axes of the model, where the coefficients live: bring light and
// eye there first (shading/lighting.h: model_light), and never turn the coefficients.
#pragma once

#include "renderer/thickness/normal_bins.h"

#include <glm/vec3.hpp>

#include <span>
#include <string>
#include <vector>

namespace renderer::thickness {

/// A light as far as the choice is concerned.
struct SeenLight {
    glm::dvec3 to_light{}; ///< unit, model axes
    /// How much brightness (1 = white) changes with a model unit of thickness, at most: under the
    /// paper's law I_p max(k_sc) / D_n; under the physical law I_p max(k_sc sigma_tr) in model
    /// units.
    double per_length = 1;
};

/// Root mean square, over the surface that faces the eye, of what the brightness changes when all
/// bands from `bands` on are left out: sqrt(sum_k w_k Y^T M_k Y / sum_k w_k) over the bins that
/// face the eye, with Y = sum over the lights of per_length y(L) in the bands left out.  Exact for
/// the paper's law where it does not clamp, else an upper bound to first order.  Several lights add
/// up before they are squared, as they do in the picture.  0 when nothing faces the eye. Errors:
/// EXPECTS bands 0..bins.bands and unit directions (1e-6). Source: methods page, SHSS, choice of
/// bands.
double dropped_rms(const NormalBins& bins,
                   std::span<const SeenLight> lights,
                   glm::dvec3 to_eye,
                   int bands);

/// Which rule decided.
enum class BandRule {
    WithinTolerance, ///< fewer bands would change the picture by more than is allowed
    Everything,      ///< even one band less would
    Held,            ///< fewer would just do, but not by enough to change what is shown
    PaperBehind,     ///< the paper's preset, light behind the object
    PaperInFront     ///< the paper's preset, light in front
};

struct BandChoice {
    int bands = 1;
    BandRule rule = BandRule::Everything;
    /// predicted[n - 1]: the change with n bands, as dropped_rms; the last is 0.  Empty for the
    /// paper's preset, which predicts nothing.
    std::vector<double> predicted;
};

/// Tolerances on the change of brightness: unseen (an 8-bit step of a display), or a fair bargain.
inline constexpr double invisible_change = 0.004, balanced_change = 0.02;

/// The fewest bands whose predicted change is at most `tolerance`.  With `previous` (the bands
/// chosen for the frame before, 0 for none) fewer are taken only when they do with 5 % to spare, so
/// that a light that rests near the limit does not make the choice flicker.
BandChoice choose_bands(const NormalBins& bins,
                        std::span<const SeenLight> lights,
                        glm::dvec3 to_eye,
                        double tolerance,
                        int previous = 0);

/// The same for changes that were predicted in another way: predicted[n - 1] with n bands, the last
/// 0.  Errors: EXPECTS that.
BandChoice choose_bands(std::vector<double> predicted, double tolerance, int previous = 0);

/// The paper's preset: 5 bands with the light behind the object (L.V < 0), else 2; at most
/// `available`.  With `previous` it changes only when L.V is past 0 by 0.05.  [SHSS]
BandChoice paper_bands(glm::dvec3 to_light, glm::dvec3 to_eye, int available, int previous = 0);

/// "3 of 5 bands: the others change the picture by 0.0031, 0.004 is allowed".
std::string describe(const BandChoice& choice, double tolerance);

} // namespace renderer::thickness
