// Worlds whose pictures can be worked out by hand, and Eq. 3 worked out in double.
#pragma once

#include "renderer/camera.h"
#include "renderer/geometry/mesh.h"
#include "renderer/gpu/context.h"
#include "renderer/harmonics/basis.h"
#include "renderer/methods/green.h"
#include "renderer/methods/phong.h"
#include "renderer/methods/separable.h"
#include "renderer/methods/shss.h"
#include "renderer/pictures/picture.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <cmath>
#include <numbers>
#include <optional>

namespace known_worlds {

using namespace renderer;

/// The bodies are 100 mm across, seen from 0 elevation.
inline constexpr Millimetres diameter{100};

/// Thickness of a sphere of radius R at its vertices: zonal about the normal, coefficients of
/// d/R [methods page A6]; band 3 and 5 are empty.
inline thickness::ThicknessField sphere_field(const geometry::Mesh& sphere, double R, int bands) {
    constexpr std::array<double, 6> zonal{1.7724539, -2.0466534, 0.9908318, 0, -0.2215567, 0};
    thickness::ThicknessField field;
    field.bands = bands;
    field.d_n = 2 * R;
    field.energy.assign(sphere.positions.size(), 8 * std::numbers::pi / 3 * R * R);
    std::vector<double> y(static_cast<std::size_t>(bands * bands));
    for (const auto& position : sphere.positions) {
        harmonics::evaluate(bands, glm::normalize(position), y);
        for (int l = 0; l < bands; ++l)
            for (int m = -l; m <= l; ++m)
                field.coefficients.push_back(
                    static_cast<float>(R * zonal[static_cast<std::size_t>(l)] *
                                       std::sqrt(4 * std::numbers::pi / (2 * l + 1)) *
                                       y[static_cast<std::size_t>(harmonics::flat_index(l, m))]));
    }
    return field;
}

/// Distinct k's in every channel, so that swapped terms show.
inline Material colourful_material() {
    return {.medium = {.sigma_a = {0.0021, 0.0041, 0.0071}, .sigma_s_reduced = {2.19, 2.62, 3.0}},
            .reflectance = {.ambient = {0.02F, 0.03F, 0.04F},
                            .diffuse = {0.5F, 0.4F, 0.3F},
                            .specular = {0.2F, 0.25F, 0.3F},
                            .scatter = {0.6F, 0.7F, 0.8F},
                            .shininess = 32}};
}

inline Scene
scene_of(const geometry::Mesh& mesh, glm::dvec3 to_light, const Turntable& table = {}) {
    return {.placement = place(geometry::bounding_sphere(mesh), diameter, table),
            .material = colourful_material(),
            .lights = {{DirectionalLight{to_light}, {0.9F, 1.0F, 1.1F}}},
            .ambient = {1.0F, 0.9F, 0.8F},
            .camera = frame(diameter, table, 1)};
}

/// Toward the scene's first light, which is far away.
inline glm::dvec3 first_to_light(const Scene& scene) {
    return std::get<DirectionalLight>(scene.lights.front().place).to_light;
}

/// Only the scattered light, so that a picture under the paper's law is 1 - d/D_n.
inline void keep_scatter_only(Scene& scene) {
    scene.material.reflectance = {
        .ambient = {}, .diffuse = {}, .specular = {}, .scatter = {1, 1, 1}};
    for (auto& light : scene.lights)
        light.intensity = {1, 1, 1};
}

struct Hit {
    std::size_t triangle;
    glm::dvec3 weights; ///< barycentric
    glm::dvec3 point;   ///< world
    glm::dvec3 eye;     ///< world
};

/// What the centre of a pixel (row from the top) sees, by trying every triangle.
inline std::optional<Hit> seen_by_pixel(
    const geometry::Mesh& mesh, const Scene& scene, int column, int row, int width, int height) {
    const auto world_from_view = glm::inverse(scene.camera.view_from_world);
    const glm::dvec3 eye(world_from_view[3]);
    const glm::dvec4 clip((column + 0.5) / width * 2 - 1, 1 - (row + 0.5) / height * 2, 1, 1);
    const auto far = world_from_view * glm::inverse(scene.camera.clip_from_view) * clip;
    const auto ray = glm::normalize(glm::dvec3(far) / far.w - eye);

    std::optional<Hit> nearest;
    double nearest_t = INFINITY;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        glm::dmat3 corners;
        for (int j = 0; j < 3; ++j)
            corners[j] = glm::dvec3(
                scene.placement.world_from_model *
                glm::dvec4(mesh.positions[mesh.triangles[i][static_cast<std::size_t>(j)]], 1));
        // eye + t ray = a + u (b - a) + v (c - a)
        const glm::dmat3 sides(-ray, corners[1] - corners[0], corners[2] - corners[0]);
        if (glm::determinant(sides) == 0)
            continue;
        const auto tuv = glm::inverse(sides) * (eye - corners[0]);
        const glm::dvec3 weights(1 - tuv.y - tuv.z, tuv.y, tuv.z);
        if (weights.x >= 0 && weights.y >= 0 && weights.z >= 0 && tuv.x > 0 && tuv.x < nearest_t) {
            nearest_t = tuv.x;
            nearest = Hit{i, weights, eye + tuv.x * ray, eye};
        }
    }
    return nearest;
}

