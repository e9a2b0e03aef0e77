// A convolution with the clamped cosine, band by band.
#include "renderer/thickness/local_thickness.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>

namespace renderer::thickness {

namespace {

// A_l / pi of the clamped cosine.
constexpr std::array cosine_factor{1.0, 2.0 / 3, 1.0 / 4, 0.0, -1.0 / 24, 0.0};

double
cosine_mean(std::span<const float> coefficients, const harmonics::LaneValues& basis, int bands) {
    double sum = 0;
    for (int l = 0; l < bands; ++l)
        for (int m = -l; m <= l; ++m) {
            const auto i = static_cast<std::size_t>(harmonics::flat_index(l, m));
            sum += cosine_factor[static_cast<std::size_t>(l)] *
                   static_cast<double>(coefficients[i]) * basis[i];
        }
    return sum;
}

} // namespace

Expected<std::vector<double>> local_thickness(const geometry::Mesh& mesh,
                                              const thickness::ThicknessField& field) {
    EXPECTS(field.bands >= 1 && field.bands <= static_cast<int>(cosine_factor.size()));
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    if (field.coefficients.size() != mesh.positions.size() * stride)
        return tl::make_unexpected(fmt::format(
            "a thickness field of {} coefficients, expected {} for {} vertices",
            field.coefficients.size(), mesh.positions.size() * stride, mesh.positions.size()));
    auto inward = geometry::vertex_normals(mesh);
    for (auto& normal : inward)
        normal = -normal;
    std::vector<double> thickness(inward.size());
    harmonics::for_each_basis(field.bands, inward, [&](std::size_t v, const auto& basis) {
        const auto row = std::span(field.coefficients).subspan(v * stride, stride);
        thickness[v] = std::max(cosine_mean(row, basis, field.bands), 0.0);
    });
    return thickness;
}

} // namespace renderer::thickness
