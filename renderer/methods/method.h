// A shading method: prepared once for a mesh, lit when the light moves, drawn often.
#pragma once

#include "renderer/expected.h"
#include "renderer/methods/surface.h"
#include "renderer/scene.h"
#include "renderer/thickness/thickness_field.h"

#include <cstddef>
#include <memory>
#include <variant>

namespace renderer::methods {

/// How much of the scattered light passes a thickness d of material.  The same laws serve every
/// method that knows a thickness, so that only the thickness differs between them.
enum class Law {
    Paper,   ///< 1 - clamp(d/D_n, 0, 1), the same in every channel  [SHSS, eq. 3]
    Physical ///< exp(-sigma_tr d), per channel
};

/// Phong's model alone: the floor.
struct PhongSettings {};

/// Thickness from a depth map seen by the light.  [Green2004]
struct GreenSettings {
    int depth_map = 2048; ///< texels along its edge
    Law law = Law::Physical;
};

/// Thickness from spherical harmonics.  [SHSS]
struct ShssSettings {
    int bands = 5; ///< 1..6; n bands are n^2 coefficients per vertex
    Law law = Law::Physical;
};

using MethodSettings = std::variant<PhongSettings, GreenSettings, ShssSettings>;

/// What a method costs beyond the bare mesh.
struct Cost {
    std::size_t bytes_per_vertex = 0; ///< kept and fetched, beside position and normal
    std::size_t bytes_per_light = 0;  ///< uniforms sent, and depth map filled, when the light moves
    int passes_per_light = 0;         ///< times the mesh is drawn when the light moves
    int passes_per_picture = 1;       ///< times the mesh is drawn when the camera moves
};

class Method {
  public:
    Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;
    virtual ~Method() = default;

    /// Takes up the scene's light and placement.  To be called before the first `draw` and again
    /// whenever one of the two has changed.
    /// Errors: a light without a direction, a placement that flattens the model.
    virtual Expected<void> relight(const Scene& scene) = 0;

    /// Draws linear light, alpha 1, into the bound frame buffer and viewport.
    virtual void draw(const Scene& scene) = 0;

    virtual Cost cost() const = 0;
};

/// Makes a method ready to draw `surface`.  `field` belongs to the same mesh: SHSS needs it, Green
/// takes D_n from it under the paper's law, Phong ignores it.
/// Errors: a field that is missing or does not fit, settings out of range, the driver's refusals.
Expected<std::unique_ptr<Method>> prepare_method(const MethodSettings& settings,
                                                 std::shared_ptr<const Surface> surface,
                                                 const thickness::ThicknessField* field = nullptr);

} // namespace renderer::methods
