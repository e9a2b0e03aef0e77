// A shading method: prepared once for a body, updated when the light moves, drawn often.
#pragma once

#include "renderer/expected.h"
#include "renderer/scene.h"

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

namespace renderer::methods {

/// What a method costs beyond the bare mesh.
struct Cost {
    std::size_t bytes_per_vertex = 0; ///< kept and fetched, beside position and normal
    std::size_t bytes_per_light = 0;  ///< sent or filled whenever a light moves
    int passes_per_light = 0;         ///< times the vertices are gone through when a light moves
    int passes_per_picture = 1;       ///< times the mesh is drawn when the camera moves
};

class Method {
  public:
    Method() = default;
    Method(const Method&) = delete;
    Method& operator=(const Method&) = delete;
    virtual ~Method() = default;

    /// Takes up what has changed in the scene since the last call: lights, placement, camera.  To
    /// be called before `draw`, and cheap where nothing has changed.  `seconds` have passed since
    /// the last call: changes that would jump are spread over a few pictures; with the default they
    /// are over at once.
    /// Errors: no lights or too many, one without a direction, a placement that flattens the model.
    virtual Expected<void> update(const Scene& scene,
                                  double seconds = std::numeric_limits<double>::infinity()) = 0;

    /// Draws linear light, alpha 1, into the bound frame buffer and viewport.
    virtual void draw(const Scene& scene) = 0;

    virtual Cost cost() const = 0;

    /// What the method chose by itself at the last update, and why, in words; empty where it had no
    /// choice.
    virtual std::string decision() const { return {}; }

    /// What that choice changes in the picture, as the method reckons beforehand: root mean square
    /// of brightness over what is seen, 1 = white.  Nothing where it had no choice or reckoned not.
    virtual std::optional<double> predicted_change() const { return {}; }

    /// Whether it may choose by itself, as it does at first; otherwise it uses all it has, from the
    /// next update on.  Nothing changes where there is no choice.
    virtual void let_choose(bool) {}
};

} // namespace renderer::methods
