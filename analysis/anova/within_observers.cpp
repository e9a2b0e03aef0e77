#include "analysis/anova/within_observers.h"

#include "analysis/anova/box.h"
#include "analysis/exact.h"
#include "protocols/contract.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <type_traits>

namespace analysis::anova {

namespace {

// A box of scores: axis 0 is observers, axis 1.. the factors; the last axis runs fastest.
template <class Number>
struct Box {
    std::vector<std::size_t> sizes;
    std::vector<Number> values;
    double resolution = 0; // effects no larger than this are rounding; 0 for integers
};

// Along one axis of n: every value times n, less the axis's sum.  Nothing is divided, so integers
// stay integers; a component is too large by the product of all axis sizes.
template <class Number>
Box<Number> deviations(const Box<Number>& box, std::size_t axis) {
    const auto n = box.sizes[axis];
    const auto inner = stride(box.sizes, axis);
    auto result = box;
    for (std::size_t outer = 0; outer < box.values.size(); outer += n * inner)
        for (std::size_t i = 0; i < inner; ++i) {
            Number sum{};
            for (std::size_t k = 0; k < n; ++k)
                sum += box.values[outer + k * inner + i];
            for (std::size_t k = 0; k < n; ++k) {
                auto& value = result.values[outer + k * inner + i];
                value = value * static_cast<Number>(n) - sum;
            }
        }
    return result;
}

template <class Number>
Box<Number> summed(const Box<Number>& box, std::size_t axis) {
    const auto n = box.sizes[axis];
    const auto inner = stride(box.sizes, axis);
    Box<Number> result{box.sizes, {}, box.resolution};
    result.sizes[axis] = 1;
    result.values.resize(box.values.size() / n);
    for (std::size_t outer = 0; outer < box.values.size() / (n * inner); ++outer)
        for (std::size_t k = 0; k < n; ++k)
            for (std::size_t i = 0; i < inner; ++i)
                result.values[outer * inner + i] += box.values[(outer * n + k) * inner + i];
    return result;
}

// Sum of squares of the component that varies along exactly the axes of `set` (a bit per axis).
template <class Number>
double component_squares(Box<Number> box, unsigned set, double unit) {
    double count = 1, repeats = 1; // cells in all; cells that share one value of the component
    for (std::size_t axis = 0; axis < box.sizes.size(); ++axis) {
        const auto n = static_cast<double>(box.sizes[axis]);
        count *= n;
        if ((set >> axis & 1U) == 0)
            repeats *= n;
    }
    for (std::size_t axis = 0; axis < box.sizes.size(); ++axis)
        box = (set >> axis & 1U) != 0 ? deviations(box, axis) : summed(box, axis);
    if constexpr (std::is_floating_point_v<Number>) {
        double largest = 0, squares = 0;
        for (const auto value : box.values) {
            const double effect = static_cast<double>(value) / count;
            squares += effect * effect;
            largest = std::max(largest, std::abs(effect));
        }
        return largest <= box.resolution ? 0.0 : squares * repeats;
    } else {
        Wide squares = 0;
        for (const auto value : box.values)
            squares += static_cast<Wide>(value) * value;
        return static_cast<double>(squares) * repeats / (count * count) / (unit * unit);
    }
}

// Rows of orthonormal contrasts between n levels (Helmert's).
std::vector<std::vector<double>> helmert(std::size_t n) {
    std::vector<std::vector<double>> rows;
    for (std::size_t r = 1; r < n; ++r) {
        const double length = std::sqrt(static_cast<double>(r * (r + 1)));
        std::vector<double> row(n, 0.0);
        for (std::size_t i = 0; i < r; ++i)
            row[i] = 1 / length;
        row[r] = -static_cast<double>(r) / length;
        rows.push_back(row);
    }
    return rows;
}

// Applies contrasts along one axis, which shrinks by one.
Box<double> contrasted(const Box<double>& box, std::size_t axis) {
    const auto n = box.sizes[axis];
    const auto contrasts = helmert(n);
    const auto inner = stride(box.sizes, axis);
    const auto outer = box.values.size() / (n * inner);
    Box<double> result{box.sizes, std::vector<double>(outer * (n - 1) * inner), 0};
    result.sizes[axis] = n - 1;
    for (std::size_t o = 0; o < outer; ++o)
        for (std::size_t r = 0; r + 1 < n; ++r)
            for (std::size_t k = 0; k < n; ++k)
                for (std::size_t i = 0; i < inner; ++i)
                    result.values[(o * (n - 1) + r) * inner + i] +=
                        contrasts[r][k] * box.values[(o * n + k) * inner + i];
    return result;
}

template <class Number>
std::vector<double> contrast_scores(Box<Number> box, unsigned set) {
    for (std::size_t axis = 1; axis < box.sizes.size(); ++axis)
        if ((set >> axis & 1U) == 0)
            box = summed(box, axis);
    Box<double> scores{box.sizes, {}, 0};
    for (const auto value : box.values)
        scores.values.push_back(static_cast<double>(value));
    for (std::size_t axis = 1; axis < box.sizes.size(); ++axis)
        if ((set >> axis & 1U) != 0)
            scores = contrasted(scores, axis);
    return scores.values;
}

std::vector<unsigned> factor_sets(std::size_t factors) {
    std::vector<unsigned> sets;
    for (unsigned set = 1; set < 1U << factors; ++set)
        sets.push_back(set << 1U); // bit 0 is the observers' axis
    // By size, then as words: session:model before session:light before model:light.
    const auto reversed = [](unsigned set) {
        unsigned mirrored = 0;
        for (unsigned bit = 0; bit < 8; ++bit)
            mirrored |= (set >> bit & 1U) << (7 - bit);
        return mirrored;
    };
    std::stable_sort(sets.begin(), sets.end(), [&](unsigned a, unsigned b) {
        const auto size_a = std::popcount(a), size_b = std::popcount(b);
        return size_a != size_b ? size_a < size_b : reversed(a) > reversed(b);
    });
    return sets;
}

template <class Number>
WithinEffect
one_effect(const Box<Number>& box, const std::vector<Factor>& factors, unsigned set, double unit) {
    WithinEffect effect;
    double df = 1;
    for (std::size_t f = 0; f < factors.size(); ++f)
        if ((set >> (f + 1) & 1U) != 0) {
            effect.name += (effect.name.empty() ? "" : ":") + factors[f].name;
            effect.factors.push_back(f);
            df *= static_cast<double>(factors[f].levels - 1);
        }
    const auto observers = static_cast<double>(box.sizes[0]);
    effect.effect = {component_squares(box, set, unit), df};
    effect.error = {component_squares(box, set | 1U, unit), df * (observers - 1)};
    effect.test = f_test(effect.effect, effect.error);
    if (effect.effect.ss + effect.error.ss > 0)
        effect.eta_squared_partial = effect.effect.ss / (effect.effect.ss + effect.error.ss);
    // R counts all cells of the layout as columns, not only those of the effect.
    std::size_t columns = 1;
    for (std::size_t axis = 1; axis < box.sizes.size(); ++axis)
        columns *= box.sizes[axis];
    effect.sphericity = sphericity(contrast_scores(box, set), std::vector<int>(box.sizes[0]),
                                   static_cast<std::size_t>(df), columns, effect.test);
    return effect;
}

void generalised_eta(WithinAnalysis& result) {
    double over_observers = result.subject.ss;
    for (const auto& effect : result.effects)
        over_observers += effect.error.ss;
    for (auto& effect : result.effects)
        if (effect.effect.ss + over_observers > 0)
            effect.eta_squared_generalized = effect.effect.ss / (effect.effect.ss + over_observers);
}

template <class Number>
WithinAnalysis
decompose(std::size_t observers, std::vector<Factor> factors, Box<Number> box, double unit) {
    WithinAnalysis result;
    result.observers = observers;
    double cells = 1;
    for (const auto set : factor_sets(factors.size()))
        result.effects.push_back(one_effect(box, factors, set, unit));
    for (const auto& factor : factors)
        cells *= static_cast<double>(factor.levels);
    result.subject = {component_squares(box, 1U, unit), static_cast<double>(observers - 1)};
    result.total = {result.subject.ss, cells * static_cast<double>(observers) - 1};
    for (const auto& effect : result.effects)
        result.total.ss += effect.effect.ss + effect.error.ss;
    result.factors = std::move(factors);
    generalised_eta(result);
    return result;
}

std::vector<std::size_t>
checked_sizes(std::size_t observers, const std::vector<Factor>& factors, std::size_t values) {
    EXPECTS(observers >= 2 && !factors.empty() && factors.size() <= 6);
    std::vector<std::size_t> sizes{observers};
    std::size_t cells = observers;
    for (const auto& factor : factors) {
        EXPECTS(factor.levels >= 2);
        sizes.push_back(factor.levels);
        cells *= factor.levels;
    }
    EXPECTS(values == cells);
    return sizes;
}

} // namespace

WithinAnalysis within_observers_of_counts(std::size_t observers,
                                          std::vector<Factor> factors,
                                          std::span<const std::int64_t> values,
                                          std::int64_t divisor) {
    EXPECTS(divisor > 0);
    auto sizes = checked_sizes(observers, factors, values.size());
    Box<Wide> box{std::move(sizes), {values.begin(), values.end()}, 0};
    return decompose(observers, std::move(factors), std::move(box), static_cast<double>(divisor));
}

WithinAnalysis within_observers(std::size_t observers,
                                std::vector<Factor> factors,
                                std::span<const double> values) {
    auto sizes = checked_sizes(observers, factors, values.size());
    // Shifting by one of the values keeps the digits of data far from zero.
    Box<long double> box{std::move(sizes), {values.begin(), values.end()}, 0};
    for (auto& value : box.values) {
        box.resolution = std::max(box.resolution, static_cast<double>(std::abs(value)));
        value -= static_cast<long double>(values[0]);
    }
    box.resolution *=
        8 * std::numeric_limits<double>::epsilon(); // what the input's rounding leaves
    return decompose(observers, std::move(factors), std::move(box), 1.0);
}

} // namespace analysis::anova
