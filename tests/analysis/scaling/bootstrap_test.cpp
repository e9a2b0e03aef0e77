#include "analysis/numerics/distributions.h"
#include "analysis/scaling/bootstrap.h"
#include "protocols/random.h"
#include "tests/analysis/scaling/expect_fit.h"
#include "tests/analysis/scaling/golden_votes.h"

#include <algorithm>
#include <numeric>

namespace {

using namespace analysis::scaling;

double sorted_quantile(std::vector<double> values, double p) {
    std::sort(values.begin(), values.end());
    const double h = static_cast<double>(values.size() - 1) * std::clamp(p, 0.0, 1.0);
    return values[static_cast<std::size_t>(std::lround(h))];
}

std::vector<double> column(const Bootstrap& drawn, std::size_t i) {
    std::vector<double> values;
    for (std::size_t at = i; at < drawn.replicates.size(); at += drawn.fit.conditions())
        values.push_back(drawn.replicates[at]);
    return values;
}

// Every figure within 4 Monte-Carlo standard errors of both sides: of 48 comparisons one fails by
// chance in 330 seeds; the seed is fixed.
TEST(Bootstrap, AgreesWithTwoHundredThousandReplicates) {
    const auto expected = golden::read_json("experiment/bootstrap.json");
    const auto observers = golden::win_matrices("observer");
    const int many = 20000;
    const auto drawn = bootstrap(golden::views(observers, 4), {.replicates = many, .seed = 1});
    EXPECT_EQ(drawn.disconnected, 0);
    const double scale = std::sqrt(1.0 / many + 1.0 / 200000);
    const auto levels = expected.at("quantile_levels_percent").get<std::vector<double>>();
    ASSERT_EQ(levels.size(), 9u);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& golden_theta = expected.at("bt_theta_centered").at(golden::methods()[i]);
        const double error = golden_theta.at("se").get<double>();
        EXPECT_NEAR(drawn.mean[i], golden_theta.at("mean").get<double>(), 4 * error * scale);
        EXPECT_NEAR(drawn.standard_error[i] / error, 1, 4 * scale / std::sqrt(2.0));
        const auto values = column(drawn, i);
        for (std::size_t k = 0; k < levels.size(); ++k) {
            const double p = levels[k] / 100, slack = 4 * std::sqrt(p * (1 - p)) * scale;
            const double golden_quantile = golden_theta.at("quantiles")[k].get<double>();
            EXPECT_GE(golden_quantile, sorted_quantile(values, p - slack)) << i << ' ' << p;
            EXPECT_LE(golden_quantile, sorted_quantile(values, p + slack)) << i << ' ' << p;
        }
        EXPECT_EQ(drawn.percentile[i].clamped, false);
        EXPECT_NEAR(drawn.percentile[i].lower, sorted_quantile(values, 0.025),
                    4 * drawn.percentile[i].lower_error);
    }
    // PRT (3) stands above SHSS (0) in 11.3 % of the golden replicates, tied in 0.2 %.
    EXPECT_NEAR(drawn.above[3 * 4 + 0], 0.114, 0.002 + 4 * std::sqrt(0.114 * 0.886) * scale);
    EXPECT_NEAR(drawn.above[3 * 4 + 0] + drawn.above[0 * 4 + 3], 1, 1e-12);
    EXPECT_NEAR(std::accumulate(drawn.first.begin(), drawn.first.end(), 0.0), 1, 1e-12);
}

TEST(Bootstrap, DoesNotDependOnTheNumberOfThreads) {
    const auto observers = golden::win_matrices("observer");
    const auto views = golden::views(observers, 4);
    const auto one = bootstrap(views, {.replicates = 203, .seed = 7, .threads = 1});
    const auto five = bootstrap(views, {.replicates = 203, .seed = 7, .threads = 5});
    EXPECT_EQ(one.replicates, five.replicates);
    const auto other = bootstrap(views, {.replicates = 203, .seed = 8, .threads = 1});
    EXPECT_NE(one.replicates, other.replicates);
}

