#include "renderer/geometry/bodies.h"
#include "renderer/methods/catalogue.h"
#include "renderer/methods/jensen.h"
#include "renderer/methods/prt.h"
#include "tests/renderer/methods/known_worlds.h"

#include <functional>

namespace {

using namespace known_worlds;
using diffusion::DipoleBody;
using transfer::CompressedSignals;
using transfer::TransferField;

/// Thin enough for a body of 100 mm to need few samples.
const renderer::Medium milky{{0.02, 0.03, 0.04}, {0.2, 0.2, 0.2}, 1.3};

/// Numbers that differ in every vertex, channel and coefficient; nothing about them is symmetric.
TransferField some_transfer(const geometry::Mesh& mesh, int bands) {
    TransferField field{.bands = bands};
    const auto n = static_cast<std::size_t>(3 * bands * bands);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (std::size_t i = 0; i < n; ++i)
            field.transfer.push_back(static_cast<float>(
                0.3 / static_cast<double>(1 + i % (n / 3)) +
                0.1 * std::sin(mesh.positions[v].x * static_cast<double>(i + 1)) +
                0.05 * std::cos(mesh.positions[v].z * static_cast<double>(i))));
    return field;
}

/// pi I_p y_i(L) of all lights, per channel, in the model's axes.
std::array<std::vector<double>, 3> light_of(const Scene& scene, int bands) {
    std::array<std::vector<double>, 3> light;
    light.fill(std::vector<double>(static_cast<std::size_t>(bands * bands)));
    for (const auto& one : scene.lights) {
        const auto& L = std::get<DirectionalLight>(one.place).to_light;
        std::vector<double> y(light[0].size());
        harmonics::evaluate(
            bands, glm::normalize(glm::inverse(glm::dmat3(scene.placement.world_from_model)) * L),
            y);
        const auto I_p = rgb(one.intensity);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < y.size(); ++i)
                light[c][i] += std::numbers::pi * I_p[static_cast<int>(c)] * y[i];
    }
    return light;
}

glm::dvec3 radiance_at(std::span<const float> transfer,
                       const std::array<std::vector<double>, 3>& light) {
    glm::dvec3 sum(0);
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < light[c].size(); ++i)
            sum[static_cast<int>(c)] +=
                light[c][i] * static_cast<double>(transfer[c * light[c].size() + i]);
    return glm::max(sum, glm::dvec3(0));
}

class Prt : public MethodTest {
  protected:
    static constexpr int size = 40;

    std::shared_ptr<const shading::Surface> surface(const geometry::Mesh& mesh) {
        auto made = shading::Surface::upload(mesh);
        EXPECT_TRUE(made) << made.error();
        return *made;
    }

    imaging::LinearImage drawn(Expected<std::unique_ptr<methods::Method>> method,
                               const Scene& scene) {
        EXPECT_TRUE(method) << method.error();
        const auto image = pictures::render_picture(**method, scene, size, size, 1);
        EXPECT_TRUE(image) << image.error();
        return *image;
    }

    /// Compares drawn pixels with the radiance of the vertices, interpolated, plus the ambient and
    /// specular terms of Eq. 3.
    void expect_radiance(const imaging::LinearImage& image,
                         const geometry::Mesh& mesh,
                         Scene scene,
                         const std::function<glm::dvec3(std::size_t)>& radiance) {
        scene.material.reflectance.diffuse = {}; // Eq. 3 without the terms that PRT does not have
        scene.material.reflectance.scatter = {};
        const auto normals = geometry::vertex_normals(mesh);
        const glm::dmat3 A(scene.placement.world_from_model);
        int checked = 0;
        for (int row = 3; row < size; row += 6)
            for (int column = 1; column < size; column += 6) {
                const auto hit = seen_by_pixel(mesh, scene, column, row, size, size);
                if (!hit)
                    continue;
                glm::dvec3 N(0), body(0);
                for (std::size_t j = 0; j < 3; ++j) {
                    const auto vertex = mesh.triangles[hit->triangle][j];
                    const double weight = hit->weights[static_cast<int>(j)];
                    N += weight * glm::normalize(glm::transpose(glm::inverse(A)) * normals[vertex]);
                    body += weight * radiance(vertex);
                }
                const auto V = glm::normalize(hit->eye - hit->point);
                glm::dvec3 expected = body;
                for (std::size_t i = 0; i < scene.lights.size(); ++i) {
                    Scene one = scene;
                    one.lights = {scene.lights[i]};
                    if (i > 0)
                        one.ambient = {};
                    expected += eq3(one, glm::normalize(N), V, 0, shading::Law::Physical, 1);
                }
                const auto colour = rgb(pixel(image, column, row));
                for (int c = 0; c < 3; ++c) // float32, as for the other methods, times sums of 36
                    EXPECT_NEAR(colour[c], expected[c], 2e-4) << column << ' ' << row;
                ++checked;
            }
        EXPECT_GT(checked, 10);
    }
};

