#include "renderer/geometry/bodies.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/harmonics/directions.h"

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

} // namespace
