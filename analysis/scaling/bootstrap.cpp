// A replicate is a weighted sum of the observers' matrices and a refit from the full fit's scores.
#include "analysis/scaling/bootstrap.h"

#include "analysis/numerics/distributions.h"
#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/fit_choices.h"
#include "analysis/scaling/thurstone.h"
#include "protocols/contract.h"
#include "protocols/digest.h"
#include "protocols/random.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

namespace analysis::scaling {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double close_enough = 1e-8; // a replicate's last step; what it leaves is of its square

ChoiceFit fit_link(const WinCounts& counts, Link link) {
    return link == Link::Logit ? fit_bradley_terry(counts) : fit_thurstone(counts);
}

std::vector<std::int64_t> summed(std::span<const WinCounts> observers) {
    std::vector<std::int64_t> sum(observers[0].wins.size(), 0);
    for (const auto& observer : observers)
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += observer.wins[k];
    return sum;
}

std::vector<Comparison> pairs_of(std::span<const WinCounts> observers) {
    const auto sum = summed(observers);
    return comparisons_of(WinCounts{observers[0].conditions, sum});
}

protocols::Rng stream_of(std::uint64_t seed, int replicate) {
    const auto digest = protocols::sha256(fmt::format("observer bootstrap|{}|{}", seed, replicate));
    protocols::Seed start{};
    std::copy_n(digest.begin(), start.size(), start.begin());
    return protocols::Rng(start);
}

enum class Refit { Maximum, Penalised, Disconnected };

// One thread's refits; every replicate depends on its own number only.
class Replicator {
  public:
    Replicator(std::span<const WinCounts> observers,
               const ChoiceFit& fit,
               const BootstrapOptions& options)
        : observers_(observers), start_(fit.theta), options_(options), t_(fit.conditions()),
          wins_(t_ * t_), model_(t_, pairs_of(observers), {.link = options.link}),
          weight_(observers.size()) {}

    Refit draw(int replicate, std::span<double> theta) {
        sum_drawn(replicate);
        bool both_ways = true;
        for (auto& pair : model_.comparisons()) {
            pair.first_wins = static_cast<double>(wins_[pair.first * t_ + pair.second]);
            pair.second_wins = static_cast<double>(wins_[pair.second * t_ + pair.first]);
            both_ways = both_ways && pair.first_wins > 0 && pair.second_wins > 0;
        }
        // Wins both ways on every pair of the connected whole: surely a finite maximum.
        if (both_ways || existence({t_, wins_}).scale == Scale::Finite) {
            const auto maximum = model_.maximise(start_, close_enough);
            if (maximum.converged) {
                std::copy(maximum.parameters.begin(), maximum.parameters.end(), theta.begin());
                return Refit::Maximum;
            }
        }
        const auto fit = fit_link({t_, wins_}, options_.link);
        std::copy(fit.theta.begin(), fit.theta.end(), theta.begin());
        return fit.estimate == Estimate::None                ? Refit::Disconnected
               : fit.estimate == Estimate::MaximumLikelihood ? Refit::Maximum
                                                             : Refit::Penalised;
    }

  private:
    void sum_drawn(int replicate) {
        auto rng = stream_of(options_.seed, replicate);
        std::fill(weight_.begin(), weight_.end(), 0);
        for (std::size_t k = 0; k < observers_.size(); ++k)
            ++weight_[static_cast<std::size_t>(protocols::draw_below(rng, observers_.size()))];
        std::fill(wins_.begin(), wins_.end(), 0);
        for (std::size_t o = 0; o < observers_.size(); ++o)
            if (weight_[o] > 0)
                for (std::size_t k = 0; k < wins_.size(); ++k)
                    wins_[k] += weight_[o] * observers_[o].wins[k];
    }