TEST_F(Prt, DrawsTransferTimesLightWithEveryNumberOfBands) {
    const auto mesh = geometry::sphere(2, 3);
    for (int bands = 1; bands <= 6; ++bands) {
        SCOPED_TRACE(bands);
        const auto field = some_transfer(mesh, bands);
        const auto scene =
            scene_of(mesh, {0.3, 0.2, 0.9}, {.turn_degrees = 50, .elevation_degrees = 20});
        const auto light = light_of(scene, bands);
        const auto n = 3 * light[0].size();
        expect_radiance(drawn(methods::prepare_prt(surface(mesh), field), scene), mesh, scene,
                        [&](std::size_t v) {
                            return radiance_at(std::span(field.transfer).subspan(v * n, n), light);
                        });
    }
}

// Vertices are clamped after all lights have been added: where one light's sum is negative it still
// counts against the others'.
TEST_F(Prt, LightsAddUpBeforeAnythingIsClamped) {
    const auto mesh = geometry::sphere(2, 3);
    const auto field = some_transfer(mesh, 5);
    auto scene = scene_of(mesh, {0.3, 0.2, 0.9});
    scene.lights.push_back({DirectionalLight{{-0.8, 0.1, -0.3}}, {0.2F, 0.7F, 0.4F}});
    scene.lights.push_back({DirectionalLight{{0, 1, 0}}, {0.5F, 0.1F, 0.3F}});
    const auto light = light_of(scene, 5);
    expect_radiance(drawn(methods::prepare_prt(surface(mesh), field), scene), mesh, scene,
                    [&](std::size_t v) {
                        return radiance_at(std::span(field.transfer).subspan(v * 75, 75), light);
                    });
}

TEST_F(Prt, CompressedTransferIsDrawnAsItDecompresses) {
    const auto mesh = geometry::sphere(2, 3);
    const auto field = some_transfer(mesh, 5);
    for (const auto& [clusters, vectors] :
         {std::pair{12u, 6u}, std::pair{5u, 3u}, std::pair{256u, 15u}, std::pair{40u, 0u}}) {
        SCOPED_TRACE(vectors);
        const auto signals =
            transfer::compress(field.transfer, 75, {.clusters = clusters, .vectors = vectors});
        const auto scene = scene_of(mesh, {-0.3, 0.2, 0.9}, {.turn_degrees = 20});
        const auto light = light_of(scene, 5);
        std::vector<float> row(75);
        expect_radiance(drawn(methods::prepare_prt(surface(mesh), signals, 5), scene), mesh, scene,
                        [&](std::size_t v) {
                            decompress(signals, v, row);
                            return radiance_at(row, light);
                        });
    }
}

TEST_F(Prt, EqualLightsAreOneOfTheirSum) {
    const auto mesh = geometry::sphere(2, 3);
    const auto field = some_transfer(mesh, 5);
    auto scene = scene_of(mesh, {0.3, 0.2, 0.9});
    auto sum = scene;
    auto& i = sum.lights.front().intensity;
    i = {4 * i.r, 4 * i.g, 4 * i.b};
    scene.lights.assign(4, scene.lights.front());
    const auto one = drawn(methods::prepare_prt(surface(mesh), field), sum);
    const auto many = drawn(methods::prepare_prt(surface(mesh), field), scene);
    for (std::size_t p = 0; p < one.pixels.size(); ++p)
        ASSERT_NEAR(one.pixels[p].g, many.pixels[p].g, 1e-6F * std::max(1.0F, one.pixels[p].g));
}

TEST_F(Prt, RefusesTransferOfAnotherMesh) {
    const auto mesh = geometry::sphere(2, 2), other = geometry::sphere(2, 1);
    const auto whole = methods::prepare_prt(surface(mesh), some_transfer(other, 5));
    ASSERT_FALSE(whole);
    EXPECT_EQ(whole.error(), "a transfer field of 3150 numbers, expected 12150 for 162 vertices");
    const auto signals = transfer::compress(some_transfer(other, 5).transfer, 75, {.clusters = 4});
    EXPECT_FALSE(methods::prepare_prt(surface(mesh), signals, 5));
    EXPECT_FALSE(methods::prepare_prt(surface(other), signals, 4));
}

