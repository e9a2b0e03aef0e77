#include "experiment/store/words.h"

namespace {

using namespace experiment::store;
using protocols::Choice;
using protocols::Phase;

TEST(Words, ComeBackAsTheEnumeratorsTheyWere) {
    for (const auto phase : {Phase::Training, Phase::WarmUp, Phase::Main})
        EXPECT_EQ(phase_of(word_of(phase)), phase);
    for (const auto choice : {Choice::Left, Choice::Right, Choice::Tie})
        EXPECT_EQ(choice_of(word_of(choice)), choice);
}

TEST(Words, SayLeftForLeft) {
    EXPECT_EQ(word_of(Choice::Left), "left");
    EXPECT_EQ(word_of(Choice::Right), "right");
}

TEST(Words, ThatNobodySpellsSoMeanNothing) {
    EXPECT_EQ(phase_of("Main"), std::nullopt);
    EXPECT_EQ(choice_of(""), std::nullopt);
}

} // namespace
