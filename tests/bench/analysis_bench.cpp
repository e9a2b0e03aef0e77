// What the analysis takes, and how many digits it keeps: every row has a time and, as the counter
// `digits`, -log10 of its worst relative error (15.9 at most), so that speed is never shown without
// what it costs.  One core.  `analysis_benchmarks` prints the table, with R beside it.
#include "analysis/anova/checks.h"
#include "analysis/anova/comparisons.h"
#include "analysis/anova/one_way.h"
#include "analysis/anova/shapiro_wilk.h"
#include "analysis/anova/within_observers.h"
#include "analysis/numerics/nist_file.h"
#include "analysis/numerics/one_way_exact.h"
#include "analysis/numerics/studentized_range.h"
#include "analysis/scaling/bootstrap.h"
#include "analysis/scaling/bradley_terry.h"
#include "analysis/scaling/thurstone.h"
#include "analysis/score_cells.h"
#include "analysis/vote_csv.h"
#include "protocols/random.h"
#include "tests/analysis/golden.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include <cmath>
#include <numbers>

namespace {

using namespace analysis;
using nlohmann::json;

// Every row has both counters, which the program's CSV form asks for; 0 where there is nothing.
void put(benchmark::State& state, double digits, double peak_mib = 0) {
    state.counters["digits"] = digits;
    state.counters["peak_MiB"] = peak_mib;
}

double digits(double found, double expected) {
    return std::min(15.9, -std::log10(std::abs(found - expected) / std::abs(expected)));
}

const json& expected() {
    static const json values = json::parse(golden_text("experiment/expected.json"));
    return values;
}

// Counts of a known process: condition i has score (t - 1)/2 - i, over ten; a shift per observer.
std::vector<std::vector<std::int64_t>> win_matrices(std::size_t t, std::size_t observers) {
    protocols::Rng rng({1});
    std::vector<std::vector<std::int64_t>> matrices;
    for (std::size_t o = 0; o < observers; ++o) {
        auto& wins = matrices.emplace_back(t * t, 0);
        for (std::size_t i = 0; i < t; ++i)
            for (std::size_t j = i + 1; j < t; ++j) {
                const double d = 0.1 * static_cast<double>(j - i);
                for (int vote = 0; vote < 27; ++vote) {
                    const bool first = protocols::draw_unit(rng) < 1 / (1 + std::exp(-d));
                    ++wins[first ? i * t + j : j * t + i];
                }
            }
    }
    return matrices;
}

std::vector<std::int64_t> sum_of(const std::vector<std::vector<std::int64_t>>& matrices) {
    std::vector<std::int64_t> sum(matrices[0].size(), 0);
    for (const auto& wins : matrices)
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += wins[k];
    return sum;
}

// 100 observers, 20 conditions, as many scenes as it takes.
std::string many_votes(std::int64_t votes) {
    protocols::Rng rng({2});
    std::string text = "observer,session,scene,left,right,chosen\n";
    std::int64_t written = 0;
    for (int scene = 0; written < votes; ++scene)
        for (int o = 0; o < 100; ++o)
            for (int i = 0; i < 20; ++i)
                for (int j = i + 1; j < 20 && written < votes; ++j, ++written)
                    text += fmt::format("O{},1,s{},c{},c{},{}\n", o, scene, i, j,
                                        protocols::draw_coin(rng) ? "left" : "right");
    return text;
}

std::size_t all_matrices(const VoteTable& table) {
    std::size_t matrices = 0;
    for (const auto& scope : usual_scopes(table))
        matrices += count_votes(table, scope).size();
    return matrices;
}

void seed_study_matrices(benchmark::State& state) {
    const auto text = golden_text("experiment/votes.csv");
    for (auto _ : state)
        benchmark::DoNotOptimize(all_matrices(read_votes_csv(text, "votes").value()));
    put(state, 15.9); // counts: the golden tests compare each
}

void million_votes(benchmark::State& state) {
    const auto text = many_votes(1'000'000);
    std::int64_t votes = 0;
    for (auto _ : state) {
        const auto table = read_votes_csv(text, "votes").value();
        benchmark::DoNotOptimize(all_matrices(table));
        votes = count_votes(table).total_comparisons();
    }
    put(state, votes == 1'000'000 ? 15.9 : 0);
}

void ten_million_votes_memory(benchmark::State& state) {
    auto text = many_votes(10'000'000);
    text.shrink_to_fit();
    for (auto _ : state)
        benchmark::DoNotOptimize(count_votes(read_votes_csv(text, "votes").value()));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    put(state, 0, static_cast<double>(usage.ru_maxrss) / 1024);
}

std::vector<std::vector<std::int64_t>> by_condition(const ScoreCells& cells) {
    const auto t = cells.factors.back().levels;
    std::vector<std::vector<std::int64_t>> groups(t);
    for (std::size_t i = 0; i < cells.half_votes.size(); ++i)
        groups[i % t].push_back(cells.half_votes[i]);
    return groups;
}

// Within observers with 1, 2 and 4 factors, one-way on observer means and on rounds, with checks
// and all pairs: every table of the study.
void seed_study_anova(benchmark::State& state) {
    const auto table = golden_votes();
    const auto observers = complete_observers(table, design_facts(table));
    double f = 0;
    for (auto _ : state) {
        for (const auto& scope :
             {Scope{}, Scope{true, false, {true, false}}, Scope{true, true, {true, true}}}) {
            const auto cells = *score_cells(table, observers, scope);
            const auto within = anova::within_observers_of_counts(observers.size(), cells.factors,
                                                                  cells.half_votes, cells.divisor);
            if (cells.factors.size() == 1)
                f = within.effects.back().test.f;
            if (cells.factors.size() == 2)
                continue;
            const auto groups = by_condition(cells);
            const auto one = anova::one_way_of_counts(groups, cells.divisor);
            benchmark::DoNotOptimize(anova::tukey(one.mean, one.n, one.within));
            benchmark::DoNotOptimize(anova::levene(groups));
            benchmark::DoNotOptimize(anova::brown_forsythe(groups));
            benchmark::DoNotOptimize(anova::welch(one));
        }
    }
    state.counters["digits"] =
        digits(f, expected()["anova"]["rm_method"]["method"]["F"].get<double>());
}

void tukey_of_four(benchmark::State& state) {
    const auto& golden = expected()["anova"]["rm_method_tukey"];
    std::vector<double> q;
    for (const auto& pair : golden["pairs"])
        q.push_back(pair["q"].get<double>());
    double worst = 15.9;
    std::vector<double> p(q.size());
    for (auto _ : state)
        for (std::size_t i = 0; i < q.size(); ++i)
            p[i] = numerics::studentized_range_upper_tail(q[i], 4, 27).p;
    for (std::size_t i = 0; i < q.size(); ++i)
        worst = std::min(worst, digits(p[i], golden["pairs"][i]["p"].get<double>()));
    put(state, worst);
}

// Checked by halving the steps: the quadrature's own estimate of its error.
void tukey_of(benchmark::State& state, std::size_t groups, double df) {
    std::vector<double> p(groups * (groups - 1) / 2);
    const double step = 8.7 / static_cast<double>(p.size());
    const auto q = [&](std::size_t i) { return 0.5 + step * static_cast<double>(i); };
    const auto k = static_cast<double>(groups);
    for (auto _ : state) {
        numerics::StudentizedRanges ranges(k);
        for (std::size_t i = 0; i < p.size(); ++i)
            p[i] = ranges.upper_tail(q(i), df).p;
    }
    double worst = 15.9;
    for (std::size_t i = 0; i < p.size(); i += p.size() / 15)
        worst = std::min(worst,
                         digits(p[i], numerics::studentized_range_upper_tail(q(i), k, df, 0.5).p));
    put(state, worst);
}

void tukey_of_thirty(benchmark::State& state) {
    tukey_of(state, 30, 120);
}

void tukey_of_hundred(benchmark::State& state) {
    tukey_of(state, 100, 891);
}

std::vector<std::int64_t> golden_wins() {
    const auto matrix = count_votes(golden_votes());
    std::vector<std::int64_t> wins(16, 0);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (i != j)
                wins[i * 4 + j] = matrix.wins(i, j);
    return wins;
}

template <class Fit>
void fit_of_four(benchmark::State& state, Fit fit, const char* model) {
    const auto wins = golden_wins();
    std::vector<double> theta;
    for (auto _ : state)
        theta = fit(scaling::WinCounts{4, wins}).theta;
    double worst = 15.9;
    for (std::size_t i = 0; i < 4; ++i)
        worst = std::min(
            worst, digits(theta[i],
                          expected()["choice_models"][model]["theta_centered"][i].get<double>()));
    put(state, worst);
}

void bradley_terry_of_four(benchmark::State& state) {
    fit_of_four(state, scaling::fit_bradley_terry, "bradley_terry");
}

void thurstone_of_four(benchmark::State& state) {
    fit_of_four(state, scaling::fit_thurstone, "thurstone_V_unit_sigma_difference");
}

// The residual of the likelihood equations over the votes, for want of a golden fit.  `slope` is
// the derivative of a vote's log-likelihood by the difference it is for.
template <class Fit, class Slope>
void fit_of_twenty(benchmark::State& state, Fit fit, Slope slope) {
    const auto wins = sum_of(win_matrices(20, 100));
    std::vector<double> theta;
    for (auto _ : state)
        theta = fit(scaling::WinCounts{20, wins}).theta;
    double worst = 0;
    for (std::size_t i = 0; i < 20; ++i) {
        double residual = 0, votes = 0;
        for (std::size_t j = 0; j < 20; ++j)
            if (i != j) {
                const auto a = static_cast<double>(wins[i * 20 + j]);
                const auto b = static_cast<double>(wins[j * 20 + i]);
                const double d = theta[i] - theta[j];
                residual += a * slope(d) - b * slope(-d);
                votes += a + b;
            }
        worst = std::max(worst, std::abs(residual) / votes);
    }
    put(state, std::min(15.9, -std::log10(worst)));
}

void bradley_terry_of_twenty(benchmark::State& state) {
    fit_of_twenty(state, scaling::fit_bradley_terry,
                  [](double d) { return 1 / (1 + std::exp(d)); });
}

void thurstone_of_twenty(benchmark::State& state) {
    fit_of_twenty(state, scaling::fit_thurstone, [](double d) { // phi over Phi
        return std::sqrt(2 / std::numbers::pi) * std::exp(-d * d / 2) /
               std::erfc(-d / std::numbers::sqrt2);
    });
}

void bootstrap_of(benchmark::State& state,
                  const std::vector<std::vector<std::int64_t>>& wins,
                  std::size_t t) {
    std::vector<scaling::WinCounts> views;
    for (const auto& matrix : wins)
        views.push_back({t, matrix});
    scaling::Bootstrap result;
    for (auto _ : state)
        result = scaling::bootstrap(views, {.replicates = 1000, .seed = 1, .threads = 1});
    put(state, 0); // golden/experiment/bootstrap.json holds it to Monte-Carlo error in the tests
}

void bootstrap_of_four(benchmark::State& state) {
    std::vector<std::vector<std::int64_t>> wins;
    for (const auto& scoped : count_votes(golden_votes(), {true, false, {}})) {
        auto& matrix = wins.emplace_back(16, 0);
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                if (i != j)
                    matrix[i * 4 + j] = scoped.matrix.wins(i, j);
    }
    bootstrap_of(state, wins, 4);
}

void bootstrap_of_twenty(benchmark::State& state) {
    bootstrap_of(state, win_matrices(20, 100), 20);
}

void nist_smls09(benchmark::State& state) {
    std::ifstream file(PAIRLIGHT_TEST_DATA "/nist/SmLs09.dat", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    double f = 0;
    for (auto _ : state)
        f = numerics::one_way_exact(numerics::read_nist_one_way(text, "SmLs09").value().groups).f;
    put(state, digits(f, 2001));
}

void shapiro_wilk_of(benchmark::State& state) {
    std::vector<double> values;
    protocols::Rng rng({3});
    for (std::int64_t i = 0; i < state.range(0); ++i)
        values.push_back(protocols::draw_unit(rng));
    anova::ShapiroWilk test;
    for (auto _ : state)
        test = anova::shapiro_wilk(values);
    put(state, 0);
}

BENCHMARK(seed_study_matrices)->Unit(benchmark::kMillisecond);
BENCHMARK(million_votes)->Unit(benchmark::kMillisecond);
BENCHMARK(seed_study_anova)->Unit(benchmark::kMillisecond);
BENCHMARK(tukey_of_four)->Unit(benchmark::kMillisecond);
BENCHMARK(tukey_of_thirty)->Unit(benchmark::kMillisecond);
BENCHMARK(tukey_of_hundred)->Unit(benchmark::kMillisecond);
BENCHMARK(bradley_terry_of_four)->Unit(benchmark::kMillisecond);
BENCHMARK(thurstone_of_four)->Unit(benchmark::kMillisecond);
BENCHMARK(bradley_terry_of_twenty)->Unit(benchmark::kMillisecond);
BENCHMARK(thurstone_of_twenty)->Unit(benchmark::kMillisecond);
BENCHMARK(bootstrap_of_four)->Unit(benchmark::kMillisecond);
BENCHMARK(bootstrap_of_twenty)->Unit(benchmark::kMillisecond);
BENCHMARK(nist_smls09)->Unit(benchmark::kMillisecond);
BENCHMARK(shapiro_wilk_of)->Arg(1080)->Arg(5000)->Unit(benchmark::kMillisecond);
BENCHMARK(ten_million_votes_memory)->Unit(benchmark::kMillisecond)->Iterations(1);

} // namespace

BENCHMARK_MAIN();