TEST(Bootstrap, MoreReplicatesBeginWithTheSame) {
    const auto observers = golden::win_matrices("observer");
    const auto views = golden::views(observers, 4);
    const auto few = bootstrap(views, {.replicates = 10, .seed = 7});
    auto many = bootstrap(views, {.replicates = 30, .seed = 7});
    many.replicates.resize(few.replicates.size());
    EXPECT_EQ(few.replicates, many.replicates);
}

// The mean of a sample is a bootstrap whose bounds have a known skewness: BCa moves them the way
// its acceleration says.  Checked by the definition, written out.
TEST(Bootstrap, BcaFollowsItsDefinition) {
    std::vector<double> replicates(999), jackknife{1.0, 1.1, 0.9, 1.05, 0.4};
    for (std::size_t b = 0; b < replicates.size(); ++b)
        replicates[b] = static_cast<double>(b);
    // Estimate between replicates 599 and 600: z0 = Phi^-1(600 / 999).
    const auto interval = bca_interval(replicates, 599.5, jackknife, 0.90);
    double squares = 0, cubes = 0;
    const double mean = 0.89;
    for (const double value : jackknife) {
        squares += std::pow(mean - value, 2);
        cubes += std::pow(mean - value, 3);
    }
    const double a = cubes / (6 * std::pow(squares, 1.5));
    const double z0 = analysis::numerics::normal_quantile(600.0 / 999);
    const auto level = [&](double z) {
        const double shifted = z0 + (z0 + z) / (1 - a * (z0 + z));
        return std::erfc(-shifted / std::sqrt(2.0)) / 2;
    };
    EXPECT_NEAR(interval.lower, 998 * level(-1.6448536269514722), 1e-9);
    EXPECT_NEAR(interval.upper, 998 * level(1.6448536269514722), 1e-9);
    EXPECT_FALSE(interval.clamped);
}

TEST(Bootstrap, OfIdenticalObserversIsAPoint) {
    const std::vector<std::int64_t> wins{0, 3, 1, 0};
    const std::vector<WinCounts> observers(4, WinCounts{2, wins});
    const auto drawn = bootstrap(observers, {.replicates = 50});
    EXPECT_TRUE(drawn.bca[0].constant);
    EXPECT_EQ(drawn.bca[0].lower, drawn.bca[0].upper);
    EXPECT_NEAR(drawn.bca[0].lower, std::log(3) / 2, 1e-14);
    EXPECT_NEAR(drawn.standard_error[0], 0, 1e-14);
}

// Every observer gives the first two as many votes in as many comparisons, and five conditions
// opponents of every strength: in whatever order the sums are rounded, the two are equal.
TEST(Bootstrap, EqualVotesShareTheRankWhateverTheRounding) {
    std::vector<std::vector<std::int64_t>> wins;
    for (std::int64_t o = 0; o < 9; ++o) {
        auto& own = wins.emplace_back(25, 0);
        for (std::size_t a = 0; a < 5; ++a)
            for (std::size_t b = a + 1; b < 5; ++b) {
                const std::int64_t votes =
                    a == 0 && b == 1 ? 5 : 1 + (o + 3 * static_cast<int>(a + b)) % 9;
                own[a * 5 + b] = votes;
                own[b * 5 + a] = 10 - votes;
            }
        // The same total for the second as for the first, taken from other opponents.
        std::int64_t first = 0, second = 0;
        for (std::size_t b = 2; b < 5; ++b) {
            first += own[b];
            second += own[5 + b];
        }
        for (std::size_t b = 2; b < 5; ++b)
            while (second != first && own[5 + b] > 0 && own[5 + b] < 10) {
                const int change = second < first ? 1 : -1;
                own[5 + b] += change;
                own[b * 5 + 1] -= change;
                second += change;
            }
        ASSERT_EQ(first, second);
    }
    std::vector<WinCounts> observers;
    for (const auto& own : wins)
        observers.push_back({5, own});
    const auto drawn = bootstrap(observers, {.replicates = 400});
    EXPECT_NEAR(drawn.above[0 * 5 + 1], 0.5, 1e-12); // a sum of 400 terms
    EXPECT_NEAR(drawn.above[1 * 5 + 0], 0.5, 1e-12);
    EXPECT_NEAR(drawn.first[0], drawn.first[1], 1e-12);
}

