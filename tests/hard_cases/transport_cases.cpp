// Scattering that hardly absorbs or hardly turns, and surfaces at their critical angle.
#include "renderer/diffusion/dipole.h"
#include "renderer/geometry/bodies.h"
#include "renderer/half_space.h"
#include "renderer/reference/boundary.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/phase.h"
#include "renderer/reference/walk.h"
#include "tests/hard_cases/hard_cases.h"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

namespace hard_cases {

namespace {

using namespace renderer;
using Real = boost::multiprecision::cpp_bin_float_50;

constexpr const char* fifty = "50 digits";

/// (1 + g^2 - ((1 - g^2) / (1 - g + 2 g u))^2) / 2g; digits to spare for small g.
Real henyey_greenstein_cosine(Real u, Real g) {
    if (g == 0)
        return 2 * u - 1;
    const Real inner = (1 - g * g) / (1 - g + 2 * g * u);
    return (1 + g * g - inner * inner) / (2 * g);
}

Case anisotropies(const std::string& what, std::initializer_list<double> all, double floor) {
    Worst worst("anisotropy", what, fifty, floor);
    for (const double g : all)
        for (const double u :
             {0.0, 1e-16, 1e-9, 1e-3, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999, 1 - 0x1p-53, 1.0})
            worst.see(reference::sample_henyey_greenstein(u, g),
                      static_cast<long double>(henyey_greenstein_cosine(u, g)), 1);
    return worst.result();
}

Case densities() {
    Worst worst("anisotropy", "density at g = +-0.999, relative", fifty, 12);
    for (const double g : {0.999, -0.999})
        for (const double cosine : {-1.0, -0.9999, -0.5, 0.0, 0.5, 0.9999, 1.0}) {
            const Real exact_g = g, inside = 1 + exact_g * exact_g - 2 * exact_g * cosine;
            const Real pi = boost::math::constants::pi<Real>();
            worst.see(reference::henyey_greenstein(cosine, g),
                      static_cast<long double>((1 - exact_g * exact_g) /
                                               (4 * pi * inside * sqrt(inside))));
        }
    return worst.result();
}

Real fresnel_exactly(Real cosine, Real index) {
    const Real sine = 1 - cosine * cosine, below = index * index - sine;
    if (below <= 0)
        return 1;
    const Real other = sqrt(below); // index times the cosine behind the surface
    const Real s = (cosine - other) / (cosine + other);
    const Real p = (index * index * cosine - other) / (index * index * cosine + other);
    return (s * s + p * p) / 2;
}

/// Reflectance falls from 1 like a square root there: one last place of the cosine is 1e-8 of it.
Case critical_angle() {
    Worst worst("surfaces", "reflectance about the critical angle, to the last place", fifty, 7);
    for (const double index : {1 / 1.3, 1 / 1.5, 1 / 2.4}) {
        double cosine = std::sqrt(1 - index * index);
        for (int step = 0; step < 4; ++step)
            cosine = std::nextafter(cosine, 0);
        for (int step = 0; step < 9; ++step) {
            worst.see(reference::fresnel(cosine, index),
                      static_cast<long double>(fresnel_exactly(cosine, index)), 1);
            cosine = std::nextafter(cosine, 1);
        }
    }
    return worst.result();
}

Case grazing_light() {
    Worst worst("surfaces", "reflectance at grazing incidence, cosines of 1e-12 to 1e-3", fifty,
                14);
    for (const double index : {1.000001, 1.3, 1.5, 2.4})
        for (const double cosine : {0.0, 1e-12, 1e-9, 1e-6, 1e-3})
            worst.see(reference::fresnel(cosine, index),
                      static_cast<long double>(fresnel_exactly(cosine, index)), 1);
    return worst.result();
}

reference::EnergyProblem problem(double albedo, double g, double thickness) {
    return {.albedo = albedo, .anisotropy = g, .optical_thickness = thickness};
}

/// back + through + absorbed + roulette = 1 - specular, whatever chance does.
Case balance(const std::string& area,
             const std::string& what,
             const reference::EnergyProblem& slab) {
    Worst worst(area, what, "what arrives", 12);
    const auto found = reference::slab_energy(slab, {.paths = 2560, .seed = 3});
    worst.see(found.back.value + found.through.value + found.absorbed.value + found.roulette.value,
              1 - static_cast<long double>(found.specular));
    return worst.result();
}

/// What absorbs nothing sends everything back, but for what roulette took or gave.
Case furnace(const std::string& area, const std::string& what, reference::EnergyProblem sphere) {
    Worst worst(area, what, "what arrives", 12);
    sphere.incidence = reference::Incidence::Diffuse;
    const auto found = reference::sphere_energy(sphere, {.paths = 2560, .seed = 4});
    worst.see(found.escape.value + found.roulette.value, 1);
    return worst.result();
}

/// The light of one path that absorbs nothing.
class Escape final : public reference::WalkEvents<1> {
  public:
    void collided(const reference::Path<1>&,
                  const reference::Spectrum<1>&,
                  reference::PathRandom&) override {}

