#include "protocols/main_order.h"
#include "protocols/schedule.h"
#include "tests/protocols/designs.h"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace {

using namespace protocols;
using tests::design;

const ObserverId observer{"P7K2M"};

Schedule schedule(const Study& study, int session = 1, const ObserverId& whose = observer) {
    auto made = make_schedule(study, whose, session);
    EXPECT_TRUE(made.has_value()) << (made ? "" : made.error());
    return made.value_or(Schedule{});
}

std::vector<Trial> trials(const Schedule& schedule, Phase phase) {
    std::vector<Trial> found;
    for (const auto& planned : schedule.trials)
        if (planned.phase == phase)
            found.push_back(planned.trial);
    return found;
}

/// Picture and pair, whichever side they are on.
std::array<std::string, 4> question(const Trial& trial) {
    const auto [low, high] = std::minmax(trial.left.value, trial.right.value);
    return {trial.scene.value, trial.variant.value, low, high};
}

std::vector<std::array<std::string, 4>> questions(const std::vector<Trial>& trials) {
    std::vector<std::array<std::string, 4>> found;
    for (const auto& trial : trials)
        found.push_back(question(trial));
    return found;
}

TEST(Schedule, HasTrainingThenWarmUpsThenMainTrialsNumberedThrough) {
    const auto made = schedule(design(3, 3, 4));
    ASSERT_EQ(made.trials.size(), 4u + 3 + 54);
    for (std::size_t i = 0; i < made.trials.size(); ++i) {
        EXPECT_EQ(made.trials[i].number, static_cast<int>(i) + 1);
        EXPECT_EQ(made.trials[i].phase, i < 4   ? Phase::Training
                                        : i < 7 ? Phase::WarmUp
                                                : Phase::Main);
    }
    EXPECT_EQ(made.scene_rule, "no two neighbours share a scene");
    EXPECT_EQ(made.equal_neighbours, 0);
    EXPECT_EQ(made.generator, "pcg64-xsl-rr");
    EXPECT_EQ(made.order_seed.size(), 32u);
    EXPECT_EQ(made.sides_seed.size(), 32u);
}

TEST(Schedule, AsksEveryPairOfEveryPictureOnce) {
    const auto main = questions(trials(schedule(design(3, 3, 4)), Phase::Main));
    EXPECT_EQ(std::set(main.begin(), main.end()).size(), 54u);
    EXPECT_EQ(main.size(), 54u);
}

// Ten observers, three sessions each: thirty orders, all different, nowhere two neighbours of one
// scene, warm-ups included.
TEST(Schedule, GivesThirtyDifferentOrdersWithoutEqualNeighbours) {
    auto study = design(3, 3, 4);
    std::set<std::vector<std::array<std::string, 4>>> orders;
    for (int person = 0; person < 10; ++person)
        for (int session = 1; session <= 3; ++session) {
            const auto made = schedule(study, session, {"P" + std::to_string(person)});
            orders.insert(questions(trials(made, Phase::Main)));
            for (std::size_t i = 1; i < made.trials.size(); ++i)
                if (made.trials[i - 1].phase != Phase::Training) {
                    EXPECT_NE(made.trials[i].trial.scene, made.trials[i - 1].trial.scene);
                }
        }
    EXPECT_EQ(orders.size(), 30u);
}

void expect_balanced_sides(const std::vector<Trial>& main) {
    std::map<std::pair<std::string, std::string>, int> left_minus_right; // ("", c): overall
    for (const auto& trial : main)
        for (const auto& scene : {std::string(), trial.scene.value}) {
            ++left_minus_right[{scene, trial.left.value}];
            --left_minus_right[{scene, trial.right.value}];
        }
    EXPECT_FALSE(left_minus_right.empty());
    for (const auto& [whose, difference] : left_minus_right)
        EXPECT_LE(std::abs(difference), 1) << whose.first << ' ' << whose.second;
}

TEST(Schedule, PutsEveryConditionOnTheLeftInHalfOfItsTrials) {
    for (const int repetitions : {1, 2, 3})
        for (int session = 1; session <= 3; ++session)
            expect_balanced_sides(
                trials(schedule(design(3, 3, 4, repetitions), session), Phase::Main));
}

TEST(Schedule, OfAnEvenSessionMirrorsTheSidesOfTheOneBefore) {
    auto study = design(3, 3, 4);
    study.plan.sessions = 4;
    for (const int odd : {1, 3}) {
        std::map<std::array<std::string, 4>, ConditionId> left;
        for (const auto& trial : trials(schedule(study, odd), Phase::Main))
            left[question(trial)] = trial.left;
        ASSERT_EQ(left.size(), 54u);
        for (const auto& trial : trials(schedule(study, odd + 1), Phase::Main))
            EXPECT_EQ(left.at(question(trial)), trial.right);
        EXPECT_EQ(schedule(study, odd).sides_seed, schedule(study, odd + 1).sides_seed);
    }
    EXPECT_NE(schedule(study, 1).sides_seed, schedule(study, 3).sides_seed);
}