    std::span<const WinCounts> observers_;
    std::vector<double> start_;
    BootstrapOptions options_;
    std::size_t t_;
    std::vector<std::int64_t> wins_;
    ChoiceModel model_;
    std::vector<std::int64_t> weight_;
};

std::vector<Refit> draw_all(std::span<const WinCounts> observers,
                            const ChoiceFit& fit,
                            const BootstrapOptions& options,
                            std::vector<double>& theta) {
    const auto many = static_cast<std::size_t>(options.replicates);
    const std::size_t t = fit.conditions();
    theta.resize(many * t);
    std::vector<Refit> how(many);
    const unsigned asked =
        options.threads != 0 ? options.threads : std::thread::hardware_concurrency();
    const std::size_t threads = std::clamp<std::size_t>(asked, 1, many);
    const auto block = [&](std::size_t from, std::size_t to) {
        Replicator replicator(observers, fit, options);
        for (std::size_t b = from; b < to; ++b)
            how[b] = replicator.draw(static_cast<int>(b), std::span(theta).subspan(b * t, t));
    };
    std::vector<std::jthread> workers;
    for (std::size_t w = 1; w < threads; ++w)
        workers.emplace_back(block, many * w / threads, many * (w + 1) / threads);
    block(0, many / threads);
    workers.clear(); // joins
    return how;
}

void keep_connected(Bootstrap& result, const std::vector<Refit>& how) {
    const std::size_t t = result.fit.conditions();
    std::size_t kept = 0;
    for (std::size_t b = 0; b < how.size(); ++b) {
        result.penalised += how[b] == Refit::Penalised;
        if (how[b] == Refit::Disconnected) {
            ++result.disconnected;
            continue;
        }
        std::copy_n(result.replicates.begin() + static_cast<std::ptrdiff_t>(b * t), t,
                    result.replicates.begin() + static_cast<std::ptrdiff_t>(kept * t));
        ++kept;
    }
    result.replicates.resize(kept * t);
}

std::vector<double> column(std::span<const double> rows, std::size_t t, std::size_t i) {
    std::vector<double> values;
    for (std::size_t at = i; at < rows.size(); at += t)
        values.push_back(rows[at]);
    return values;
}

void summarise_moments(Bootstrap& result) {
    const std::size_t t = result.fit.conditions();
    const auto kept = static_cast<double>(result.kept());
    result.mean.assign(t, 0.0);
    result.covariance.assign(t * t, 0.0);
    const auto& rows = result.replicates;
    for (std::size_t at = 0; at < rows.size(); ++at)
        result.mean[at % t] += rows[at] / kept;
    for (std::size_t b = 0; b < rows.size(); b += t)
        for (std::size_t i = 0; i < t; ++i)
            for (std::size_t j = 0; j < t; ++j)
                result.covariance[i * t + j] +=
                    (rows[b + i] - result.mean[i]) * (rows[b + j] - result.mean[j]) / (kept - 1);
    for (std::size_t i = 0; i < t; ++i)
        result.standard_error.push_back(std::sqrt(result.covariance[i * t + i]));
}

// Equal votes give equal scores but for rounding; other scores are further apart than this.
bool alike(double a, double b) {
    return std::abs(a - b) <= 1e-10 * (1 + std::abs(a));
}

void summarise_ranks(Bootstrap& result) {
    const std::size_t t = result.fit.conditions();
    const auto kept = static_cast<double>(result.kept());
    result.first.assign(t, 0.0);
    result.above.assign(t * t, 0.0);
    for (std::size_t at = 0; at < result.replicates.size(); at += t) {
        const auto row = std::span(result.replicates).subspan(at, t);
        const double best = *std::max_element(row.begin(), row.end());
        const auto sharing = static_cast<double>(std::count_if(
            row.begin(), row.end(), [&](double score) { return alike(score, best); }));
        for (std::size_t i = 0; i < t; ++i) {
            result.first[i] += alike(row[i], best) ? 1 / (sharing * kept) : 0;
            for (std::size_t j = 0; j < t; ++j)
                if (j != i)
                    result.above[i * t + j] += alike(row[i], row[j]) ? 0.5 / kept
                                               : row[i] > row[j]     ? 1 / kept
                                                                     : 0;
        }
    }
}

void summarise_intervals(Bootstrap& result, std::span<const WinCounts> observers) {
    const std::size_t t = result.fit.conditions();
    const auto everybody = summed(observers);
    std::vector<std::int64_t> others(everybody.size());
    for (const auto& observer : observers) {
        for (std::size_t k = 0; k < others.size(); ++k)
            others[k] = everybody[k] - observer.wins[k];
        const auto fit = fit_link({t, others}, result.options.link);
        result.jackknife.insert(result.jackknife.end(), fit.theta.begin(), fit.theta.end());
    }
    for (std::size_t i = 0; i < t; ++i) {
        auto values = column(result.replicates, t, i);
        result.percentile.push_back(percentile_interval(values, result.options.level));
        result.bca.push_back(bca_interval(std::move(values), result.fit.theta[i],
                                          column(result.jackknife, t, i), result.options.level));
    }
}

// Type 7: linear between order statistics, the least at 0 and the greatest at 1.
double quantile(const std::vector<double>& sorted, double p) {
    const double h = static_cast<double>(sorted.size() - 1) * std::clamp(p, 0.0, 1.0);
    const auto below = static_cast<std::size_t>(h);
    const auto next = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (h - static_cast<double>(below)) * (sorted[next] - sorted[below]);
}

// A quantile of B draws has the rank of a binomial: its neighbours one deviation away show its
// error.
double quantile_error(const std::vector<double>& sorted, double p) {
    const double deviation = std::sqrt(p * (1 - p) / static_cast<double>(sorted.size()));
    return (quantile(sorted, p + deviation) - quantile(sorted, p - deviation)) / 2;
}

Interval between(const std::vector<double>& sorted, double lower, double upper) {
    return {quantile(sorted, lower),
            quantile(sorted, upper),
            quantile_error(sorted, lower),
            quantile_error(sorted, upper),
            false,
            sorted.front() == sorted.back()};
}

} // namespace

