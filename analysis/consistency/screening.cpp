#include "analysis/consistency/screening.h"

#include "analysis/consistency/exact_laws.h"
#include "analysis/consistency/repeatability.h"
#include "analysis/consistency/triads.h"
#include "analysis/scaling/leave_one_out.h"
#include "analysis/scaling/thurstone.h"
#include "analysis/vote_matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

using Scores = std::vector<std::vector<double>>; // [observer][scene and condition]

double mean(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// Votes for every condition in every scene; empty rows for observers without some scene.
Scores scores_of(const VoteTable& table) {
    const Scope cells{true, false, std::vector<bool>(table.factors.size(), true)};
    std::map<std::vector<std::string>, std::size_t> scenes;
    const auto matrices = count_votes(table, cells);
    for (const auto& cell : matrices)
        scenes.emplace(cell.scene, scenes.size());
    const auto t = table.conditions.size();
    std::map<std::string, std::vector<double>> by_observer;
    std::map<std::string, std::size_t> seen;
    const auto expected = matrices.empty() ? 0 : matrices[0].matrix.complete();
    for (const auto& cell : matrices) {
        auto& row = by_observer[cell.observer];
        row.resize(scenes.size() * t);
        if (expected == 0 || cell.matrix.complete() != expected)
            continue;
        ++seen[cell.observer];
        for (std::size_t a = 0; a < t; ++a)
            row[scenes[cell.scene] * t + a] = static_cast<double>(cell.matrix.half_votes(a)) / 2;
    }
    Scores scores;
    for (const auto& observer : table.observers.names())
        scores.push_back(seen[observer] == scenes.size() ? by_observer[observer]
                                                         : std::vector<double>{});
    return scores;
}

double pearson(const std::vector<double>& x, const std::vector<double>& y) {
    const double mx = mean(x), my = mean(y);
    double xy = 0, xx = 0, yy = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xy += (x[i] - mx) * (y[i] - my);
        xx += (x[i] - mx) * (x[i] - mx);
        yy += (y[i] - my) * (y[i] - my);
    }
    return xx > 0 && yy > 0 ? xy / std::sqrt(xx * yy) : undefined;
}

std::vector<double> mid_ranks(const std::vector<double>& values) {
    std::vector<double> ranks;
    for (const double value : values) {
        double rank = 0.5;
        for (const double other : values)
            rank += other < value ? 1 : other == value ? 0.5 : 0;
        ranks.push_back(rank);
    }
    return ranks;
}

void correlations(std::vector<ObserverScreening>& observers, const Scores& scores) {
    for (std::size_t o = 0; o < observers.size(); ++o) {
        observers[o].pearson = observers[o].spearman = undefined;
        if (scores[o].empty())
            continue;
        std::vector<double> others(scores[o].size(), 0);
        int count = 0;
        for (std::size_t other = 0; other < scores.size(); ++other)
            if (other != o && !scores[other].empty()) {
                ++count;
                for (std::size_t j = 0; j < others.size(); ++j)
                    others[j] += scores[other][j];
            }
        if (count == 0)
            continue;
        observers[o].pearson = pearson(scores[o], others); // a sum correlates as its mean does
        observers[o].spearman = pearson(mid_ranks(scores[o]), mid_ranks(others));
    }
}

// Recommendation BT.500, annex on screening: kurtosis chooses the limit of each presentation.
void presentation(std::vector<ObserverScreening>& observers, const Scores& scores, std::size_t j) {
    std::vector<double> values;
    for (const auto& row : scores)
        if (!row.empty())
            values.push_back(row[j]);
    const double m = mean(values), n = static_cast<double>(values.size());
    double m2 = 0, m4 = 0;
    for (const double value : values) {
        m2 += (value - m) * (value - m) / n;
        m4 += std::pow(value - m, 4) / n;
    }
    const double kurtosis = m2 > 0 ? m4 / (m2 * m2) : 0;
    const double limit = std::sqrt(m2) * (kurtosis >= 2 && kurtosis <= 4 ? 2 : std::sqrt(20.0));
    for (std::size_t o = 0; o < scores.size(); ++o)
        if (!scores[o].empty()) {
            ++observers[o].presentations;
            if (m2 > 0) {
                observers[o].above += scores[o][j] >= m + limit ? 1 : 0;
                observers[o].below += scores[o][j] <= m - limit ? 1 : 0;
            }
        }
}