/// How much more often each question's first condition, by name, was left than right over a panel
/// in which every second observer mirrors the one before.
std::map<std::array<std::string, 4>, int> left_minus_right(const Study& study, int observers) {
    std::map<std::array<std::string, 4>, int> difference;
    for (int person = 0; person < observers; ++person)
        for (int session = 1; session <= study.plan.sessions; ++session) {
            std::optional<ObserverId> partner;
            if (person % 2 == 1)
                partner = ObserverId{"P" + std::to_string(person - 1)};
            const auto made =
                make_schedule(study, {"P" + std::to_string(person)}, session, partner).value();
            for (const auto& trial : trials(made, Phase::Main))
                difference[question(trial)] += trial.left < trial.right ? 1 : -1;
        }
    return difference;
}

TEST(Schedule, OfTwoPartnersAsksEachQuestionAsOftenOneWayRoundAsTheOther) {
    for (const int sessions : {1, 2, 3}) {
        auto study = design(3, 3, 4);
        study.plan.sessions = sessions;
        for (const int observers : {2, 10}) {
            const auto differences = left_minus_right(study, observers);
            EXPECT_EQ(differences.size(), 54u);
            for (const auto& [asked, difference] : differences)
                EXPECT_EQ(difference, 0) << asked[0] << ' ' << asked[2] << ' ' << asked[3];
        }
    }
}

TEST(Schedule, OfAnOddPanelIsBalancedToOne) {
    for (const int sessions : {1, 2, 3}) {
        auto study = design(3, 3, 4);
        study.plan.sessions = sessions;
        const auto differences = left_minus_right(study, 9);
        EXPECT_EQ(differences.size(), 54u);
        for (const auto& [asked, difference] : differences)
            EXPECT_EQ(std::abs(difference), sessions % 2) << asked[0];
    }
}

TEST(Schedule, OfAPartnerKeepsItsOwnOrder) {
    const auto study = design(3, 3, 4);
    const auto alone = schedule(study, 3);
    const auto paired = make_schedule(study, observer, 3, ObserverId{"P9"}).value();
    EXPECT_EQ(paired.order_seed, alone.order_seed);
    EXPECT_EQ(paired.sides_seed, schedule(study, 3, {"P9"}).sides_seed);
    EXPECT_EQ(questions(trials(paired, Phase::Main)), questions(trials(alone, Phase::Main)));
    expect_balanced_sides(trials(paired, Phase::Main));
}

TEST(Schedule, ShowsAQuestionAskedTwiceOnceOnEitherSide) {
    std::map<std::array<std::string, 4>, std::set<std::string>> lefts;
    for (const auto& trial : trials(schedule(design(3, 3, 4, 2)), Phase::Main))
        lefts[question(trial)].insert(trial.left.value);
    EXPECT_EQ(lefts.size(), 54u);
    for (const auto& [asked, left] : lefts)
        EXPECT_EQ(left.size(), 2u);
}

TEST(Schedule, WarmsUpWithMainQuestionsThatDoNotComeNext) {
    auto study = design(3, 3, 4);
    for (int person = 0; person < 100; ++person) {
        const auto made = schedule(study, 1, {"P" + std::to_string(person)});
        const auto warm_ups = questions(trials(made, Phase::WarmUp));
        const auto main = questions(trials(made, Phase::Main));
        ASSERT_EQ(warm_ups.size(), 3u);
        EXPECT_EQ(std::set(warm_ups.begin(), warm_ups.end()).size(), 3u);
        for (const auto& warm_up : warm_ups) {
            EXPECT_EQ(std::count(main.begin(), main.begin() + 3, warm_up), 0);
            EXPECT_EQ(std::count(main.begin(), main.end(), warm_up), 1);
        }
    }
}

TEST(Schedule, PractisesAnEasyAndAHardPairWhereTheStudyNamesThem) {
    auto study = design(3, 3, 4);
    study.plan.easy_pair = {{{"c3"}, {"c0"}}};
    study.plan.hard_pair = {{{"c1"}, {"c2"}}};
    std::set<std::ptrdiff_t> places;
    for (int person = 0; person < 40; ++person) {
        const auto training =
            trials(schedule(study, 1, {"P" + std::to_string(person)}), Phase::Training);
        ASSERT_EQ(training.size(), 4u);
        const auto is_of = [](const char* low, const char* high) {
            return [=](const Trial& trial) {
                return question(trial)[2] == low && question(trial)[3] == high;
            };
        };
        const auto easy = std::ranges::find_if(training, is_of("c0", "c3"));
        EXPECT_NE(easy, training.end());
        EXPECT_TRUE(std::ranges::any_of(training, is_of("c1", "c2")));
        places.insert(easy - training.begin());
    }
    EXPECT_EQ(places.size(), 4u); // 40 draws miss one of four places in 4 of 100,000 panels
    study.plan.training = 1;
    EXPECT_EQ(question(trials(schedule(study), Phase::Training)[0])[3], "c3");
    study.plan.training = 0;
    EXPECT_TRUE(trials(schedule(study), Phase::Training).empty());
}

