// The analytic bodies: closed, facing outward, and near their true volume at second order.
#include "renderer/geometry/bodies.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <set>

namespace {

using namespace renderer::geometry;
constexpr double pi = std::numbers::pi;

/// Every directed edge once and its reverse once: closed, manifold and consistently oriented.
::testing::AssertionResult is_closed_and_manifold(const Mesh& mesh) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (!edges.emplace(t[k], t[(k + 1) % 3]).second)
                return ::testing::AssertionFailure()
                       << "edge " << t[k] << ' ' << t[(k + 1) % 3] << " twice";
    for (const auto& [a, b] : edges)
        if (!edges.contains({b, a}))
            return ::testing::AssertionFailure() << "edge " << a << ' ' << b << " has one side";
    return ::testing::AssertionSuccess();
}

/// V - E + F of a closed mesh, where E = 3F / 2.
long euler_characteristic(const Mesh& mesh) {
    return static_cast<long>(mesh.positions.size()) - static_cast<long>(mesh.triangles.size()) / 2;
}

struct KnownBody {
    std::string name;
    std::function<Mesh(int level)> mesh; ///< edges halve from level to level
    double volume;
    long euler;
};

const std::vector<KnownBody> known_bodies{
    {"sphere", [](int level) { return sphere(1.5, level); }, 4 * pi / 3 * 3.375, 2},
    {"shell", [](int level) { return shell(1, 0.5, level); }, 4 * pi / 3 * (1 - 0.125), 4},
    {"torus", [](int level) { return torus(2, 0.5, 16 << level, 8 << level); },
     2 * pi* pi * 2 * 0.25, 0},
    // 61/4 cells make the arcs' cell counts double, too: 2, 4, 8, 16, 32.
    // Its volume: a box, its six faces, its twelve quarter cylinders and its eight octants of a
    // sphere.
    {"rounded box",
     [](int level) {
         return rounded_box({1.5, 1, 0.75}, 0.5, (61 << level) / 4);
     },
     2.0 * 1 * 0.5 + 2 * 0.5 * (2 * 1 + 1 * 0.5 + 2 * 0.5) + pi * 0.25 * (2 + 1 + 0.5) +
         4 * pi / 3 * 0.125,
     2}};

TEST(Bodies, AreClosedAndManifold) {
    for (const auto& body : known_bodies)
        for (int level = 0; level < 4; ++level) {
            const auto mesh = body.mesh(level);
            EXPECT_TRUE(is_closed_and_manifold(mesh)) << body.name << ", level " << level;
            EXPECT_EQ(euler_characteristic(mesh), body.euler) << body.name << ", level " << level;
        }
}

TEST(Bodies, VolumeConvergesAtSecondOrder) {
    for (const auto& body : known_bodies) {
        double error = body.volume - signed_volume(body.mesh(2));
        EXPECT_GT(error, 0) << body.name << ": a mesh inscribed in a body mostly convex";
        for (int level = 3; level < 5; ++level) {
            const double finer = body.volume - signed_volume(body.mesh(level));
            // Quartered, up to terms of fourth order.
            EXPECT_NEAR(error / finer, 4, 0.1) << body.name << ", level " << level;
            error = finer;
        }
        EXPECT_LE(std::abs(error), 0.003 * body.volume) << body.name;
    }
}

TEST(Bodies, VerticesLieOnTheTrueSurface) {
    for (const auto& p : sphere(3, 3).positions)
        EXPECT_NEAR(glm::length(p), 3, 1e-14 * 3);
    for (const auto& p : torus(2, 0.5, 24, 12).positions)
        EXPECT_NEAR(std::hypot(std::hypot(p.x, p.y) - 2, p.z), 0.5, 1e-14);
    for (const auto& p : rounded_box({2, 1.5, 1}, 0.25, 16).positions) {
        const auto flat =
            glm::clamp(p, -glm::dvec3(1.75, 1.25, 0.75), glm::dvec3(1.75, 1.25, 0.75));
        EXPECT_NEAR(glm::distance(p, flat), 0.25, 1e-14);
    }
}

TEST(Shell, InnerSurfaceFacesTheCavity) {
    const auto mesh = shell(1, 0.5, 2);
    const auto normals = vertex_normals(mesh);
    std::size_t inner = 0;
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const bool is_inner = glm::length(mesh.positions[v]) < 0.75;
        inner += is_inner ? 1 : 0;
        EXPECT_EQ(glm::dot(normals[v], mesh.positions[v]) < 0, is_inner);
    }
    EXPECT_EQ(inner, normals.size() / 2);
}

TEST(Slab, IsExactlyABox) {
    const auto mesh = slab(2, 3, 0.5, 5);
    EXPECT_TRUE(is_closed_and_manifold(mesh));
    EXPECT_EQ(mesh.triangles.size(), 2u * (2 * 5 * 5 + 4 * 5));
    for (const auto& p : mesh.positions)
        EXPECT_EQ(std::abs(p.z), 0.25);
}

TEST(RoundedBox, WithTheRadiusOfItsHalfExtentsIsASphere) {
    const auto mesh = rounded_box({1, 1, 1}, 1, 32);
    EXPECT_TRUE(is_closed_and_manifold(mesh));
    for (const auto& p : mesh.positions)
        EXPECT_NEAR(glm::length(p), 1, 1e-14);
}

TEST(BodiesDeathTest, RefuseImpossibleSizes) {
    EXPECT_DEATH(sphere(0, 1), "radius > 0");
    EXPECT_DEATH(shell(1, 1, 1), "inner_radius < outer_radius");
    EXPECT_DEATH(torus(1, 2, 8, 8), "minor_radius < major_radius");
    EXPECT_DEATH(rounded_box({1, 1, 0.1}, 0.2, 4), "radius <= smallest");
}

} // namespace