void bt500(std::vector<ObserverScreening>& observers, const Scores& scores) {
    std::size_t presentations = 0;
    for (const auto& row : scores)
        presentations = std::max(presentations, row.size());
    for (std::size_t j = 0; j < presentations; ++j)
        presentation(observers, scores, j);
    for (auto& observer : observers) {
        const auto outside = static_cast<double>(observer.above + observer.below);
        const auto lopsided = static_cast<double>(std::abs(observer.above - observer.below));
        observer.rejected_by_bt500 = outside > 0 &&
                                     outside / static_cast<double>(observer.presentations) > 0.05 &&
                                     lopsided / outside < 0.3;
    }
}

double quantile(std::vector<double> values, double p) {
    std::sort(values.begin(), values.end());
    const double place = p * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, values.size() - 1);
    return values[below] + (place - static_cast<double>(below)) * (values[above] - values[below]);
}

void likelihoods(std::vector<ObserverScreening>& observers, const VoteTable& table) {
    const auto t = table.conditions.size();
    std::vector<std::vector<std::int64_t>> wins(observers.size(),
                                                std::vector<std::int64_t>(t * t, 0));
    std::vector<std::int64_t> all(t * t, 0);
    for (std::size_t vote = 0; vote < table.size(); ++vote) {
        if (table.chosen[vote] == protocols::Choice::Tie)
            continue;
        const bool left = table.chosen[vote] == protocols::Choice::Left;
        const std::size_t winner = left ? table.left[vote] : table.right[vote];
        const std::size_t loser = left ? table.right[vote] : table.left[vote];
        ++wins[table.observer[vote]][winner * t + loser];
        ++all[winner * t + loser];
    }
    std::vector<scaling::WinCounts> views;
    for (const auto& matrix : wins)
        views.push_back({t, matrix});
    if (views.size() < 2)
        return;
    const auto units = scaling::leave_one_out(views, scaling::Link::Probit);
    const auto odds = scaling::leave_one_out(views, scaling::Link::Logit);
    const auto everybody = scaling::fit_thurstone({t, all});
    std::vector<double> known;
    for (std::size_t o = 0; o < observers.size(); ++o) {
        auto& observer = observers[o];
        observer.log10_likelihood_per_vote = units[o].log_likelihood_per_vote / std::numbers::ln10;
        observer.left_out_z = odds[o].z;
        observer.largest_shift = 0;
        for (std::size_t i = 0; i < t; ++i) {
            const double shift = std::abs(units[o].others.theta[i] - everybody.theta[i]);
            if (!(shift * scaling::jod_sigma <= observer.largest_shift)) // NaN stays
                observer.largest_shift = shift * scaling::jod_sigma;
        }
        if (!std::isnan(observer.log10_likelihood_per_vote))
            known.push_back(observer.log10_likelihood_per_vote);
    }
    if (known.empty())
        return;
    const double first = quantile(known, 0.25), range = quantile(known, 0.75) - first;
    for (auto& observer : observers)
        if (range > 0)
            observer.likelihood_distance =
                std::max(0.0, (first - observer.log10_likelihood_per_vote) / range);
}

void triads(std::vector<ObserverScreening>& observers, const VoteTable& table) {
    const Scope rounds{true, true, std::vector<bool>(table.factors.size(), true)};
    std::map<std::string, ObserverScreening*> by_name;
    for (auto& observer : observers)
        by_name[observer.observer] = &observer;
    for (const auto& round : count_votes(table, rounds))
        if (const auto count = circular_triads(round.matrix)) {
            by_name[round.observer]->triads += *count;
            ++by_name[round.observer]->rounds;
        }
    for (auto& observer : observers)
        observer.triads_p = triads_p(observer.triads, observer.rounds,
                                     static_cast<std::int64_t>(table.conditions.size()));
}

