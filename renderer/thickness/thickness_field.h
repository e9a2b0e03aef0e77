// How much material lies between every vertex and the light, for every direction of light:
// spherical-harmonic coefficients per vertex, found by ray tracing.  [SHSS, eqs. 1 and 2]
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/mesh.h"
#include "renderer/thickness/normal_bins.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <vector>

namespace renderer::thickness {

class Solid;

/// Which length along the ray counts.
enum class Kind {
    Sum,   ///< all interior segments: what the light has to pass (the paper's concave-object claim)
    First, ///< the segment that starts at the vertex
    Span   ///< from the vertex to the last exit, gaps counted
};

struct FieldOptions {
    Kind kind = Kind::Sum;
    int bands = 5;         ///< 1..6
    int directions = 1024; ///< Fibonacci directions shared by all vertices
    std::uint64_t rotation_seed = 1;

    bool operator==(const FieldOptions&) const = default;
};

/// Whether a field of the options `there` has all that `wanted` asks for: the same in everything
/// but the bands, of which it may have more.
constexpr bool serves(const FieldOptions& there, const FieldOptions& wanted) {
    return there.kind == wanted.kind && there.directions == wanted.directions &&
           there.rotation_seed == wanted.rotation_seed && there.bands >= wanted.bands;
}

/// The length below which `fraction` of the positive thickness lies, area and solid angle weighted.
struct Percentile {
    double fraction = 0; ///< 0..1
    double length = 0;   ///< model units

    bool operator==(const Percentile&) const = default;
};

/// Coefficients of all vertices of one mesh.  Lengths in model units.
struct ThicknessField {
    int bands = 0;
    std::vector<float> coefficients; ///< vertex-major: vertex v has coefficients[v*bands^2 ..)
    std::vector<double> energy;      ///< per vertex: integral of d^2 over the sphere
    double d_n = 0; ///< 99.5th percentile of the positive thickness, area and solid angle weighted
    geometry::RayStatistics statistics{};
    FieldOptions options{}; ///< what was asked for
    std::vector<Percentile> percentiles;
    geometry::BoundingSphere bounds{}; ///< no chord is longer than its diameter
    NormalBins normal_bins;            ///< what the choice of bands needs (band_choice.h)
};

/// Called as blocks of vertices are finished, by one thread at a time, with growing fractions up
/// to 1.
using Progress = std::function<void(double fraction)>;

/// Traces and projects the thickness at every vertex of a prepared (welded, oriented) mesh.  Where
/// it has openings, inside is where it winds more than half around (geometry/openings.h).
/// Deterministic: the result does not depend on the number of threads.
/// Memory beside the result does not grow with the directions.
/// Errors: a mesh that is not consistently oriented or encloses nothing; fewer directions than
/// twice the coefficients; more than 1e-4 of the rays unresolved; "cancelled ..." soon after a stop
/// was requested (progress may request it).  EXPECTS bands 1..6, indices in range.
Expected<ThicknessField> compute_thickness_field(const geometry::Mesh& mesh,
                                                 const FieldOptions& options,
                                                 const Progress& progress = {},
                                                 const std::stop_token& stop = {});

/// Eq. 2: thickness of vertex `v` toward the light from the first `bands` bands, unclamped.
/// `basis` holds y(L) of at least bands^2 elements.
double
reconstruct(const ThicknessField& field, std::size_t v, std::span<const double> basis, int bands);

/// Exactly traced thickness of every vertex toward each unit direction, in model units.
/// Shape: result[v * directions.size() + k].
Expected<std::vector<double>>
trace_thickness(const geometry::Mesh& mesh, Kind kind, std::span<const glm::dvec3> directions);

/// `trace_thickness` for directions that come one after the other: the mesh is made ready for rays
/// once.
class ThicknessTracer {
  public:
    /// Copies what it needs.  Errors: a mesh that is no solid, as above.
    static Expected<ThicknessTracer> prepare(const geometry::Mesh& mesh);

    /// Errors: more than 1e-4 of the rays unresolved.
    Expected<std::vector<double>> trace(Kind kind, std::span<const glm::dvec3> directions) const;

  private:
    explicit ThicknessTracer(std::shared_ptr<const Solid> solid);

    std::shared_ptr<const Solid> solid_;
    std::vector<std::uint32_t> order_; ///< of the vertices, neighbours together
};

} // namespace renderer::thickness
