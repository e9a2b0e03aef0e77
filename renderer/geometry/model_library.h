// Finds a model by its name: a body of our own, a file on the search path, or a path.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace renderer::geometry {

/// The bodies that every study may name, in about the unit sphere:
///   "sphere"       radius 1
///   "shell"        radii 1 and 0.5
///   "torus"        radii 0.7 and 0.3, around the z axis
///   "slab"         2 x 2 x 0.2, thin along z
///   "rounded-box"  half extents 0.8, 0.5 and 0.35, edges rounded by 0.15
std::span<const std::string_view> body_names();

/// Where to look.
struct ModelSearch {
    std::filesystem::path study_folder;         ///< paths in the study file start here
    std::vector<std::filesystem::path> folders; ///< for names, in this order
};

struct Body {
    std::string name; ///< one of `body_names`
};

/// A body, or the file in which the model lies.
using Model = std::variant<Body, std::filesystem::path>;

/// What `name` means: a body's name; a path, if it has a slash or a mesh file's ending; else the
/// first <folder>/<name>.{ply,off,obj}.
/// Errors: the places where it was looked for, and how to get models.
Expected<Model> find_model(std::string_view name, const ModelSearch& search);

/// The mesh as it stands in its file, or of the body.  For thickness, `prepare` it
/// (renderer/geometry/mesh_repair.h).
Expected<Mesh> load_model(const Model& model);

} // namespace renderer::geometry