Interval percentile_interval(std::vector<double> replicates, double level) {
    EXPECTS(!replicates.empty() && level > 0 && level < 1);
    std::sort(replicates.begin(), replicates.end());
    return between(replicates, (1 - level) / 2, (1 + level) / 2);
}

Interval bca_interval(std::vector<double> replicates,
                      double estimate,
                      std::span<const double> jackknife,
                      double level) {
    EXPECTS(!replicates.empty() && level > 0 && level < 1);
    std::sort(replicates.begin(), replicates.end());
    if (replicates.front() == replicates.back())
        return between(replicates, 0, 1);
    const auto below = std::lower_bound(replicates.begin(), replicates.end(), estimate);
    const auto equal_end = std::upper_bound(below, replicates.end(), estimate);
    const auto many = static_cast<double>(replicates.size());
    const double rank = (static_cast<double>(below - replicates.begin()) +
                         static_cast<double>(equal_end - below) / 2) /
                        many;
    double mean = 0, squares = 0, cubes = 0;
    for (const double value : jackknife)
        mean += value / static_cast<double>(jackknife.size());
    for (const double value : jackknife) {
        squares += (mean - value) * (mean - value);
        cubes += (mean - value) * (mean - value) * (mean - value);
    }
    if (std::isnan(squares)) // somebody's absence left no scale
        return {nothing, nothing, nothing, nothing, false, false};
    const double acceleration = squares > 0 ? cubes / (6 * std::pow(squares, 1.5)) : 0;
    const double outermost = 1 / (many + 1);
    bool clamped = false;
    const auto inside = [&](double p) {
        clamped = clamped || !(p >= outermost && p <= 1 - outermost);
        return std::clamp(p, outermost, 1 - outermost);
    };
    const double bias = numerics::normal_quantile(inside(rank));
    const auto corrected = [&](double p) {
        const double z = bias + numerics::normal_quantile(p);
        return inside(numerics::normal_upper_tail(-(bias + z / (1 - acceleration * z))).p);
    };
    auto interval = between(replicates, corrected((1 - level) / 2), corrected((1 + level) / 2));
    interval.clamped = clamped;
    return interval;
}

Bootstrap bootstrap(std::span<const WinCounts> observers, const BootstrapOptions& options) {
    EXPECTS(!observers.empty() && options.replicates >= 1);
    EXPECTS(options.level > 0 && options.level < 1);
    const std::size_t t = observers[0].conditions;
    for (const auto& observer : observers)
        EXPECTS(observer.conditions == t && observer.wins.size() == t * t);
    Bootstrap result;
    result.options = options;
    const auto everybody = summed(observers);
    result.fit = fit_link({t, everybody}, options.link);
    if (result.fit.estimate == Estimate::None)
        return result;
    keep_connected(result, draw_all(observers, result.fit, options, result.replicates));
    if (result.kept() == 0)
        return result;
    summarise_moments(result);
    summarise_ranks(result);
    summarise_intervals(result, observers);
    return result;
}

} // namespace analysis::scaling