    void met_surface(const reference::Path<1>&,
                     const reference::RoughSurface&,
                     reference::PathRandom&) override {}

    void gambled(const reference::Spectrum<1>& change) override { light_ -= change[0]; }

    void leaked() override {}

    void escaped(const reference::Path<1>& path) override { light_ += path.weight[0]; }

    double taken() { return std::exchange(light_, 0); }

  private:
    double light_ = 0;
};

/// Along axes and diagonals through every vertex of a cube: in its faces, along its edges.
Case corners(const std::string& what, const reference::Boundary& boundary) {
    Worst worst("walks", what, "what arrives", 12);
    const auto cube = geometry::slab(2, 2, 2, 2);
    const auto body = reference::make_mesh_body(cube);
    const auto tracer = body->tracer();
    const auto medium = reference::grey_medium(1, 1, 0, 1.4);
    Escape escape;
    reference::Walk<1> walk(medium, boundary, *body, *tracer, escape);
    std::uint32_t number = 0;
    for (const auto& vertex : cube.positions)
        for (int i = 0; i < 27; ++i) {
            const glm::dvec3 way(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (way == glm::dvec3(0))
                continue;
            const auto direction = glm::normalize(way);
            reference::PathRandom random({5, number++, 0, 0, 0});
            walk.start({.position = vertex - 4.0 * direction, .direction = direction});
            walk.follow(random);
            worst.see(escape.taken(), 1);
        }
    return worst.result();
}

Case dipole_plane() {
    Worst worst("albedo", "dipole's plane, sigma_a = 1e-12 to 1e-3 of sigma_s'", fifty, 14);
    for (const double absorbed : {0.0, 1e-12, 1e-9, 1e-6, 1e-3})
        for (const double index : {1.0, 1.3, 1.5}) {
            const Medium medium{{absorbed, 0, 0}, {1, 1, 1}, index};
            const Real alpha = 1 / (1 + Real(absorbed)), root = sqrt(3 * (1 - alpha));
            const Real mismatch = diffusion::boundary_mismatch(index);
            const Real exact = alpha / 2 * (1 + exp(-4 * mismatch * root / 3)) * exp(-root);
            worst.see(diffusion::plane_total(diffusion::dipoles(medium)[0]),
                      static_cast<long double>(exact));
        }
    return worst.result();
}

Case half_space() {
    Worst worst("albedo", "half-space that absorbs nothing", "what arrives", 6);
    for (const double index : {1.0, 1.3, 1.5})
        worst.see(body_reflectance(1, index, Incidence::Diffuse),
                  1 - static_cast<long double>(reference::diffuse_fresnel(index)));
    return worst.result();
}

} // namespace

void add_transport(std::vector<Case>& cases) {
    cases.push_back(
        furnace("albedo", "furnace: a sphere of radius 10, albedo 1", problem(1, 0, 10)));
    cases.push_back(
        balance("albedo", "balance of a slab of 100, albedo 1 - 1e-6", problem(1 - 1e-6, 0, 100)));
    cases.push_back(balance("albedo", "balance of a half-space, albedo 1 - 1e-3",
                            problem(1 - 1e-3, 0, std::numeric_limits<double>::infinity())));
    cases.push_back(half_space());
    cases.push_back(dipole_plane());
    cases.push_back(
        anisotropies("cosines drawn at g = 0, +-1e-8, +-1e-4", {0, 1e-8, -1e-8, 1e-4, -1e-4}, 14));
    cases.push_back(anisotropies("the same at g = +-0.5, +-0.9", {0.5, -0.5, 0.9, -0.9}, 14));
    cases.push_back(anisotropies("the same at g = +-0.999", {0.999, -0.999}, 12));
    cases.push_back(densities());
    cases.push_back(
        furnace("anisotropy", "furnace: the sphere at g = 0.999", problem(1, 0.999, 10)));
    cases.push_back(balance("anisotropy", "balance of a slab of 100, g = -0.999, albedo 1 - 1e-6",
                            problem(1 - 1e-6, -0.999, 100)));
    cases.push_back(corners("light that comes out of a cube from rays along its edges, matched",
                            {reference::BoundaryKind::Matched}));
    cases.push_back(corners("the same, smooth", {reference::BoundaryKind::Smooth}));
    cases.push_back(critical_angle());
    cases.push_back(grazing_light());
}

} // namespace hard_cases
