// A scanned model on a turntable, and any method of the catalogue made for it.
#pragma once

#include "renderer/camera.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/materials.h"
#include "renderer/methods/catalogue.h"
#include "tests/bench/models.h"

#include <algorithm>
#include <map>
#include <memory>
#include <string>

namespace bench {

using namespace renderer;

/// In the order that methods draw in.
inline geometry::Mesh load_drawn_mesh(const std::string& name) {
    return geometry::along_morton_curve(load_mesh(name));
}

/// Marble, lit from behind.
inline Scene
scene_of(const geometry::Mesh& mesh, int width, int height, Millimetres diameter = {100}) {
    const Turntable table{.turn_degrees = 30, .elevation_degrees = 15};
    Scene scene;
    scene.placement = place(geometry::bounding_sphere(mesh), diameter, table);
    scene.camera = frame(diameter, table, static_cast<double>(width) / height);
    scene.material = *measured_material("marble");
    scene.lights = {{DirectionalLight{{0, 0.3, -1}}, {1, 1, 1}}};
    return scene;
}

/// Whatever a method asks for, as many directions are traced: 256 will do where neither a frame's
/// cost nor an error of storage depends on more.
class Workbench {
  public:
    Workbench(const geometry::Mesh& mesh, const Scene& scene, int directions = 256)
        : mesh_(mesh), scene_(scene), directions_(directions),
          surface_(value_or_throw(shading::Surface::upload(mesh))) {}

    std::shared_ptr<methods::Method> prepare(const std::string& name,
                                             const methods::Dials& dials) const {
        const methods::Subject subject{
            .mesh = mesh_,
            .surface = surface_,
            .material = scene_.material,
            .placement = scene_.placement,
            .field = [this](const thickness::FieldOptions& asked) { return field(asked); },
            .progress = {}};
        return value_or_throw(methods::prepare_method(name, dials, subject));
    }

  private:
    using Field = std::shared_ptr<const thickness::ThicknessField>;

    Expected<Field> field(thickness::FieldOptions asked) const {
        asked.bands = 6; // serves whoever wants fewer
        asked.directions = std::max(directions_, 2 * 6 * 6);
        auto& traced = fields_[asked.kind];
        if (traced == nullptr) {
            auto computed = thickness::compute_thickness_field(mesh_, asked);
            if (!computed)
                return tl::make_unexpected(computed.error());
            traced = std::make_shared<const thickness::ThicknessField>(std::move(*computed));
        }
        return traced;
    }

    const geometry::Mesh& mesh_;
    Scene scene_;
    int directions_;
    std::shared_ptr<const shading::Surface> surface_;
    mutable std::map<thickness::Kind, Field> fields_;
};

} // namespace bench
