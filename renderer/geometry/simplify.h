// Fewer triangles for nearly the same surface: edges collapse in the order in which that moves it
// least.  [GarlandHeckbert1997]
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <cstddef>
#include <memory>

namespace renderer::geometry {

/// One simplification in several steps: each goes on from the one before, so that all of them take
/// no longer than the last alone.
class Simplifier {
  public:
    /// Errors: a mesh that is not a closed manifold, with what speaks against it and where it lies.
    static Expected<Simplifier> prepare(const Mesh& mesh);

    Simplifier(Simplifier&&) noexcept;
    Simplifier& operator=(Simplifier&&) noexcept;
    ~Simplifier();

    /// The mesh with at most `triangles`, and no more than one below that: closed, facing outward,
    /// of as many pieces, cavities and handles as before.  Every vertex is one of the original's,
    /// where it was, in their order; deterministic.
    /// Errors: the surface cannot do with so few without losing a piece, a handle or its volume.
    Expected<Mesh> down_to(std::size_t triangles);

  private:
    struct State;
    explicit Simplifier(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

/// One step alone.  Errors: those of the `Simplifier`.
Expected<Mesh> simplify(const Mesh& mesh, std::size_t triangles);

} // namespace renderer::geometry