TEST(PrtDials, MustGoTogether) {
    const auto problem_of = [](const methods::Dials& dials) {
        const auto complete = methods::complete_for("prt", dials);
        return complete ? std::string() : complete.error().dial + ' ' + complete.error().what;
    };
    EXPECT_EQ(problem_of({}), "");
    EXPECT_EQ(problem_of({{"vectors", std::int64_t{6}}}), "");
    EXPECT_EQ(problem_of({{"directions", std::int64_t{49}}}),
              "directions is 49, expected at least 50, two for each coefficient of 5 bands");
    EXPECT_EQ(problem_of({{"vectors", std::int64_t{7}}, {"clusters", std::int64_t{513}}}),
              "clusters is 513 with 7 vectors each, expected at most 512");
    EXPECT_EQ(problem_of({{"vectors", std::int64_t{4}}, {"bands", std::int64_t{1}}}),
              "vectors is 4, expected at most 3, the length of a transfer vector of 1 bands");
}

// From dials to picture, at the size that the placement tells.
TEST_F(Prt, IsMadeFromDialsForTheBodysSize) {
    const auto mesh = geometry::sphere(1, 2);
    auto scene = scene_of(mesh, {0, 0, 1});
    scene.material.medium = milky;
    const methods::Subject subject{.mesh = mesh,
                                   .surface = surface(mesh),
                                   .material = scene.material,
                                   .placement = scene.placement,
                                   .field = {},
                                   .progress = {}};
    const auto method = methods::prepare_method(
        "prt", {{"directions", std::int64_t{128}}, {"bands", std::int64_t{3}}}, subject);
    ASSERT_TRUE(method) << method.error();
    const auto field =
        transfer::compute_transfer_field(mesh, milky, 50, {.bands = 3, .directions = 128});
    ASSERT_TRUE(field) << field.error();
    const auto light = light_of(scene, 3);
    const auto image = pictures::render_picture(**method, scene, size, size, 1);
    ASSERT_TRUE(image) << image.error();
    expect_radiance(*image, mesh, scene, [&](std::size_t v) {
        return radiance_at(std::span(field->transfer).subspan(v * 27, 27), light);
    });
}

using Jensen = Prt;

TEST_F(Jensen, DrawsTheDipolesRadianceUnderAllLights) {
    const auto mesh = geometry::sphere(2, 3);
    auto scene = scene_of(mesh, {0.3, 0.2, 0.9}, {.turn_degrees = 50});
    scene.lights.push_back({DirectionalLight{{-0.8, 0.1, -0.3}}, {0.2F, 0.7F, 0.4F}});
    scene.material.medium = milky;
    const DipoleBody body(mesh, milky, 25);
    std::vector<glm::dvec3> radiance(mesh.positions.size());
    for (const auto& light : scene.lights) {
        const auto& L = std::get<DirectionalLight>(light.place).to_light;
        const auto share = body.exit_radiance(
            glm::normalize(glm::inverse(glm::dmat3(scene.placement.world_from_model)) * L));
        for (std::size_t v = 0; v < radiance.size(); ++v)
            radiance[v] += std::numbers::pi * rgb(light.intensity) * glm::dvec3(share[v]);
    }
    expect_radiance(
        drawn(methods::prepare_jensen(surface(mesh), std::make_unique<DipoleBody>(mesh, milky, 25)),
              scene),
        mesh, scene, [&](std::size_t v) { return radiance[v]; });
}

// A light a hundred diameters away is a far one.
TEST_F(Jensen, ANearLightIsTakenFromTheCentre) {
    const auto mesh = geometry::sphere(2, 3);
    auto far = scene_of(mesh, {0.6, 0, 0.8}), near = far;
    near.lights.front().place = PointLight{{6000, 0, 8000}, Millimetres{10000}};
    const auto make = [&] {
        return methods::prepare_jensen(surface(mesh),
                                       std::make_unique<DipoleBody>(mesh, milky, 25));
    };
    const auto a = drawn(make(), far), b = drawn(make(), near);
    for (std::size_t p = 0; p < a.pixels.size(); ++p)
        ASSERT_NEAR(a.pixels[p].g, b.pixels[p].g, 0.02F * std::max(0.1F, a.pixels[p].g));
}

} // namespace
