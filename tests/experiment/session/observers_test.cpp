#include "experiment/session/observers.h"

#include <cmath>

namespace {

using namespace experiment::session;
using protocols::Side;
using testing::HasSubstr;

protocols::Study study_of(const std::vector<std::string>& conditions) {
    protocols::Study study;
    study.id = "glow";
    for (const auto& id : conditions)
        study.conditions.push_back({{id}, id, protocols::OwnImages{}, 0});
    return study;
}

const auto three = study_of({"shss-25", "green", "phong"});

std::string error_of(const std::string& text) {
    const auto observer = parse_simulated_observer(text, three);
    return observer ? "no error" : observer.error();
}

// How often the left picture is chosen in so many trials.
int lefts(const SimulatedObserver& observer, const protocols::Trial& trial, int trials) {
    int count = 0;
    for (int number = 1; number <= trials; ++number)
        count += answer(observer, "glow", {"S1"}, 1, number, trial).side == Side::Left ? 1 : 0;
    return count;
}

double normal_cdf(double z) {
    return 0.5 * std::erfc(-z / std::sqrt(2.0));
}

// Five standard errors: of 10 checks like this, fewer than 1 in 100,000 fails by chance; and the
// seeds are fixed.
void expect_share(int count, int trials, double share) {
    const auto error = std::sqrt(share * (1 - share) / trials);
    EXPECT_NEAR(static_cast<double>(count) / trials, share, 5 * error);
}

TEST(SimulatedObserver, IsReadFromText) {
    const auto observer = parse_simulated_observer(
        "scores=shss-25:1.5,green:0.2,phong:-1;noise=0.5;bias=0.1;lapse=0.02;seed=7", three);
    ASSERT_TRUE(observer) << observer.error();
    EXPECT_EQ(observer->scores.at({"shss-25"}), 1.5);
    EXPECT_EQ(observer->scores.at({"phong"}), -1);
    EXPECT_EQ(observer->noise, 0.5);
    EXPECT_EQ(observer->side_bias, 0.1);
    EXPECT_EQ(observer->lapse, 0.02);
    EXPECT_EQ(observer->seed, 7u);
}

TEST(SimulatedObserver, HasEvenlySpreadScoresByDefault) {
    const auto observer = parse_simulated_observer("", three);
    ASSERT_TRUE(observer);
    EXPECT_EQ(text_of(*observer),
              "scores=green:0.5,phong:0,shss-25:1;noise=1;bias=0;lapse=0;seed=1");
}

TEST(SimulatedObserver, IsTheSameWhenWrittenOutAndReadAgain) {
    const auto observer = *parse_simulated_observer("noise=0.1;seed=18446744073709551615", three);
    const auto again = parse_simulated_observer(text_of(observer), three);
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(text_of(*again), text_of(observer));
    EXPECT_EQ(again->noise, 0.1);
}

TEST(SimulatedObserver, RefusesWhatItDoesNotUnderstand) {
    EXPECT_THAT(error_of("scores=wax:1,green:0,phong:0"),
                HasSubstr("\"wax:1\", expected a condition of the study: shss-25, green, phong"));
    EXPECT_THAT(error_of("scores=shss-25:1,green:0"), HasSubstr("a score for phong, too"));
    EXPECT_THAT(error_of("scores=shss-25:1,green:0,phong"), HasSubstr("like shss-25:1.0"));
    EXPECT_THAT(error_of("scores=green:1,green:0,phong:1"), HasSubstr("every condition once"));
    EXPECT_THAT(error_of("scores=shss-25:nan,green:0,phong:0"), HasSubstr("like shss-25:1.0"));
    EXPECT_THAT(error_of("noise=0"), HasSubstr("a standard deviation above 0"));
    EXPECT_THAT(error_of("noise=-1"), HasSubstr("a standard deviation above 0"));
    EXPECT_THAT(error_of("noise=1 "), HasSubstr("a standard deviation above 0"));
    EXPECT_THAT(error_of("noise=nan"), HasSubstr("a standard deviation above 0"));
    EXPECT_THAT(error_of("lapse=1.5"), HasSubstr("0 to 1"));
    EXPECT_THAT(error_of("seed=-1"), HasSubstr("a whole number"));
    EXPECT_THAT(error_of("mood=good"), HasSubstr("\"mood=good\", expected scores=, noise="));
    EXPECT_THAT(error_of("noise=1;noise=2"), HasSubstr("\"noise=2\", expected noise once"));
    EXPECT_THAT(error_of("noise=1;"), HasSubstr("\"\", expected scores="));
}

// Thurstone, Case V: the difference of two impressions has the standard deviation noise * sqrt 2.
TEST(SimulatedObserver, ChoosesAsOftenAsThurstoneSays) {
    const auto observer =
        *parse_simulated_observer("scores=shss-25:1,green:0,phong:0;noise=0.8;seed=3", three);
    const int trials = 20000;
    expect_share(lefts(observer, {{}, {}, {"shss-25"}, {"green"}}, trials), trials,
                 normal_cdf(1.0 / (0.8 * std::sqrt(2.0))));
    expect_share(lefts(observer, {{}, {}, {"green"}, {"shss-25"}}, trials), trials,
                 normal_cdf(-1.0 / (0.8 * std::sqrt(2.0))));
    expect_share(lefts(observer, {{}, {}, {"green"}, {"phong"}}, trials), trials, 0.5);
}

TEST(SimulatedObserver, LeansToTheSideOfItsBias) {
    const auto observer =
        *parse_simulated_observer("scores=shss-25:0,green:0,phong:0;bias=0.5", three);
    expect_share(lefts(observer, {{}, {}, {"green"}, {"phong"}}, 20000), 20000,
                 normal_cdf(0.5 / std::sqrt(2.0)));
}

TEST(SimulatedObserver, GuessesInItsLapses) {
    const auto observer =
        *parse_simulated_observer("scores=shss-25:9,green:0,phong:0;noise=0.1;lapse=0.2", three);
    expect_share(lefts(observer, {{}, {}, {"shss-25"}, {"green"}}, 20000), 20000, 0.9);
}

TEST(SimulatedObserver, AnswersByWhoSheIsAndWhatSheIsAsked) {
    const auto observer = *parse_simulated_observer("", three);
    const protocols::Trial trial{{}, {}, {"green"}, {"phong"}};
    const auto times = [&](const std::string& study, const std::string& name, int session) {
        std::vector<long long> ns;
        for (int number = 1; number <= 5; ++number)
            ns.push_back(
                answer(observer, study, {name}, session, number, trial).response_time.count());
        return ns;
    };
    EXPECT_EQ(times("glow", "S1", 1), times("glow", "S1", 1));
    EXPECT_NE(times("glow", "S1", 1), times("glow", "S2", 1));
    EXPECT_NE(times("glow", "S1", 1), times("glow", "S1", 2));
    EXPECT_NE(times("glow", "S1", 1), times("other", "S1", 1));
    for (const auto ns : times("glow", "S1", 1))
        EXPECT_GT(ns, 400'000'000);
}

} // namespace
