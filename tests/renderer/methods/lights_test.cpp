// Several lights, near lights: light adds up, and a near light far away is a far one.
#include "renderer/geometry/bodies.h"
#include "tests/renderer/methods/known_worlds.h"

#include <glm/ext/matrix_transform.hpp>

namespace {

using namespace known_worlds;
using methods::ShssSettings;
using shading::Law;

class Lights : public MethodTest {
  protected:
    static constexpr int size = 32;

    /// The largest difference of two pictures, over channels and pixels.
    static double difference(const imaging::LinearImage& a, const imaging::LinearImage& b) {
        double largest = 0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            const auto apart = glm::abs(rgb(a.pixels[i]) - rgb(b.pixels[i]));
            largest = std::max({largest, apart.x, apart.y, apart.z});
        }
        return largest;
    }

    /// The same, drawn by every method: `compare` gets a function from scene to picture.
    template <class Compare>
    void with_every_method(Compare compare) {
        const auto field = sphere_field(sphere_, 1, 5);
        compare("phong",
                [&](const Scene& scene) { return picture(sphere_, PhongSettings{}, scene, size); });
        compare("green", [&](const Scene& scene) {
            return picture(sphere_, methods::GreenSettings{.depth_map = 256}, scene, size);
        });
        compare("shss", [&](const Scene& scene) {
            return picture(sphere_, ShssSettings{}, scene, size, 1, &field);
        });
    }

    const geometry::Mesh sphere_ = geometry::sphere(1, 4);
};

TEST_F(Lights, AddUp) {
    const Light behind{DirectionalLight{{0.2, 0.1, -1}}, {0.5F, 0.6F, 0.7F}};
    const Light left{DirectionalLight{{-1, 0.3, 0.4}}, {0.3F, 0.2F, 0.1F}};
    with_every_method([&](const char* name, const auto& draw) {
        auto scene = scene_of(sphere_, {0, 0, 1});
        scene.lights = {behind, left};
        const auto both = draw(scene);
        scene.lights = {behind};
        auto sum = draw(scene);
        scene.lights = {left};
        scene.ambient = {}; // counted once
        const auto other = draw(scene);
        for (std::size_t i = 0; i < sum.pixels.size(); ++i) {
            sum.pixels[i].r += other.pixels[i].r;
            sum.pixels[i].g += other.pixels[i].g;
            sum.pixels[i].b += other.pixels[i].b;
        }
        // Sums below 2 in float32, a few roundings of 1.2e-7.
        EXPECT_LE(difference(both, sum), 1e-6) << name;
    });
}

TEST_F(Lights, ThatAreEightOfAKindAreOneOfEightfoldIntensity) {
    with_every_method([&](const char* name, const auto& draw) {
        auto scene = scene_of(sphere_, {0.3, 0.2, -0.9});
        const auto one = draw(scene);
        auto& light = scene.lights.front();
        light.intensity = {light.intensity.r / 8, light.intensity.g / 8, light.intensity.b / 8};
        scene.lights.resize(8, light);
        EXPECT_LE(difference(one, draw(scene)), 1e-6) << name;
    });
}

TEST_F(Lights, ThatAreNearActFromAfarLikeFarOnes) {
    const auto field = sphere_field(sphere_, 1, 5);
    const auto L = glm::normalize(glm::dvec3(0.3, 0.4, -0.8));
    auto scene = scene_of(sphere_, L);
    const auto far = picture(sphere_, ShssSettings{}, scene, size, 1, &field);
    scene.lights.front().place = PointLight{1e6 * L, Millimetres{1e6}};
    const auto near = picture(sphere_, ShssSettings{}, scene, size, 1, &field);
    // Over 50 mm a kilometre away, directions change by 5e-5 and squared distances by 1e-4.
    EXPECT_LE(difference(far, near), 3e-4);
    const imaging::LinearImage black{.width = size,
                                     .height = size,
                                     .pixels = std::vector<LinearRgb>(near.pixels.size()),
                                     .coverage = near.coverage};
    EXPECT_GT(difference(near, black), 0.2); // and not for lack of light
}

TEST_F(Lights, ThatAreNearFallWithTheSquaredDistance) {
    auto scene = scene_of(sphere_, {0, 0, 1});
    scene.material.reflectance = {
        .ambient = {}, .diffuse = {0.5F, 0.5F, 0.5F}, .specular = {}, .scatter = {}};
    const auto at = [&](double z) {
        scene.lights = {{PointLight{{0, 0, z}, Millimetres{100}}, {1, 1, 1}}};
        return rgb(pixel(picture(sphere_, PhongSettings{}, scene, 65), 32, 32)).g;
    };
    // The point that faces the light stands at z = 50 mm.
    EXPECT_NEAR(at(150), 0.5, 1e-4);
    EXPECT_NEAR(at(250), 0.5 / 4, 1e-4);
    EXPECT_NEAR(at(100), 0.5 * 4, 4e-4);
}

