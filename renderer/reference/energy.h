// Where the light goes that falls on a body: how much comes back, gets through, stays.
//
// These are the numbers that books and tables have: the renderer's transport is checked by them.
#pragma once

#include "renderer/geometry/mesh.h"
#include "renderer/reference/body.h"
#include "renderer/reference/boundary.h"
#include "renderer/reference/medium.h"
#include "renderer/reference/walk.h"

#include <cstdint>

namespace renderer::reference {

struct Estimate {
    double value = 0;
    double standard_error = 0; ///< from the spread of independent batches
};

enum class Incidence {
    Normal, ///< along -z: on a slab at right angles, on a sphere a parallel beam as wide as it
    Diffuse ///< the same radiance from everywhere outside
};

/// Light falling on a body, in one colour.
struct EnergyProblem {
    double albedo = 1;
    double anisotropy = 0;
    double optical_thickness = 1; ///< of a slab (infinite: a half-space); of a sphere's radius
    double index = 1;
    Boundary boundary;
    Incidence incidence = Incidence::Normal;
};

struct EnergyRun {
    std::uint64_t paths = 1'000'000; ///< rounded up to whole batches of 64 to 4096
    std::uint64_t seed = 1;
    WalkTactics tactics;
};

/// Shares of the light that falls on the body.  back + through + absorbed + roulette = 1 - specular
/// to rounding, path by path.
struct EnergyBalance {
    Estimate back;    ///< leaves against the incident direction (slab: where it came from)
    Estimate through; ///< leaves along it (slab: on the far side), unscattered light included
    Estimate escape;  ///< the two together
    Estimate absorbed;
    Estimate roulette;   ///< zero on average
    Estimate collisions; ///< per path, weighted by what the path carries
    double specular = 0; ///< reflected by a slab's smooth surface before entering, exactly
    std::uint64_t paths = 0;
    std::uint64_t leaks = 0;
};

/// A slab, or a half-space where the optical thickness is infinite.
/// Errors: EXPECTS albedo and anisotropy in their ranges, thickness and index above 0.
EnergyBalance slab_energy(const EnergyProblem& problem, const EnergyRun& run);

/// A sphere; what its surface reflects counts as escaped.
EnergyBalance sphere_energy(const EnergyProblem& problem, const EnergyRun& run);

/// Any body within `radius` of `centre` under the same radiance from everywhere: what arrives at a
/// camera out there per unit of radiance (`escape`), mean over all rays that meet the body.
EnergyBalance body_energy(const Body& body,
                          glm::dvec3 centre,
                          double radius,
                          const Medium& medium,
                          const Boundary& boundary,
                          const EnergyRun& run);

/// Collisions of a mean path under an even sky, did nothing absorb: extinction times index^2 4V/S,
/// of the channel that has most.  What a picture costs before one is made.  [Blanco2003]
/// [Tommasi2020]
double
expected_collisions(const geometry::Mesh& mesh, const Medium& medium, const Boundary& boundary);

} // namespace renderer::reference
