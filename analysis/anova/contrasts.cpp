#include "analysis/anova/contrasts.h"

#include "analysis/anova/box.h"
#include "protocols/contract.h"

#include <cmath>

namespace analysis::anova {

namespace {

using Real = long double;

struct Box {
    std::vector<std::size_t> sizes;
    std::vector<Real> values;
};

// Along one axis of n levels; `weights` has a row of n for every level of the result.
Box combined(const Box& box, std::size_t axis, const std::vector<std::vector<Real>>& weights) {
    const auto n = box.sizes[axis], rows = weights.size();
    const auto inner = stride(box.sizes, axis);
    const auto outer = box.values.size() / (n * inner);
    Box result{box.sizes, std::vector<Real>(outer * rows * inner)};
    result.sizes[axis] = rows;
    for (std::size_t o = 0; o < outer; ++o)
        for (std::size_t r = 0; r < rows; ++r)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t i = 0; i < inner; ++i)
                    result.values[(o * rows + r) * inner + i] +=
                        weights[r][k] * box.values[(o * n + k) * inner + i];
    return result;
}

// Integer weights first, their length last: what is constant stays exactly zero.
std::vector<std::vector<Real>> helmert(std::size_t n) {
    std::vector<std::vector<Real>> rows;
    for (std::size_t r = 1; r < n; ++r) {
        std::vector<Real> row(n, 0);
        for (std::size_t i = 0; i < r; ++i)
            row[i] = 1;
        row[r] = -static_cast<Real>(r);
        rows.push_back(row);
    }
    return rows;
}

void divide_by_lengths(Box& box, std::size_t axis) {
    const auto inner = stride(box.sizes, axis);
    for (std::size_t i = 0; i < box.values.size(); ++i) {
        const auto r = static_cast<Real>(i / inner % box.sizes[axis] + 1);
        box.values[i] /= std::sqrt(r * (r + 1));
    }
}

} // namespace

std::vector<long double> contrast_scores(std::span<const std::size_t> sizes,
                                         std::span<const long double> values,
                                         unsigned set) {
    std::size_t cells = 1;
    for (const auto size : sizes)
        cells *= size;
    EXPECTS(!sizes.empty() && values.size() == cells);
    Box box{{sizes.begin(), sizes.end()}, {values.begin(), values.end()}};
    Real pooled = 1;
    for (std::size_t axis = 1; axis < sizes.size(); ++axis) {
        const bool kept = (set >> axis & 1U) != 0;
        const std::vector<std::vector<Real>> sum(1, std::vector<Real>(sizes[axis], 1));
        box = combined(box, axis, kept ? helmert(sizes[axis]) : sum);
        pooled *= kept ? 1 : static_cast<Real>(sizes[axis]);
    }
    for (std::size_t axis = 1; axis < sizes.size(); ++axis)
        if ((set >> axis & 1U) != 0)
            divide_by_lengths(box, axis);
    for (auto& value : box.values)
        value /= std::sqrt(pooled);
    return box.values;
}

} // namespace analysis::anova
