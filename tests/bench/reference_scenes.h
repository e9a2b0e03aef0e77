// What the reference is measured on: the nine pictures of the study shss-2012, and the three scenes
// it is compared with another renderer on.
#pragma once

#include "renderer/camera.h"
#include "renderer/geometry/bodies.h"
#include "renderer/materials.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/path_tracer.h"
#include "tests/bench/models.h"

#include <glm/geometric.hpp>

#include <string>
#include <vector>

namespace bench {

struct NamedPicture {
    std::string name;
    renderer::reference::Picture picture;
};

inline renderer::reference::Illumination sun_toward(glm::dvec3 to_light) {
    return {.suns = {{glm::normalize(to_light), {1, 1, 1}}}};
}

inline const renderer::reference::Illumination even_sky{.sky = {1, 1, 1}};

/// Albedo 0.9, isotropic, no boundary; lengths in mean free paths.
inline renderer::reference::Picture
grey_picture(const renderer::geometry::Mesh& mesh,
             double diameter,
             double turn_degrees,
             const renderer::reference::Illumination& illumination) {
    const renderer::Turntable table{turn_degrees, 0};
    const auto placement =
        renderer::place(renderer::geometry::bounding_sphere(mesh), {diameter}, table);
    auto placed = mesh;
    for (auto& p : placed.positions)
        p = glm::dvec3(placement.world_from_model * glm::dvec4(p, 1));
    return {renderer::reference::make_mesh_body(placed),
            renderer::reference::grey_medium(1, 0.9, 0, 1),
            {},
            illumination,
            renderer::frame({diameter}, table, 1)};
}

/// "sphere-sky", "sphere-exact" under the same sky, "sphere-back": radius 5; "model-back": `model`
/// of diameter 20.
inline NamedPicture comparison_picture(const std::string& name, const std::string& model) {
    const auto back = sun_toward({0, 0.3, -1});
    if (name == "sphere-sky")
        return {name, grey_picture(renderer::geometry::sphere(1, 5), 10, 0, even_sky)};
    if (name == "sphere-exact") { // no triangles
        auto exact = grey_picture(renderer::geometry::sphere(1, 5), 10, 0, even_sky);
        exact.body = renderer::reference::make_sphere(5);
        return {name, std::move(exact)};
    }
    if (name == "sphere-back")
        return {name, grey_picture(renderer::geometry::sphere(1, 5), 10, 0, back)};
    return {name, grey_picture(load_mesh(model), 20, 180, back)};
}

/// Armadillo in marble, bunny in skim milk, horse in skin2, each from behind, the front, the left.
inline std::vector<NamedPicture> study_pictures() {
    struct Look {
        const char *name, *material;
        double diameter_mm;
        renderer::Turntable table;
    };

    struct Variant {
        const char* name;
        glm::dvec3 to_light;
    };

    const Look looks[]{{"armadillo", "marble", 100, {.turn_degrees = 180}},
                       {"bunny", "skim-milk", 100, {}},
                       {"horse", "skin2", 60, {.turn_degrees = 120, .up = {0, 0, 1}}}};
    const Variant variants[]{
        {"back", {0, 0.3, -1}}, {"front", {0.3, 0.3, 1}}, {"left", {-1, 0.2, 0.2}}};
    std::vector<NamedPicture> pictures;
    for (const auto& look : looks) {
        const auto mesh = load_mesh(look.name);
        renderer::Scene scene;
        scene.material = *renderer::measured_material(look.material);
        scene.placement = renderer::place(renderer::geometry::bounding_sphere(mesh),
                                          {look.diameter_mm}, look.table);
        scene.camera = renderer::frame({look.diameter_mm}, look.table, 1);
        for (const auto& variant : variants) {
            scene.lights = {
                {renderer::DirectionalLight{glm::normalize(variant.to_light)}, {1, 1, 1}}};
            pictures.push_back(
                {std::string(look.name) + ", " + variant.name,
                 value_or_throw(renderer::reference::picture_of_scene(mesh, scene))});
        }
    }
    return pictures;
}

} // namespace bench