TEST(Schedule, KeepsTheMainTrialsWhenTrainingAndWarmUpsChange) {
    auto study = design(3, 3, 4);
    const auto before = trials(schedule(study), Phase::Main);
    study.plan.warm_ups = 5;
    study.plan.training = 9;
    const auto after = schedule(study);
    EXPECT_EQ(trials(after, Phase::Main), before);
    EXPECT_EQ(trials(after, Phase::WarmUp).size(), 5u);
    EXPECT_EQ(trials(after, Phase::Training).size(), 9u);
}

TEST(Schedule, ChangesWithTheSeedOfTheStudy) {
    auto study = design(3, 3, 4);
    const auto before = trials(schedule(study), Phase::Main);
    ++study.seed;
    EXPECT_NE(trials(schedule(study), Phase::Main), before);
}

TEST(Schedule, SaysWhatAStudyOfOneSceneGivesUp) {
    const auto made = schedule(design(1, 3, 4));
    EXPECT_EQ(made.equal_neighbours, 17);
    EXPECT_EQ(made.scene_rule, "all 18 main trials show the only scene 's0'");
}

// A single question: whatever is drawn, it comes next, and every session has the one order.
TEST(Schedule, SaysWhatTheSmallestStudyGivesUp) {
    const auto made = schedule(design(1, 0, 2), 2);
    EXPECT_EQ(made.trials.size(), 4u + 3 + 1);
    EXPECT_EQ(made.equal_neighbours, 0);
    EXPECT_EQ(made.scene_rule,
              "no two neighbours share a scene; a warm-up returns among the first 3 main trials, "
              "the study has too few questions to avoid it; the order is that of an earlier "
              "session, the study has too few orders");
}

TEST(Schedule, SaysHowManyQuestionsReturnSoon) {
    EXPECT_THAT(schedule(design(1, 0, 2, 5)).scene_rule,
                testing::HasSubstr("4 questions return within 3 trials"));
}

// Two scenes, two pairs each: 8 orders.  Eight sessions need all of them, so some are drawn again.
TEST(Schedule, DrawsAgainUntilNoSessionSharesAnOrder) {
    auto study = design(2, 2, 2);
    study.plan.sessions = 8;
    std::set<std::vector<std::array<std::string, 4>>> orders;
    for (int session = 1; session <= 8; ++session)
        orders.insert(questions(trials(schedule(study, session), Phase::Main)));
    EXPECT_EQ(orders.size(), 8u);
}

RC_GTEST_PROP(Schedule, KeepsItsRulesInAnyDesign, ()) {
    auto study = design(*rc::gen::inRange(1, 5), *rc::gen::inRange(0, 4), *rc::gen::inRange(2, 6),
                        *rc::gen::inRange(1, 4));
    study.seed = *rc::gen::inRange<std::uint64_t>(0, 1000);
    study.plan.warm_ups = *rc::gen::inRange(0, 7);
    study.plan.training = *rc::gen::inRange(0, 7);
    const auto made = make_schedule(study, observer, *rc::gen::inRange(1, 4)).value();
    const auto main = trials(made, Phase::Main);
    int equal_neighbours = 0;
    for (std::size_t i = 1; i < main.size(); ++i)
        equal_neighbours += main[i].scene == main[i - 1].scene ? 1 : 0;
    RC_ASSERT(equal_neighbours == made.equal_neighbours);
    RC_ASSERT(study.scenes.size() == 1 || equal_neighbours == 0);
    RC_ASSERT(trials(made, Phase::WarmUp).size() == static_cast<std::size_t>(study.plan.warm_ups));
    RC_ASSERT(trials(made, Phase::Training).size() ==
              static_cast<std::size_t>(study.plan.training));
    std::map<std::array<std::string, 4>, int> asked;
    for (const auto& trial : main)
        ++asked[question(trial)];
    for (const auto& [which, times] : asked)
        RC_ASSERT(times == study.plan.repetitions);
}

TEST(Schedule, OfASessionThatIsNotPlannedIsRefused) {
    EXPECT_EQ(make_schedule(design(2, 0, 2), observer, 4).error(),
              "study 'design' has no session 4, expected 1 to 3");
    EXPECT_EQ(make_schedule(design(2, 0, 2), observer, 0).error(),
              "study 'design' has no session 0, expected 1 to 3");
}

TEST(Schedule, OfAStudyWithoutPairsIsRefused) {
    EXPECT_THAT(make_schedule(design(3, 3, 1), observer, 1).error(),
                testing::HasSubstr("asks nothing: 3 scenes, 1 conditions"));
    EXPECT_THAT(make_schedule(design(0, 0, 2), observer, 1).error(),
                testing::HasSubstr("0 scenes"));
}

TEST(Schedule, OfANamelessObserverIsRefused) {
    EXPECT_THAT(make_schedule(design(2, 0, 2), {""}, 1).error(),
                testing::HasSubstr("expected a pseudonym"));
}

} // namespace
