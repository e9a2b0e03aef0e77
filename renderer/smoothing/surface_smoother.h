// Spreading values over a surface as heat spreads: one implicit step of diffusion.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace renderer::smoothing {

/// Solves (M + t L) x = M b, a backward-Euler step of dx/dt = Laplacian x, which is stable for any
/// t.  Its kernel has the mean square radius 4 t of the heat kernel, and heavier tails.
/// Constants stay, area-weighted means stay, values stay within the range of `b`; nothing passes
/// between components, and a vertex without area keeps its value.
/// Source: [Desbrun1999].
class SurfaceSmoother {
  public:
    explicit SurfaceSmoother(const geometry::Mesh& mesh);
    SurfaceSmoother(SurfaceSmoother&&) noexcept;
    SurfaceSmoother& operator=(SurfaceSmoother&&) noexcept;
    ~SurfaceSmoother();

    /// Shapes: `values` has `columns` numbers per vertex, vertex by vertex; so has the answer.
    /// Units:  t in model units squared, >= 0; 0 gives back `values`, bit for bit.
    /// Errors: a mesh so distorted that the system cannot be factorised.  EXPECTS shape and range.
    /// Cost:   one sparse factorisation, `columns` solutions.
    Expected<std::vector<double>>
    smooth(double t, std::span<const double> values, std::size_t columns);

  private:
    struct System;
    std::unique_ptr<System> system_;
};

} // namespace renderer::smoothing
