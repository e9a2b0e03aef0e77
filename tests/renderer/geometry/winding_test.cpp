#include "renderer/geometry/bodies.h"
#include "renderer/geometry/winding.h"

#include <cmath>
#include <utility>

namespace {

using namespace renderer::geometry;

double winding_of(const Mesh& mesh, glm::dvec3 point) {
    const std::vector<glm::vec3> positions(mesh.positions.begin(), mesh.positions.end());
    return winding_number(positions, mesh.triangles, point);
}

// A sum of some hundred arctangents over positions rounded to float, which stay closed.
TEST(WindingNumber, IsOneInsideAndNoneOutside) {
    const Mesh ball = sphere(1, 2);
    EXPECT_NEAR(winding_of(ball, {0, 0, 0}), 1, 1e-12);
    EXPECT_NEAR(winding_of(ball, {0.3, -0.4, 0.7}), 1, 1e-12);
    EXPECT_NEAR(winding_of(ball, {0.9, 0.9, 0.9}), 0, 1e-12);
}

// Every turn is kept apart, and so many small numbers neither vanish nor overflow.
TEST(WindingNumber, CountsEveryLayer) {
    Mesh layers = sphere(1, 3);
    const auto once = layers.triangles;
    for (int i = 1; i < 7; ++i)
        layers.triangles.insert(layers.triangles.end(), once.begin(), once.end());
    EXPECT_NEAR(winding_of(layers, {0.2, 0.5, -0.1}), 7, 1e-10);
    for (auto& t : layers.triangles)
        std::swap(t[0], t[1]);
    EXPECT_NEAR(winding_of(layers, {0.2, 0.5, -0.1}), -7, 1e-10);
}

TEST(WindingNumber, IsNoneInACavity) {
    const Mesh hollow = shell(1, 0.5, 2);
    EXPECT_NEAR(winding_of(hollow, {0.1, 0.1, 0}), 0, 1e-12);
    EXPECT_NEAR(winding_of(hollow, {0.7, 0, 0}), 1, 1e-12);
}

TEST(WindingNumber, HardlyChangesBehindASmallHole) {
    Mesh pierced = sphere(1, 3);
    pierced.triangles.pop_back(); // one of 1280: a solid angle of 1/1280
    EXPECT_NEAR(winding_of(pierced, {0, 0, 0}), 1 - 1.0 / 1280, 3e-4);
}

TEST(WindingNumber, OfACubeSeenFromItsCornerIsAnEighth) {
    EXPECT_NEAR(winding_of(slab(2, 2, 2, 1), {1, 1, 1}), 0.125, 1e-12);
}

} // namespace
