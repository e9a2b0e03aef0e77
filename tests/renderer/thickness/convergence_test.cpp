// Thickness of traced meshes tends to the closed form of the body they approximate, at second order
// in the edge length: a facet with edge h lies h^2/8 times the curvature off the surface.
//
// That holds away from grazing.  Where a ray meets the surface at a small angle the facet's depth
// is divided by its sine, and a ray that just misses the body may hit the mesh.  So rays are left
// out whose true length changes by more than 5 times as much as the surface is moved, by 2 %, 0.5 %
// or 0.1 % of the body's size: every steep crossing changes it by 1 to 3 times that.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/body_thickness.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/thickness_field.h"

#include <cmath>
#include <functional>

namespace {

using namespace renderer::geometry;
using renderer::thickness::Kind;

/// True length on the body whose surface is moved outward by `offset`.
using TrueLength = std::function<BodyThickness(glm::dvec3 p, glm::dvec3 s, double offset)>;

double length(Kind kind, const BodyThickness& thickness) {
    return kind == Kind::Sum     ? thickness.sum
           : kind == Kind::First ? thickness.first
                                 : thickness.span;
}

bool is_steep(const TrueLength& truth, glm::dvec3 p, glm::dvec3 s) {
    const double d = truth(p, s, 0).sum;
    for (const double step : {0.02, -0.02, 0.005, -0.005, 0.001, -0.001})
        if (std::abs(truth(p, s, step).sum - d) > 5 * std::abs(step))
            return false;
    return true;
}

/// Root mean square of traced minus true length over the steep rays of all vertices.
double rms_error(const Mesh& mesh, Kind kind, const TrueLength& truth) {
    const auto directions = renderer::harmonics::fibonacci_directions(7, 11).directions;
    const auto traced = renderer::thickness::trace_thickness(mesh, kind, directions);
    EXPECT_TRUE(traced) << traced.error();
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (std::size_t k = 0; k < directions.size(); ++k)
            if (is_steep(truth, mesh.positions[v], directions[k])) {
                const double error = (*traced)[v * directions.size() + k] -
                                     length(kind, truth(mesh.positions[v], directions[k], 0));
                sum += error * error;
                ++count;
            }
    EXPECT_GT(count, traced->size() / 4); // steep rays are the rule
    return std::sqrt(sum / static_cast<double>(count));
}

/// Halving the edge divides the error by 2^order.
double order(double coarse_error, double fine_error) {
    return std::log2(coarse_error / fine_error);
}

void expect_second_order(const Mesh& coarse, const Mesh& fine, Kind kind, const TrueLength& truth) {
    const double coarse_error = rms_error(coarse, kind, truth),
                 fine_error = rms_error(fine, kind, truth);
    EXPECT_GT(fine_error, 1e-5); // far above the 1e-6 of floats: it is the mesh that is measured
    EXPECT_LT(fine_error, 0.01);
    // 2 in the limit; the rays that are left out differ a little between the meshes
    EXPECT_GE(order(coarse_error, fine_error), 1.8) << coarse_error << " -> " << fine_error;
    EXPECT_LE(order(coarse_error, fine_error), 2.2) << coarse_error << " -> " << fine_error;
}

TEST(Convergence, OfASphereIsOfSecondOrder) {
    expect_second_order(sphere(1, 3), sphere(1, 4), Kind::Sum, [](auto p, auto s, double offset) {
        return sphere_thickness(1 + offset, p, s);
    });
}

TEST(Convergence, OfAShellIsOfSecondOrderForEveryKind) {
    const auto truth = [](auto p, auto s, double offset) {
        return shell_thickness(1 + offset, 0.5 - offset, p, s);
    };
    for (const Kind kind : {Kind::Sum, Kind::First, Kind::Span})
        expect_second_order(shell(1, 0.5, 3), shell(1, 0.5, 4), kind, truth);
}

TEST(Convergence, OfATorusIsOfSecondOrder) {
    expect_second_order(
        torus(1, 0.4, 36, 18), torus(1, 0.4, 72, 36), Kind::Sum,
        [](auto p, auto s, double offset) { return torus_thickness(1, 0.4 + offset, p, s); });
}

} // namespace