/// Thickness toward a near light in double, vertex by vertex, against what is drawn from floats and
/// from bytes.
TEST_F(Lights, ThatAreNearSeeEveryVertexFromTheirOwnPlace) {
    auto field = sphere_field(sphere_, 1, 5);
    for (std::size_t i = 0; i < field.coefficients.size(); ++i)
        field.coefficients[i] += 0.02F * static_cast<float>(i % 25); // no axis is spared
    auto scene = scene_of(sphere_, {0, 0, 1}, {.turn_degrees = 40, .elevation_degrees = 10});
    scene.placement.world_from_model =
        glm::scale(scene.placement.world_from_model, {1.0, 0.6, 0.8});
    const glm::dvec3 place(20, 30, -90);
    scene.lights = {{PointLight{place, Millimetres{100}}, {1, 1, 1}}};
    keep_scatter_only(scene);
    const auto& world_from_model = scene.placement.world_from_model;
    const double d_n = field.d_n * std::cbrt(glm::determinant(glm::dmat3(world_from_model)));
    std::vector<double> y(25);
    for (const auto type : {thickness::ComponentType::Float32, thickness::ComponentType::Int8}) {
        const auto image = picture(sphere_, ShssSettings{.law = Law::Paper, .coefficients = type},
                                   scene, size, 1, &field);
        const auto stored = thickness::coefficients_of(thickness::band_streams(field, 5, type));
        int checked = 0;
        for (int row = 2; row < size; row += 4)
            for (int column = 1; column < size; column += 4) {
                const auto hit = seen_by_pixel(sphere_, scene, column, row, size, size);
                if (!hit)
                    continue;
                double d = 0;
                for (std::size_t j = 0; j < 3; ++j) {
                    const auto vertex = sphere_.triangles[hit->triangle][j];
                    const auto& p = sphere_.positions[vertex];
                    const auto way =
                        glm::dvec3(glm::inverse(world_from_model) * glm::dvec4(place, 1)) - p;
                    harmonics::evaluate(5, glm::normalize(way), y);
                    double toward = 0;
                    for (std::size_t i = 0; i < 25; ++i)
                        toward += y[i] * static_cast<double>(stored[25 * vertex + i]);
                    const auto world_way = place - glm::dvec3(world_from_model * glm::dvec4(p, 1));
                    d += hit->weights[static_cast<int>(j)] * std::min(toward, glm::length(way)) *
                         glm::length(world_way) / glm::length(way);
                }
                const auto way = place - hit->point;
                const double falloff = 100.0 * 100.0 / glm::dot(way, way);
                const double expected = falloff * (1 - std::clamp(d / d_n, 0.0, 1.0));
                // Float32 harmonics of 5 bands: 7e-7 of values up to 2; d/D_n to 1e-5.
                EXPECT_NEAR(rgb(pixel(image, column, row)).g, expected, 1e-4 * falloff)
                    << column << ' ' << row;
                ++checked;
            }
        EXPECT_GT(checked, 15);
    }
}

// A light inside the body is never farther than it is.
TEST_F(Lights, InsideTheBodyCapTheThicknessAtTheirDistance) {
    auto field = sphere_field(sphere_, 1, 1);
    for (auto& c : field.coefficients)
        c = 100; // everything is far thicker than the way to the light
    auto scene = scene_of(sphere_, {0, 0, 1});
    scene.lights = {{PointLight{{0, 0, 40}, Millimetres{10}}, {1, 1, 1}}};
    keep_scatter_only(scene);
    field.d_n = 0.4; // 20 mm
    const auto image = picture(sphere_, ShssSettings{.bands = {.bands = 1}, .law = Law::Paper},
                               scene, 65, 1, &field);
    // 10 mm under the surface, where the intensity is what it says; the sphere's mesh lies up to
    // 0.1 mm inside the sphere.
    EXPECT_NEAR(rgb(pixel(image, 32, 32)).g, 0.5, 0.01);
}

TEST_F(Lights, AreCountedAndChecked) {
    const auto error = [&](const std::vector<Light>& lights) {
        auto scene = scene_of(sphere_, {0, 0, 1});
        scene.lights = lights;
        const auto image =
            pictures::render_picture(*prepare(sphere_, PhongSettings{}), scene, 8, 8, 1);
        return image ? std::string("none") : image.error();
    };
    EXPECT_EQ(error({}), "0 lights, expected 1 to 8");
    EXPECT_EQ(error(std::vector<Light>(9)), "9 lights, expected 1 to 8");
    EXPECT_EQ(error({{PointLight{{NAN, 0, 0}}, {}}}),
              "light position (nan, 0, 0), expected finite numbers");
    EXPECT_EQ(error({{PointLight{{0, 0, 1}, Millimetres{0}}, {}}}),
              "a light's reference distance is 0 mm, expected > 0");
}

} // namespace
