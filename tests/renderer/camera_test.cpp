#include "renderer/camera.h"

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <cmath>

namespace {

using namespace renderer;

constexpr geometry::BoundingSphere model{.centre = {3, -2, 7}, .radius = 5};

glm::dvec3 placed(const Turntable& table, glm::dvec3 offset_from_centre) {
    const auto placement = place(model, Millimetres{100}, table);
    return glm::dvec3(placement.world_from_model *
                      glm::dvec4(model.centre + offset_from_centre, 1));
}

void expect_near(glm::dvec3 found, glm::dvec3 expected) {
    EXPECT_LE(glm::length(found - expected), 1e-12 * 100)
        << found.x << ' ' << found.y << ' ' << found.z;
}

TEST(Place, ScalesTheBoundingSphereToItsDiameterAroundTheOrigin) {
    expect_near(placed({}, {0, 0, 0}), {0, 0, 0});
    expect_near(placed({}, {5, 0, 0}), {50, 0, 0});
}

TEST(Place, TurnsCounterClockwiseSeenFromAbove) {
    // What faced the camera turns toward the right.
    expect_near(placed({.turn_degrees = 90}, {0, 0, 5}), {50, 0, 0});
}

TEST(Place, StandsTheModelUpright) {
    expect_near(placed({.up = {0, 0, 1}}, {0, 0, 5}), {0, 50, 0});
    expect_near(placed({.up = {0, 0, 1}}, {0, -5, 0}), {0, 0, 50}); // what looked along -y faces us
    expect_near(placed({.up = {0, -1, 0}}, {0, -5, 0}), {0, 50, 0});
    expect_near(placed({.up = {0, -1, 0}}, {0, 0, 5}), {0, 0, 50}); // and still faces us
    expect_near(placed({.up = {2, 0, 0}}, {5, 0, 0}), {0, 50, 0});
}

TEST(Place, KeepsHandedness) {
    for (const auto& up : {glm::dvec3(0, 1, 0), glm::dvec3(0, -1, 0), glm::dvec3(1, 2, 3)}) {
        const auto x = placed({.turn_degrees = 33, .up = up}, {5, 0, 0});
        const auto y = placed({.turn_degrees = 33, .up = up}, {0, 5, 0});
        const auto z = placed({.turn_degrees = 33, .up = up}, {0, 0, 5});
        EXPECT_NEAR(glm::dot(glm::cross(x, y), z), 50 * 50 * 50, 1e-6);
    }
}

glm::dvec3 on_screen(const Camera& camera, glm::dvec3 world) {
    const auto clip = camera.clip_from_view * camera.view_from_world * glm::dvec4(world, 1);
    return glm::dvec3(clip) / clip.w;
}

TEST(Frame, ShowsTheWholeSphereWithASmallMarginWhateverTheAspect) {
    for (const double aspect : {0.5, 1.0, 1.6, 3.0})
        for (const double elevation : {-90.0, 0.0, 35.0, 90.0}) {
            const auto camera = frame(Millimetres{100}, {.elevation_degrees = elevation}, aspect);
            double farthest_out = 0;
            for (int i = 0; i < 1000; ++i) {
                const double z = 1 - (2 * i + 1) / 1000.0, angle = 2.399963 * i;
                const double rho = std::sqrt(1 - z * z);
                const auto p = on_screen(
                    camera, 50.0 * glm::dvec3(rho * std::cos(angle), rho * std::sin(angle), z));
                farthest_out = std::max({farthest_out, std::abs(p.x), std::abs(p.y)});
                EXPECT_LE(std::abs(p.z), 1); // between the near and far planes
            }
            EXPECT_LT(farthest_out, 1);
            EXPECT_GT(farthest_out, 0.94);
        }
}

TEST(Frame, LooksDownFromAPositiveElevation) {
    const auto camera = frame(Millimetres{100}, {.elevation_degrees = 90}, 1);
    EXPECT_LT(on_screen(camera, {0, 50, 0}).z, on_screen(camera, {0, -50, 0}).z); // nearer
    EXPECT_GT(on_screen(camera, {0, 0, -50}).y, 0.5); // what was behind is at the top
}

TEST(WorldFromViewAxes, FollowsTheCamera) {
    const auto level = frame(Millimetres{100}, {}, 1);
    expect_near(world_from_view_axes(level, {0, 0, 1}), {0, 0, 1});
    const auto above = frame(Millimetres{100}, {.elevation_degrees = 90}, 1);
    expect_near(world_from_view_axes(above, {0, 0, 1}), {0, 1, 0});
    expect_near(world_from_view_axes(above, {0, 1, 0}), {0, 0, -1});
    expect_near(world_from_view_axes(above, {1, 0, 0}), {1, 0, 0});
}

} // namespace