// 300 simulated experiments of three conditions, 40 observers, 3 votes a pair.  Coverage is
// binomial with deviation 0.013 about a value a little below 0.95 (percentile intervals of 40 are 1
// % short).
TEST(Bootstrap, CoversAtItsLevel) {
    const std::vector<double> truth{0.8, -0.1, -0.7};
    protocols::Rng rng(protocols::Seed{5});
    int percentile = 0, bca = 0;
    const int experiments = 300;
    for (int experiment = 0; experiment < experiments; ++experiment) {
        std::vector<std::vector<std::int64_t>> wins(40, std::vector<std::int64_t>(9, 0));
        for (auto& observer : wins)
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = i + 1; j < 3; ++j)
                    for (int vote = 0; vote < 3; ++vote) {
                        const double p = choice_probability(Link::Logit, truth[i] - truth[j]);
                        const bool first = protocols::draw_unit(rng) < p;
                        ++observer[first ? i * 3 + j : j * 3 + i];
                    }
        std::vector<WinCounts> views;
        for (const auto& observer : wins)
            views.push_back({3, observer});
        const auto drawn = bootstrap(
            views,
            {.replicates = 400, .seed = static_cast<std::uint64_t>(experiment), .threads = 1});
        const auto covers = [&](const Interval& interval) {
            return interval.lower <= truth[0] && truth[0] <= interval.upper;
        };
        percentile += covers(drawn.percentile[0]);
        bca += covers(drawn.bca[0]);
    }
    EXPECT_NEAR(percentile / static_cast<double>(experiments), 0.945, 4 * 0.013);
    EXPECT_NEAR(bca / static_cast<double>(experiments), 0.945, 4 * 0.013);
}

// Two observers who always disagree: half the replicates are unanimous and have no finite maximum.
TEST(Bootstrap, CountsReplicatesWithoutAFiniteScale) {
    const std::vector<std::int64_t> yes{0, 4, 0, 0}, no{0, 0, 4, 0};
    const std::vector<WinCounts> observers{{2, yes}, {2, no}};
    const auto drawn = bootstrap(observers, {.replicates = 400, .seed = 3});
    EXPECT_NEAR(drawn.penalised, 200, 4 * 10); // binomial: 10 is its deviation
    EXPECT_EQ(drawn.disconnected, 0);
    for (const double value : drawn.replicates)
        EXPECT_TRUE(std::isfinite(value));
}

// Each saw another pair of three: a replicate of one observer alone has no common scale.
TEST(Bootstrap, LeavesOutReplicatesThatFallApart) {
    const std::vector<std::int64_t> one{0, 3, 0, 2, 0, 0, 0, 0, 0}, two{0, 0, 0, 0, 0, 4, 0, 1, 0};
    const std::vector<WinCounts> observers{{3, one}, {3, two}};
    for (const auto link : {Link::Logit, Link::Probit}) {
        const auto drawn = bootstrap(observers, {.replicates = 200, .seed = 3, .link = link});
        EXPECT_NEAR(drawn.disconnected, 100, 4 * 7);
        EXPECT_EQ(drawn.replicates.size(), 3u * static_cast<std::size_t>(drawn.kept()));
        for (const double value : drawn.replicates)
            EXPECT_TRUE(std::isfinite(value));
    }
}

TEST(Bootstrap, OfADisconnectedWholeSaysSo) {
    const std::vector<std::int64_t> wins{0, 0, 0, 0};
    const std::vector<WinCounts> observers{{2, wins}};
    const auto drawn = bootstrap(observers, {.replicates = 10});
    EXPECT_EQ(drawn.fit.estimate, Estimate::None);
    EXPECT_TRUE(drawn.replicates.empty());
}

} // namespace
