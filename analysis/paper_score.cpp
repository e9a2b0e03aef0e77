#include "analysis/paper_score.h"

#include "analysis/vote_matrix.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace analysis {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

double mean(const std::vector<double>& values) {
    return values.empty() ? undefined
                          : std::accumulate(values.begin(), values.end(), 0.0) /
                                static_cast<double>(values.size());
}

double sample_sd(const std::vector<double>& values) {
    if (values.size() < 2)
        return undefined;
    const double centre = mean(values);
    double squares = 0;
    for (const auto value : values)
        squares += (value - centre) * (value - centre);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// Each cell's share of the comparisons a condition took part in there; cells without any are not
// counted.
std::vector<double> shares(const std::vector<ScopedMatrix>& cells, std::size_t condition) {
    std::vector<double> values;
    for (const auto& cell : cells)
        if (const auto met = cell.matrix.comparisons(condition); met > 0)
            values.push_back(to_double({cell.matrix.half_votes(condition), 2 * met}));
    return values;
}

void mid_ranks(std::vector<PaperScore>& scores) {
    for (auto& score : scores) {
        std::size_t above = 0, equal = 0;
        for (const auto& other : scores) {
            above += score.exact_share < other.exact_share ? 1 : 0;
            equal += score.exact_share == other.exact_share ? 1 : 0;
        }
        score.rank = static_cast<double>(above) + (static_cast<double>(equal) + 1) / 2;
    }
}

} // namespace

std::vector<PaperScore> paper_scores(const VoteTable& table) {
    const auto all = count_votes(table);
    const auto observers = count_votes(table, {true, false, {}});
    std::vector<ScopedMatrix> cells;
    if (!table.factors.empty())
        cells = count_votes(table, {true, false, {true}});
    const auto most = static_cast<double>(table.conditions.size()) - 1;
    std::vector<PaperScore> scores;
    for (std::size_t a = 0; a < table.conditions.size(); ++a) {
        PaperScore score;
        score.condition = table.conditions.name(a);
        score.total_votes = static_cast<double>(all.half_votes(a)) / 2;
        score.max_per_round = most;
        score.exact_share = {all.half_votes(a), std::max<std::int64_t>(1, 2 * all.comparisons(a))};
        score.share_pooled = to_double(score.exact_share);
        const auto by_observer = shares(observers, a);
        score.share = mean(by_observer);
        score.mean_votes_per_round = most * score.share;
        score.mean_votes_per_observer_and_factor =
            cells.empty() ? undefined
                          : score.total_votes / static_cast<double>(table.observers.size() *
                                                                    table.factors[0].size());
        score.sd_over_observer_factor_cells = most * sample_sd(shares(cells, a));
        score.sd_over_observers = most * sample_sd(by_observer);
        score.se_over_observers =
            score.sd_over_observers / std::sqrt(static_cast<double>(by_observer.size()));
        scores.push_back(score);
    }
    mid_ranks(scores);
    return scores;
}

std::vector<std::size_t> ranking(const std::vector<PaperScore>& scores) {
    std::vector<std::size_t> order(scores.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return scores[b].exact_share < scores[a].exact_share; });
    return order;
}

} // namespace analysis
