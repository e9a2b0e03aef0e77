// The pattern of M + t L is analysed once, its numbers are factorised for every t.  Eigen ends
// here.
#include "renderer/smoothing/surface_smoother.h"

#include "renderer/contract.h"
#include "renderer/smoothing/cotangent_laplacian.h"

#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace renderer::smoothing {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Values = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Lengths are divided by the root of this, so that no unit of length costs digits.
double mean_area(const CotangentLaplacian& laplacian) {
    double sum = 0;
    for (const double area : laplacian.areas)
        sum += area;
    return sum > 0 ? sum / static_cast<double>(laplacian.areas.size()) : 1;
}

/// A vertex without area has no edge either: any mass lets it keep its value.
Eigen::VectorXd masses(const CotangentLaplacian& laplacian) {
    const double unit = mean_area(laplacian);
    Eigen::VectorXd masses(static_cast<Eigen::Index>(laplacian.areas.size()));
    std::transform(laplacian.areas.begin(), laplacian.areas.end(), masses.begin(),
                   [&](double area) { return area > 0 ? area / unit : 1; });
    return masses;
}

/// The lower triangle of L.
Matrix stiffness(const CotangentLaplacian& laplacian) {
    std::vector<Eigen::Triplet<double, int>> entries;
    entries.reserve(3 * laplacian.edges.size());
    for (const auto& [ends, weight] : laplacian.edges) {
        const int low = static_cast<int>(ends[0]), high = static_cast<int>(ends[1]);
        entries.emplace_back(low, low, weight);
        entries.emplace_back(high, high, weight);
        entries.emplace_back(high, low, -weight);
    }
    const auto n = static_cast<Eigen::Index>(laplacian.areas.size());
    for (int i = 0; i < n; ++i)
        entries.emplace_back(i, i, 0); // every diagonal entry belongs to the pattern
    Matrix matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

} // namespace

struct SurfaceSmoother::System {
    explicit System(const CotangentLaplacian& laplacian)
        : M(masses(laplacian)), L(stiffness(laplacian)), unit_area(mean_area(laplacian)) {
        solver.analyzePattern(L);
    }

    Eigen::VectorXd M;
    Matrix L;
    double unit_area;
    Eigen::SimplicialLDLT<Matrix, Eigen::Lower> solver;
};

SurfaceSmoother::SurfaceSmoother(const geometry::Mesh& mesh)
    : system_(std::make_unique<System>(cotangent_laplacian(mesh))) {}

SurfaceSmoother::SurfaceSmoother(SurfaceSmoother&&) noexcept = default;
SurfaceSmoother& SurfaceSmoother::operator=(SurfaceSmoother&&) noexcept = default;
SurfaceSmoother::~SurfaceSmoother() = default;

Expected<std::vector<double>>
SurfaceSmoother::smooth(double t, std::span<const double> values, std::size_t columns) {
    auto& [M, L, unit_area, solver] = *system_;
    EXPECTS(t >= 0 && std::isfinite(t));
    EXPECTS(columns > 0 && values.size() == columns * static_cast<std::size_t>(M.size()));
    if (t == 0)
        return std::vector<double>(values.begin(), values.end());
    Matrix system = (t / unit_area) * L;
    system.diagonal() += M;
    solver.factorize(system);
    if (solver.info() != Eigen::Success || !(solver.vectorD().array() > 0).all())
        return tl::make_unexpected(
            fmt::format("diffusion by {} over a surface of {} vertices has no factorisation, "
                        "expected a mesh without needles; repair it first",
                        t, M.size()));
    const Eigen::Map<const Values> b(values.data(), M.size(), static_cast<Eigen::Index>(columns));
    std::vector<double> smooth(values.size());
    Eigen::Map<Values> x(smooth.data(), b.rows(), b.cols());
    x = solver.solve(M.asDiagonal() * Eigen::MatrixXd(b));
    return smooth;
}

} // namespace renderer::smoothing
