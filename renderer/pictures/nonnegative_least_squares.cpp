// Givens rotations throughout.
#include "renderer/pictures/nonnegative_least_squares.h"

#include <cmath>
#include <limits>
#include <optional>

namespace renderer::pictures {

namespace {

constexpr auto n = NonnegativeLeastSquares::unknowns;
constexpr double dependent = 1e-10;

using Row = std::array<double, n + 1>;
using Triangle = std::array<Row, n + 1>;

/// Rotates `row` into the triangle, column by column.
void rotate_in(Triangle& triangle, Row row) {
    for (std::size_t k = 0; k < row.size(); ++k) {
        if (row[k] == 0)
            continue;
        auto& pivot = triangle[k];
        const double length = std::hypot(pivot[k], row[k]);
        const double cosine = pivot[k] / length, sine = row[k] / length;
        for (std::size_t j = k; j < row.size(); ++j) {
            const double upper = cosine * pivot[j] + sine * row[j];
            row[j] = cosine * row[j] - sine * pivot[j];
            pivot[j] = upper;
        }
    }
}

double column_length(const Triangle& triangle, std::size_t column) {
    double squares = 0;
    for (const auto& row : triangle)
        squares += row[column] * row[column];
    return std::sqrt(squares);
}

struct Candidate {
    NonnegativeLeastSquares::Weights x{};
    double squared_error = 0;
};

/// The plain minimum over the unknowns whose bits are set; nothing where their columns depend on
/// each other or one of them comes out negative.
std::optional<Candidate> minimum_over(const Triangle& all, unsigned subset) {
    Triangle part{};
    for (Row row : all) {
        for (std::size_t j = 0; j < n; ++j)
            if ((subset >> j & 1U) == 0)
                row[j] = 0;
        rotate_in(part, row);
    }
    Candidate candidate;
    for (std::size_t k = n; k-- > 0;) {
        if ((subset >> k & 1U) == 0)
            continue;
        if (!(std::abs(part[k][k]) > dependent * column_length(all, k)))
            return std::nullopt;
        double rest = part[k][n];
        for (std::size_t j = k + 1; j < n; ++j)
            rest -= part[k][j] * candidate.x[j];
        candidate.x[k] = rest / part[k][k];
        if (!(candidate.x[k] >= 0))
            return std::nullopt;
    }
    candidate.squared_error = part[n][n] * part[n][n];
    return candidate;
}

} // namespace

void NonnegativeLeastSquares::add_equation(const Weights& a, double y) {
    rotate_in(triangle_, {a[0], a[1], a[2], a[3], y});
}

NonnegativeLeastSquares::Solution NonnegativeLeastSquares::solve() const {
    Candidate best{{}, std::numeric_limits<double>::infinity()};
    for (unsigned subset = 0; subset < 1U << n; ++subset)
        if (const auto candidate = minimum_over(triangle_, subset);
            candidate && candidate->squared_error < best.squared_error)
            best = *candidate;
    Solution solution{best.x, best.squared_error, {}};
    for (std::size_t j = 0; j < n; ++j)
        solution.absent[j] = column_length(triangle_, j) == 0;
    return solution;
}

} // namespace renderer::pictures