inline glm::dvec3 rgb(LinearRgb colour) {
    return {static_cast<double>(colour.r), static_cast<double>(colour.g),
            static_cast<double>(colour.b)};
}

/// Eq. 3 in double, by its words, under the first light; `d` is in mm.
inline glm::dvec3
eq3(const Scene& scene, glm::dvec3 N, glm::dvec3 V, double d, shading::Law law, double d_n) {
    const auto& k = scene.material.reflectance;
    const auto L = glm::normalize(first_to_light(scene));
    const auto I_p = rgb(scene.lights.front().intensity);
    const double cosine = std::max(glm::dot(N, L), 0.0);
    const double highlight = cosine > 0 ? std::pow(std::max(glm::dot(glm::reflect(-L, N), V), 0.0),
                                                   static_cast<double>(k.shininess))
                                        : 0.0;
    const auto sigma_tr = effective_transport(scene.material.medium);
    d = std::clamp(d, 0.0, diameter.value);
    const auto T = law == shading::Law::Paper
                       ? glm::dvec3(1 - std::min(d / d_n, 1.0))
                       : glm::exp(-d * glm::dvec3(sigma_tr.r, sigma_tr.g, sigma_tr.b));
    return rgb(scene.ambient) * rgb(k.ambient) +
           I_p * (rgb(k.diffuse) * cosine + rgb(k.specular) * highlight + rgb(k.scatter) * T);
}

/// Phong has no settings.
struct PhongSettings {};

/// A method from its settings, whichever it is; the field is the caller's.
using Made = Expected<std::unique_ptr<methods::Method>>;
using SharedSurface = std::shared_ptr<const shading::Surface>;

inline Made make(PhongSettings, SharedSurface surface, const thickness::ThicknessField*) {
    return methods::prepare_phong(std::move(surface));
}

inline Made make(const methods::GreenSettings& settings,
                 SharedSurface surface,
                 const thickness::ThicknessField* field) {
    return methods::prepare_green(settings, std::move(surface), field);
}

inline Made make(const methods::SeparableSettings& settings,
                 SharedSurface surface,
                 const thickness::ThicknessField* field) {
    return methods::prepare_separable(settings, std::move(surface), field);
}

inline Made make(const methods::ShssSettings& settings,
                 SharedSurface surface,
                 const thickness::ThicknessField* field) {
    return methods::prepare_shss(
        settings, std::move(surface),
        field == nullptr ? nullptr : std::make_shared<const thickness::ThicknessField>(*field));
}

/// A context, and room to prepare methods in it.
class MethodTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(context_) << context_.error(); }

    template <class Settings>
    std::unique_ptr<methods::Method> prepare(const geometry::Mesh& mesh,
                                             const Settings& settings,
                                             const thickness::ThicknessField* field = nullptr) {
        auto surface = shading::Surface::upload(mesh);
        EXPECT_TRUE(surface) << surface.error();
        auto method = make(settings, *surface, field);
        EXPECT_TRUE(method) << method.error();
        return std::move(*method);
    }

    template <class Settings>
    imaging::LinearImage picture(const geometry::Mesh& mesh,
                                 const Settings& settings,
                                 const Scene& scene,
                                 int size,
                                 int samples = 1,
                                 const thickness::ThicknessField* field = nullptr) {
        const auto method = prepare(mesh, settings, field);
        const auto image = pictures::render_picture(*method, scene, size, size, samples);
        EXPECT_TRUE(image) << image.error();
        return *image;
    }

    static LinearRgb pixel(const imaging::LinearImage& image, int column, int row) {
        return image.pixels.at(static_cast<std::size_t>(row * image.width + column));
    }

    Expected<gpu::Context> context_ = gpu::Context::surfaceless();
};

} // namespace known_worlds
