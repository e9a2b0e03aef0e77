// The diverging colours and the counts behind them.
#include "experiment/report/shares.h"

#include "protocols/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace experiment::report {

namespace {

using Colour = std::array<double, 3>;

constexpr Colour losing{0xe8, 0x9f, 0x5a};
constexpr Colour even{0xf6, 0xf6, 0xf4};
constexpr Colour winning{0x6c, 0xa5, 0xd3};

} // namespace

const analysis::VoteMatrix& pooled_matrix(const analysis::Findings& findings) {
    const auto all = std::ranges::find(findings.matrices, "all", &analysis::ScopedMatrix::scope);
    EXPECTS(all != findings.matrices.end());
    return all->matrix;
}

double votes_over(const analysis::VoteMatrix& matrix, std::size_t row, std::size_t column) {
    return static_cast<double>(2 * matrix.wins(row, column) + matrix.ties(row, column)) / 2;
}

double share_over(const analysis::VoteMatrix& matrix, std::size_t row, std::size_t column) {
    return votes_over(matrix, row, column) / static_cast<double>(matrix.comparisons(row, column));
}

std::string share_colour(double share) {
    if (std::isnan(share))
        return "#ffffff";
    const double distance = std::min(1.0, 2 * std::abs(share - 0.5));
    const Colour& end = share < 0.5 ? losing : winning;
    std::string colour = "#";
    for (std::size_t i = 0; i < 3; ++i)
        colour += fmt::format(
            "{:02x}", static_cast<int>(std::lround(even[i] + distance * (end[i] - even[i]))));
    return colour;
}

} // namespace experiment::report
