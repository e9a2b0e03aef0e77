// Steps of a sitting by themselves: what comes, what comes again, what is left.
#include "experiment/session/agenda.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace experiment::session;
using protocols::Phase;
using protocols::PlannedTrial;
using testing::ElementsAre;

PlannedTrial trial(int number, const std::string& scene, Phase phase = Phase::Main) {
    return {number, phase, {.scene = {scene}, .variant = {}, .left = {"x"}, .right = {"y"}}};
}

// The numbers of the trials from the current step on, which is left at the end.
std::vector<int> numbers_of(Agenda agenda) {
    std::vector<int> numbers;
    for (;; agenda.next()) {
        if (const auto* planned = std::get_if<PlannedTrial>(&agenda.current()))
            numbers.push_back(planned->number);
        if (agenda.is_last())
            return numbers;
    }
}

Agenda main_trials(const std::vector<std::string>& scenes) {
    Agenda agenda;
    int number = 0;
    for (const auto& scene : scenes)
        agenda.add(trial(++number, scene));
    agenda.add(FinishStep{});
    return agenda;
}

TEST(Agenda, PutsAPostponedTrialBetweenOtherScenes) {
    auto free = main_trials({"a", "b", "c", "d"});
    free.postpone_trial();
    EXPECT_THAT(numbers_of(free), ElementsAre(2, 1, 3, 4)); // behind the next one at least
    auto crowded = main_trials({"a", "b", "a", "c", "d"});
    crowded.postpone_trial();
    EXPECT_THAT(numbers_of(crowded), ElementsAre(2, 3, 4, 1, 5));
    auto without_place = main_trials({"a", "a", "a"});
    without_place.postpone_trial();
    EXPECT_THAT(numbers_of(without_place), ElementsAre(2, 3, 1));
    auto last = main_trials({"a"});
    last.postpone_trial();
    EXPECT_THAT(numbers_of(last), ElementsAre(1));
}

TEST(Agenda, PutsAWarmUpBeforeTheMainTrials) {
    Agenda agenda;
    agenda.add(trial(1, "a", Phase::WarmUp));
    agenda.add(trial(2, "a", Phase::WarmUp));
    agenda.add(trial(3, "b"));
    agenda.postpone_trial();
    EXPECT_THAT(numbers_of(agenda), ElementsAre(2, 1, 3));
}

TEST(Agenda, RepeatsATrainingThatLiesBehind) {
    Agenda agenda;
    agenda.add(PageStep{"instructions", {}, {}});
    agenda.add_training({trial(1, "a", Phase::Training), trial(2, "b", Phase::Training)});
    agenda.add(PageStep{"questions", {}, {}});
    EXPECT_TRUE(agenda.has_training());
    EXPECT_FALSE(agenda.repeat_training());
    for (int step = 0; step < 3; ++step)
        agenda.next();
    EXPECT_TRUE(agenda.repeat_training());
    EXPECT_EQ(agenda.trial().number, 1);
    Agenda without;
    without.add_training({});
    EXPECT_FALSE(without.has_training());
}

TEST(Agenda, KnowsWhatIsLeft) {
    Agenda agenda;
    agenda.add(trial(1, "a", Phase::WarmUp));
    agenda.add(AdaptationStep{});
    agenda.add(trial(2, "b"));
    agenda.add(trial(3, "c"));
    EXPECT_EQ(agenda.remaining().main, 2);
    EXPECT_EQ(agenda.remaining().others, 1);
    EXPECT_EQ(agenda.upcoming(true)->number, 1);
    EXPECT_EQ(agenda.upcoming(false)->number, 2);
    for (int step = 0; step < 3; ++step)
        agenda.next();
    EXPECT_EQ(agenda.remaining().main, 1);
    EXPECT_EQ(agenda.remaining().others, 0);
    EXPECT_EQ(agenda.upcoming(false), nullptr);
    EXPECT_TRUE(agenda.is_last());
}

} // namespace
