// Least-squares projection with a Cholesky factor of the Gram matrix.
#include "renderer/harmonics/projection.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"

#include <cmath>

namespace renderer::harmonics {

namespace {

/// Lower triangle of a symmetric matrix, or of its Cholesky factor, in a full square.
struct SquareMatrix {
    std::size_t n;
    std::vector<double> entries = std::vector<double>(n * n);

    double& operator()(std::size_t row, std::size_t column) { return entries[row * n + column]; }

    double operator()(std::size_t row, std::size_t column) const {
        return entries[row * n + column];
    }
};

/// G = Y^T W Y from the basis values, one row of n per direction.
SquareMatrix gram_matrix(std::span<const double> basis, std::span<const double> weights) {
    SquareMatrix gram{basis.size() / weights.size()};
    for (std::size_t j = 0; j < weights.size(); ++j) {
        const auto y = basis.subspan(j * gram.n, gram.n);
        for (std::size_t row = 0; row < gram.n; ++row)
            for (std::size_t column = 0; column <= row; ++column)
                gram(row, column) += weights[j] * y[row] * y[column];
    }
    return gram;
}

/// G = F F^T in place.  The Gram matrix of a usable rule is near the identity: a pivot below 1e-6
/// means that the directions cannot tell the basis functions apart.
void factor(SquareMatrix& g) {
    for (std::size_t column = 0; column < g.n; ++column) {
        for (std::size_t row = column; row < g.n; ++row) {
            for (std::size_t k = 0; k < column; ++k)
                g(row, column) -= g(row, k) * g(column, k);
            if (row == column) {
                EXPECTS(g(row, row) > 1e-6);
                g(row, row) = std::sqrt(g(row, row));
            } else {
                g(row, column) /= g(column, column);
            }
        }
    }
}

/// x := G^-1 x by forward and back substitution.
void solve(const SquareMatrix& factor, std::span<double> x) {
    for (std::size_t i = 0; i < factor.n; ++i) {
        for (std::size_t k = 0; k < i; ++k)
            x[i] -= factor(i, k) * x[k];
        x[i] /= factor(i, i);
    }
    for (std::size_t i = factor.n; i-- > 0;) {
        for (std::size_t k = i + 1; k < factor.n; ++k)
            x[i] -= factor(k, i) * x[k];
        x[i] /= factor(i, i);
    }
}

} // namespace

std::vector<double> projection_rows(int bands, const DirectionSet& set) {
    EXPECTS(bands >= 1);
    EXPECTS(!set.directions.empty() && set.weights.size() == set.directions.size());
    const auto n = static_cast<std::size_t>(coefficient_count(bands));
    std::vector<double> rows(set.directions.size() * n);
    for_each_basis(bands, set.directions, [&](std::size_t j, const LaneValues& y) {
        for (std::size_t i = 0; i < n; ++i)
            rows[j * n + i] = y[i];
    });

    SquareMatrix gram = gram_matrix(rows, set.weights);
    factor(gram);
    for (std::size_t j = 0; j < set.directions.size(); ++j) {
        const auto row = std::span(rows).subspan(j * n, n);
        for (double& value : row)
            value *= set.weights[j];
        solve(gram, row);
    }
    return rows;
}

void accumulate(std::span<const double> values,
                std::size_t directions,
                std::span<const double> rows,
                std::span<double> coefficients) {
    EXPECTS(directions >= 1);
    EXPECTS(values.size() % directions == 0 && rows.size() % directions == 0);
    const std::size_t n = rows.size() / directions;
    EXPECTS(coefficients.size() == values.size() / directions * n);
    for (std::size_t v = 0; v < values.size() / directions; ++v) {
        double* c = coefficients.data() + v * n;
        for (std::size_t j = 0; j < directions; ++j) {
            const double value = values[v * directions + j];
            if (value == 0)
                continue; // half of all: the light stands on this side
            const double* row = rows.data() + j * n;
            for (std::size_t i = 0; i < n; ++i)
                c[i] += value * row[i];
        }
    }
}

std::vector<double> project(std::span<const double> rows, std::span<const double> samples) {
    EXPECTS(!samples.empty() && rows.size() % samples.size() == 0);
    std::vector<double> coefficients(rows.size() / samples.size());
    accumulate(samples, samples.size(), rows, coefficients);
    return coefficients;
}

} // namespace renderer::harmonics