// Rows of one observer's session in the order in which they were asked.
std::map<std::uint32_t, std::vector<std::size_t>> sessions_of(const VoteTable& table,
                                                              std::uint32_t observer) {
    std::map<std::uint32_t, std::vector<std::size_t>> rows;
    for (std::size_t vote = 0; vote < table.size(); ++vote)
        if (table.observer[vote] == observer)
            rows[table.session[vote]].push_back(vote);
    for (auto& [session, votes] : rows)
        std::stable_sort(votes.begin(), votes.end(),
                         [&](auto a, auto b) { return table.trial[a] < table.trial[b]; });
    return rows;
}

void sides_and_times(ObserverScreening& observer, const VoteTable& table, std::uint32_t code) {
    std::vector<double> times;
    double least = 1;
    const auto sessions = sessions_of(table, code);
    for (const auto& [session, votes] : sessions) {
        std::int64_t run = 0, longest = 0, answers = 0;
        auto last = protocols::Choice::Tie;
        for (const auto vote : votes) {
            const auto chosen = table.chosen[vote];
            if (table.response_ms[vote] >= 0)
                times.push_back(table.response_ms[vote]);
            run = chosen == protocols::Choice::Tie ? 0 : chosen == last ? run + 1 : 1;
            last = chosen;
            longest = std::max(longest, run);
            answers += chosen != protocols::Choice::Tie ? 1 : 0;
            observer.left += chosen == protocols::Choice::Left ? 1 : 0;
        }
        observer.answers += answers;
        observer.longest_run = std::max(observer.longest_run, longest);
        if (longest > 0)
            least = std::min(least, longest_run_p(longest, answers));
    }
    observer.longest_run_p = std::min(1.0, least * static_cast<double>(sessions.size()));
    const auto side = side_bias(observer.left, observer.answers);
    observer.side_z = side.z;
    observer.side_p = side.p;
    observer.timed = static_cast<std::int64_t>(times.size());
    observer.fast =
        std::count_if(times.begin(), times.end(), [](double ms) { return ms < fast_answer_ms; });
    observer.slow =
        std::count_if(times.begin(), times.end(), [](double ms) { return ms > slow_answer_ms; });
    observer.median_ms = times.empty() ? undefined : quantile(times, 0.5);
}

void raise_flags(ObserverScreening& o) {
    const auto flag = [&](bool raised, std::string words) {
        if (raised)
            o.flags.push_back(std::move(words));
    };
    flag(o.rejected_by_bt500, "BT.500's rule would reject");
    flag(o.pearson < least_correlation,
         fmt::format("correlation with the others {:.2f}, below {}", o.pearson, least_correlation));
    flag(o.likelihood_distance > most_likelihood_distance,
         fmt::format("votes {:.1f} quartile ranges less likely than the first quartile",
                     o.likelihood_distance));
    flag(o.left_out_z < least_left_out_z,
         fmt::format("z of the votes under the others' scale {:.1f}", o.left_out_z));
    flag(o.triads_p > guessing_level,
         fmt::format(
             "not distinguishable from guessing: {} circular triads in {} rounds, p = {:.2g}",
             o.triads, o.rounds, o.triads_p));
    flag(std::abs(o.side_z) > side_z, fmt::format("left chosen {} of {} times", o.left, o.answers));
    flag(o.longest_run_p < run_level,
         fmt::format("{} answers in a row on one side", o.longest_run));
    flag(o.timed > 0 &&
             static_cast<double>(o.fast) > most_fast_answers * static_cast<double>(o.timed),
         fmt::format("{} of {} answers faster than {} ms", o.fast, o.timed, fast_answer_ms));
}

} // namespace

std::vector<ObserverScreening> screen_observers(const VoteTable& table) {
    std::vector<ObserverScreening> observers;
    for (const auto& name : table.observers.names()) {
        auto& observer = observers.emplace_back();
        observer.observer = name;
        observer.log10_likelihood_per_vote = observer.left_out_z = observer.largest_shift =
            undefined;
    }
    const auto scores = scores_of(table);
    bt500(observers, scores);
    correlations(observers, scores);
    likelihoods(observers, table);
    triads(observers, table);
    for (std::uint32_t o = 0; o < observers.size(); ++o) {
        sides_and_times(observers[o], table, o);
        raise_flags(observers[o]);
    }
    return observers;
}

} // namespace analysis::consistency
