// Moments by one sweep over the vertices.
#include "renderer/thickness/normal_bins.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/surface_shares.h"

#include <glm/geometric.hpp>

#include <algorithm>

namespace renderer::thickness {

namespace {

constexpr int bin_count = 32;

std::size_t nearest(std::span<const glm::dvec3> directions, glm::dvec3 normal) {
    const auto closer = [&](glm::dvec3 a, glm::dvec3 b) {
        return glm::dot(a, normal) < glm::dot(b, normal);
    };
    const auto found = std::max_element(directions.begin(), directions.end(), closer);
    return static_cast<std::size_t>(found - directions.begin());
}

void add(NormalBin& bin, double share, glm::dvec3 normal, std::span<const float> c) {
    bin.share += share;
    bin.normal += share * normal;
    double* moment = bin.moments.data();
    for (std::size_t i = 0; i < c.size(); ++i) {
        const double weighted = share * static_cast<double>(c[i]);
        for (std::size_t j = 0; j <= i; ++j)
            *moment++ += weighted * static_cast<double>(c[j]);
    }
}

/// From sums to means.
void finish(NormalBin& bin) {
    if (!(bin.share > 0))
        return;
    for (double& moment : bin.moments)
        moment /= bin.share;
    const double length = glm::length(bin.normal);
    bin.normal = length > 0 ? bin.normal / length : glm::dvec3(0);
}

} // namespace

NormalBins
bin_by_normal(const geometry::Mesh& mesh, std::span<const float> coefficients, int bands) {
    EXPECTS(bands >= 1);
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    EXPECTS(coefficients.size() == n * mesh.positions.size());
    const auto directions = harmonics::fibonacci_directions(bin_count, 1).directions;
    const auto shares = surface_shares(mesh);
    const auto normals = geometry::vertex_normals(mesh);
    NormalBins result{bands, std::vector<NormalBin>(bin_count)};
    for (auto& bin : result.bins)
        bin.moments.resize(n * (n + 1) / 2);
    for (std::size_t v = 0; v < normals.size(); ++v)
        if (normals[v] != glm::dvec3(0))
            add(result.bins[nearest(directions, normals[v])],
                static_cast<double>(shares[v]) * 0x1p-40, normals[v],
                coefficients.subspan(v * n, n));
    for (auto& bin : result.bins)
        finish(bin);
    return result;
}

double mean_square(const NormalBin& bin, std::span<const double> y) {
    EXPECTS(bin.moments.size() == y.size() * (y.size() + 1) / 2);
    double sum = 0;
    const double* moment = bin.moments.data();
    for (std::size_t i = 0; i < y.size(); ++i) {
        double below = 0;
        for (std::size_t j = 0; j < i; ++j)
            below += *moment++ * y[j];
        sum += y[i] * (2 * below + *moment++ * y[i]);
    }
    return sum;
}

} // namespace renderer::thickness
