// Makes a mesh fit for tracing where that needs no guessing, and says what was done.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/geometry/mesh_report.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace renderer::geometry {

/// What `prepare` does with edges of one triangle.
enum class Holes {
    Refuse,
    ByWinding ///< keeps them: inside is where the surface winds more than half around (openings.h)
};

struct RepairOptions {
    /// Vertices nearer than this fraction of the bounding sphere's diameter become one, 0..1e-3;
    /// with 0 only those that are equal.  1e-7 suits files that were rounded when written.
    double weld_within = 0;
    Holes holes = Holes::Refuse;
};

/// What was changed.
struct Repairs {
    std::size_t welded_vertices = 0;     ///< gone into another one
    std::size_t collapsed_triangles = 0; ///< dropped: two of their corners are one vertex
    std::size_t duplicate_triangles = 0; ///< dropped: they repeat another, facing the same way
    std::size_t needle_triangles = 0;    ///< dropped: three corners on a line
    std::size_t unused_vertices = 0;     ///< dropped: in no triangle
    /// Three corners on a line, left where they are: without them the surface would come apart.
    std::size_t needles_kept = 0;
    bool is_flipped = false; ///< the closed surface faced inward, and was turned
};

struct PreparedMesh {
    Mesh mesh;
    Repairs repairs;
    MeshReport report; ///< of `mesh`, after the repairs
};

/// Welds, drops and turns as `Repairs` lists it, in that order.  Vertices and triangles keep their
/// order; a welded vertex lies where the first of its kind did.  Nothing is filled, cut or moved.
PreparedMesh repair(Mesh mesh, const RepairOptions& options = {});

/// Repairs, and makes sure of what thickness needs: closed (or allowed not to be), consistently
/// oriented, facing outward.
/// Errors: "<name>: ..." with the number of edges that speak against it and where the first lies.
Expected<PreparedMesh> prepare(Mesh mesh, std::string_view name, const RepairOptions& options = {});

/// The changes as a person reads them, one to a line; empty if there were none.
std::vector<std::string> describe(const Repairs& repairs);

} // namespace renderer::geometry
