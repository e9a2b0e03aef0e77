// Precomputed radiance transfer: what leaves every vertex as a linear function of the light's
// spherical-harmonic coefficients.  [Sloan2002; Sloan2003; Jensen2001]
#pragma once

#include "renderer/diffusion/point_tree.h"
#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/scene.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace renderer::transfer {

enum class Mode {
    Subsurface,     ///< irradiance spread by the dipole
    ShadowedDiffuse ///< irradiance reflected where it falls, with the medium's plane albedo
};

struct TransferOptions {
    Mode mode = Mode::Subsurface;
    int bands = 5;         ///< 1..6
    int directions = 1024; ///< Fibonacci directions shared by all samples
    std::uint64_t rotation_seed = 1;
    double opening = 0.05; ///< solid angle, sr, above which a node of samples is opened
    std::size_t most_samples = 4'000'000;

    bool operator==(const TransferOptions&) const = default;
};

/// The transfer vectors of all vertices: 3 bands^2 floats each.
struct TransferField {
    int bands = 0;
    std::vector<float> transfer; ///< [(vertex * 3 + channel) * bands^2 + i], 1/sr times sr
    std::size_t samples = 0;     ///< surface points at which irradiance was taken
    bool undersampled = false;   ///< more than `most_samples` would have been needed
};

using diffusion::Progress;

/// What the body's own shadows and boundary leave of light from all directions, at each sample:
/// e_i = integral of V Ft (N.s)+ y_i(s) over the sphere.
/// Shape: result[sample * bands^2 + i]; empty when `progress` stopped it.
std::vector<float> irradiance_transfer(const geometry::Mesh& mesh,
                                       const diffusion::SurfaceSamples& samples,
                                       double eta,
                                       const TransferOptions& options,
                                       const Progress& progress = {});

/// Transfer of every vertex: t_i = (1/pi) sum over samples of A R_d e_i, per channel.
/// Deterministic: the result does not depend on the number of threads.
/// Units: `mm_per_unit` tells how long one unit of the mesh is.
/// Errors: "cancelled" when progress returned false; fewer directions than twice the coefficients;
/// a medium without scattering or a mesh without area.  EXPECTS bands 1..6.
Expected<TransferField> compute_transfer_field(const geometry::Mesh& mesh,
                                               const Medium& medium,
                                               double mm_per_unit,
                                               const TransferOptions& options,
                                               const Progress& progress = {});

/// The same transfer in fewer bands: the first coefficients of every vector.  What
/// `compute_transfer_field` gives for as many bands differs by what the least squares of its
/// directions makes of the bands that are missing there, less than 1e-3 with a thousand of them.
/// Errors: EXPECTS 1..field.bands.
TransferField first_bands(const TransferField& field, int bands);

/// Radiance that leaves vertex `v` under light with these coefficients (bands^2, the same in each
/// channel), not clamped: a band-limited light can be negative somewhere.
glm::dvec3 exit_radiance(const TransferField& field, std::size_t v, std::span<const double> light);

} // namespace renderer::transfer
