#include "protocols/practice.h"
#include "tests/protocols/designs.h"

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>

namespace {

using namespace protocols;

Rng rng(std::uint64_t number) {
    Seed seed{};
    for (auto byte = seed.rbegin(); number != 0; ++byte, number >>= 8)
        *byte = static_cast<std::uint8_t>(number & 0xff);
    return Rng(seed);
}

/// As many questions of each scene as the counts say; what they compare does not matter here.
std::vector<Question> questions_of(const std::vector<int>& counts) {
    std::vector<Question> questions;
    for (std::size_t scene = 0; scene < counts.size(); ++scene)
        for (int i = 0; i < counts[scene]; ++i)
            questions.push_back({static_cast<int>(scene), i, 0, 1});
    return questions;
}

std::vector<std::size_t> everything(const std::vector<Question>& questions) {
    std::vector<std::size_t> all(questions.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

int equal_neighbours(const std::vector<Question>& questions,
                     const std::vector<std::size_t>& drawn,
                     std::optional<int> next_scene) {
    int equal = !drawn.empty() && questions[drawn.back()].scene == next_scene ? 1 : 0;
    for (std::size_t i = 1; i < drawn.size(); ++i)
        equal += questions[drawn[i]].scene == questions[drawn[i - 1]].scene ? 1 : 0;
    return equal;
}

/// By trying them all: whether some sequence of scenes keeps the rule.
bool can_keep_the_rule(std::vector<int> left, int length, std::optional<int> barred) {
    if (length == 0)
        return true;
    for (std::size_t scene = 0; scene < left.size(); ++scene)
        if (left[scene] > 0 && static_cast<int>(scene) != barred) {
            --left[scene];
            if (can_keep_the_rule(left, length - 1, static_cast<int>(scene)))
                return true;
            ++left[scene];
        }
    return false;
}

RC_GTEST_PROP(Practice, KeepsScenesApartWheneverThatCanBe, (std::uint64_t seed)) {
    const auto counts = *rc::gen::container<std::vector<int>>(3, rc::gen::inRange(0, 5));
    const auto questions = questions_of(counts);
    const int count = *rc::gen::inRange(0, static_cast<int>(questions.size()) + 1);
    std::optional<int> next_scene;
    if (const int scene = *rc::gen::inRange(-1, 3); scene >= 0)
        next_scene = scene;
    auto stream = rng(seed);
    const auto drawn = draw_practice(questions, everything(questions), count, next_scene, stream);
    RC_ASSERT(static_cast<int>(drawn.size()) == count);
    RC_ASSERT(std::set(drawn.begin(), drawn.end()).size() == drawn.size());
    if (can_keep_the_rule(counts, count, next_scene))
        RC_ASSERT(equal_neighbours(questions, drawn, next_scene) == 0);
}

TEST(Practice, PutsWhatIsWantedWhereItIsWanted) {
    const auto questions = questions_of({4, 4, 4});
    const Wanted wanted{{1, [](const Question& question) { return question.variant == 2; }},
                        {3, [](const Question& question) { return question.variant == 3; }}};
    auto stream = rng(1);
    for (int i = 0; i < 50; ++i) {
        const auto drawn = draw_practice(questions, everything(questions), 4, {}, stream, wanted);
        EXPECT_EQ(questions[drawn[1]].variant, 2);
        EXPECT_EQ(questions[drawn[3]].variant, 3);
        EXPECT_EQ(equal_neighbours(questions, drawn, {}), 0);
    }
}

TEST(Practice, DrawsFromItsPoolOnly) {
    const auto questions = questions_of({4, 4});
    const std::vector<std::size_t> pool{1, 2, 6};
    auto stream = rng(1);
    for (int i = 0; i < 50; ++i)
        for (const auto drawn : draw_practice(questions, pool, 3, {}, stream))
            EXPECT_THAT(pool, testing::Contains(drawn));
}

TEST(Practice, ReachesEveryQuestionOfItsPool) {
    const auto questions = questions_of({3, 3, 3});
    std::set<std::size_t> seen;
    auto stream = rng(2);
    for (int i = 0; i < 200; ++i)
        for (const auto drawn : draw_practice(questions, everything(questions), 3, 0, stream))
            seen.insert(drawn);
    EXPECT_EQ(seen.size(), questions.size());
}

TEST(Practice, RepeatsQuestionsOnlyWhenThePoolIsTooSmall) {
    const auto questions = questions_of({1, 1});
    auto stream = rng(3);
    const auto drawn = draw_practice(questions, everything(questions), 5, {}, stream);
    EXPECT_EQ(drawn.size(), 5u);
    EXPECT_EQ(equal_neighbours(questions, drawn, {}), 0);
}

TEST(Practice, OfNoneNeedsNoPool) {
    auto stream = rng(4);
    EXPECT_TRUE(draw_practice({}, {}, 0, {}, stream).empty());
}

} // namespace
