#include "renderer/geometry/bodies.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/harmonics/directions.h"

#include <glm/geometric.hpp>

namespace {

using namespace renderer::geometry;

// Stopping at the first hit must answer what collecting all hits answers.
TEST(RayScene, IsOccludedWhereThereIsAHit) {
    const RayScene scene(torus(5, 2, 40, 20));
    const auto set = renderer::harmonics::fibonacci_directions(400, 7);
    std::vector<Hit> hits;
    int blocked = 0, open = 0;
    for (const glm::vec3 origin :
         {glm::vec3(0), glm::vec3(0.1F, 0.2F, 0.3F), glm::vec3(0.35F, 0, 0)})
        for (const auto& direction : set.directions) {
            scene.all_hits(origin, glm::vec3(direction), 0, hits);
            EXPECT_EQ(scene.is_occluded(origin, glm::vec3(direction), 0), !hits.empty());
            ++(hits.empty() ? open : blocked);
        }
    EXPECT_GT(blocked, 100);
    EXPECT_GT(open, 100);
}

// A ring around the origin, its tube from 3 to 7 of 14: along x it is met at 3/14 and at 7/14.
TEST(RayScene, LooksNoNearerThanItIsTold) {
    const RayScene scene(torus(5, 2, 400, 200));
    EXPECT_TRUE(scene.is_occluded({0, 0, 0}, {1, 0, 0}, 0));
    EXPECT_TRUE(scene.is_occluded({0, 0, 0}, {1, 0, 0}, 0.4F));
    EXPECT_FALSE(scene.is_occluded({0, 0, 0}, {1, 0, 0}, 0.51F));
    EXPECT_FALSE(scene.is_occluded({0, 0, 0}, {0, 0, 1}, 0));
}

// A diameter of 14 around the point (100, 0, -3).
TEST(RayScene, IsTheModelAroundTheOriginAndOneAcross) {
    auto mesh = torus(5, 2, 40, 20);
    for (auto& position : mesh.positions)
        position += glm::dvec3(100, 0, -3);
    const RayScene scene(mesh);
    EXPECT_NEAR(scene.model_from_scene({0.5, 0, 0}).x, 107, 1e-9);
    EXPECT_NEAR(scene.scene_from_model({100, 7, -3}).y, 0.5, 1e-9);
    const glm::dvec3 place(0.1, -0.2, 0.3);
    EXPECT_LE(glm::distance(scene.scene_from_model(scene.model_from_scene(place)), place), 1e-14);
}

} // namespace
