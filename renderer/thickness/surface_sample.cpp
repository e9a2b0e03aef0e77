// Every so many vertices; each stands for its own share of the surface.
#include "renderer/thickness/surface_sample.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/thickness/surface_shares.h"

namespace renderer::thickness {

SurfaceSample
sample_surface(const geometry::Mesh& mesh, const ThicknessField& field, std::size_t most) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    EXPECTS(field.coefficients.size() == n * mesh.positions.size() && most > 0);
    const auto normals = geometry::vertex_normals(mesh);
    const auto shares = surface_shares(mesh);
    const std::size_t stride = (mesh.positions.size() + most - 1) / most;
    SurfaceSample sample{.bands = field.bands};
    for (std::size_t v = stride / 2; v < mesh.positions.size(); v += stride) {
        if (normals[v] == glm::dvec3(0))
            continue;
        sample.positions.push_back(mesh.positions[v]);
        sample.normals.push_back(normals[v]);
        sample.shares.push_back(static_cast<double>(shares[v]));
        const auto* first = &field.coefficients[v * n];
        sample.coefficients.insert(sample.coefficients.end(), first, first + n);
    }
    return sample;
}

void thickness_by_bands(const SurfaceSample& sample,
                        std::size_t i,
                        std::span<const double> basis,
                        std::span<double> thickness) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(sample.bands));
    EXPECTS(i < sample.size() && basis.size() >= n &&
            thickness.size() == static_cast<std::size_t>(sample.bands));
    const auto* c = &sample.coefficients[i * n];
    double sum = 0;
    std::size_t k = 0;
    for (std::size_t l = 0; l < thickness.size(); ++l) {
        for (; k < (l + 1) * (l + 1); ++k)
            sum += static_cast<double>(c[k]) * basis[k];
        thickness[l] = sum;
    }
}

} // namespace renderer::thickness
