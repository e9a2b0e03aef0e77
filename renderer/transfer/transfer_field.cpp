// Irradiance at samples by rays in shared directions, spread over the vertices through an octree.
#include "renderer/transfer/transfer_field.h"

#include "renderer/contract.h"
#include "renderer/diffusion/block_loop.h"
#include "renderer/diffusion/exposure.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/harmonics/projection.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <optional>
#include <string>

namespace renderer::transfer {

namespace {

using diffusion::SurfaceSamples;

// Neighbouring samples look into one direction after another together: they meet the same part of
// the tree.
constexpr std::size_t samples_per_block = 256;

constexpr double share_of_tracing = 0.7; // of the whole computation, as measured on scanned models

std::vector<std::uint32_t> neighbours_together(const std::vector<glm::dvec3>& positions) {
    glm::dvec3 low = positions.front(), high = low;
    for (const auto& p : positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
    }
    const auto size = high - low;
    const double longest = std::max({size.x, size.y, size.z, 1e-300});
    std::vector<glm::vec3> unit;
    for (const auto& p : positions)
        unit.emplace_back((p - 0.5 * (low + high)) / longest);
    return geometry::morton_order(unit);
}

/// Stretches progress over one part of the whole.
Progress part_of(const Progress& progress, double from, double to) {
    if (!progress)
        return {};
    return
        [&progress, from, to](double fraction) { return progress(from + (to - from) * fraction); };
}

std::vector<double> plane_albedos(const Medium& medium) {
    std::vector<double> albedos;
    for (const auto& dipole : diffusion::dipoles(medium))
        albedos.push_back(diffusion::plane_total(dipole));
    return albedos;
}

std::vector<float>
reflected_where_it_falls(std::span<const float> irradiance, const Medium& medium, std::size_t n) {
    const auto albedos = plane_albedos(medium);
    std::vector<float> transfer;
    transfer.reserve(3 * irradiance.size());
    for (std::size_t v = 0; v < irradiance.size() / n; ++v)
        for (const double albedo : albedos)
            for (std::size_t i = 0; i < n; ++i)
                transfer.push_back(static_cast<float>(albedo) * irradiance[v * n + i]);
    return transfer;
}

/// What would make the computation meaningless, said before it starts.
std::optional<std::string>
what_is_wrong(const geometry::Mesh& mesh, const Medium& medium, const TransferOptions& options) {
    const int n = harmonics::coefficient_count(options.bands);
    if (options.directions < 2 * n)
        return fmt::format("{} directions cannot carry {} coefficients, expected {} or more",
                           options.directions, n, 2 * n);
    const auto& s = medium.sigma_s_reduced;
    if (!(s.r > 0 || s.g > 0 || s.b > 0))
        return "the medium scatters in no channel, expected a sigma_s' above 0 in one of them";
    double area = 0;
    for (const double share : diffusion::vertex_samples(mesh).areas)
        area += share;
    if (!(area > 0))
        return "the mesh has no triangle with area, expected a surface";
    return std::nullopt;
}

} // namespace

std::vector<float> irradiance_transfer(const geometry::Mesh& mesh,
                                       const SurfaceSamples& samples,
                                       double eta,
                                       const TransferOptions& options,
                                       const Progress& progress) {
    const diffusion::Exposure exposure(mesh, samples, eta);
    const auto set = harmonics::fibonacci_directions(options.directions, options.rotation_seed);
    const auto rows = harmonics::projection_rows(options.bands, set);
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(options.bands));
    const auto order = neighbours_together(samples.positions);
    std::vector<float> result(order.size() * n);
    const auto project = [&](std::size_t begin, std::size_t end) {
        std::vector<double> sums((end - begin) * n);
        for (std::size_t j = 0; j < set.directions.size(); ++j)
            for (auto at = begin; at < end; ++at)
                if (const double e = exposure(order[at], set.directions[j]); e > 0)
                    for (std::size_t i = 0; i < n; ++i)
                        sums[(at - begin) * n + i] += e * rows[j * n + i];
        for (auto at = begin; at < end; ++at)
            for (std::size_t i = 0; i < n; ++i)
                result[order[at] * n + i] = static_cast<float>(sums[(at - begin) * n + i]);
    };
    if (!diffusion::for_each_block(order.size(), samples_per_block, progress, project))
        return {};
    return result;
}

Expected<TransferField> compute_transfer_field(const geometry::Mesh& mesh,
                                               const Medium& medium,
                                               double mm_per_unit,
                                               const TransferOptions& options,
                                               const Progress& progress) {
    EXPECTS(options.bands >= 1 && options.bands <= 6);
    if (auto wrong = what_is_wrong(mesh, medium, options))
        return tl::unexpected(std::move(*wrong));
    const auto per_unit = diffusion::in_model_units(medium, mm_per_unit);
    const bool spreads = options.mode == Mode::Subsurface;
    const auto samples =
        spreads ? diffusion::sample_surface(mesh, {.spacing = diffusion::wanted_spacing(per_unit),
                                                   .most_samples = options.most_samples})
                : diffusion::vertex_samples(mesh);

    const auto irradiance = irradiance_transfer(mesh, samples, medium.index, options,
                                                part_of(progress, 0, share_of_tracing));
    if (irradiance.empty())
        return tl::unexpected<std::string>("cancelled");

    TransferField field{.bands = options.bands,
                        .samples = samples.positions.size(),
                        .undersampled = samples.undersampled};
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(options.bands));
    field.transfer =
        spreads ? diffusion::spread(diffusion::PointTree(samples, irradiance, n),
                                    diffusion::dipoles(per_unit), mesh.positions, options.opening,
                                    part_of(progress, share_of_tracing, 1))
                : reflected_where_it_falls(irradiance, medium, n);
    if (field.transfer.empty())
        return tl::unexpected<std::string>("cancelled");
    for (float& t : field.transfer)
        t *= std::numbers::inv_pi_v<float>;
    return field;
}

TransferField first_bands(const TransferField& field, int bands) {
    EXPECTS(bands >= 1 && bands <= field.bands);
    TransferField fewer{.bands = bands,
                        .transfer = {},
                        .samples = field.samples,
                        .undersampled = field.undersampled};
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    const auto all = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    fewer.transfer.reserve(field.transfer.size() / all * n);
    for (auto vector = field.transfer.begin(); vector != field.transfer.end();
         vector += static_cast<std::ptrdiff_t>(all))
        fewer.transfer.insert(fewer.transfer.end(), vector,
                              vector + static_cast<std::ptrdiff_t>(n));
    return fewer;
}

glm::dvec3 exit_radiance(const TransferField& field, std::size_t v, std::span<const double> light) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    EXPECTS(light.size() == n && (v + 1) * 3 * n <= field.transfer.size());
    glm::dvec3 radiance(0);
    for (int c = 0; c < 3; ++c)
        for (std::size_t i = 0; i < n; ++i)
            radiance[c] +=
                light[i] *
                static_cast<double>(field.transfer[(3 * v + static_cast<std::size_t>(c)) * n + i]);
    return radiance;
}

} // namespace renderer::transfer
