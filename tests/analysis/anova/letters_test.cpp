#include "analysis/anova/letters.h"
#include "tests/analysis/golden.h"

#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include <numeric>
#include <set>

namespace {

using analysis::anova::compact_letters;
using nlohmann::json;
using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

std::vector<std::size_t> in_order(std::size_t items) {
    std::vector<std::size_t> ranked(items);
    std::iota(ranked.begin(), ranked.end(), std::size_t{0});
    return ranked;
}

TEST(Letters, AgreeWithTheGoldenSets) {
    const auto sets = json::parse(golden_text("sets/anova_sets.json"))["compact_letters"];
    ASSERT_GE(sets.size(), 8u);
    for (const auto& set : sets) {
        const auto letters =
            compact_letters(in_order(set["k"]), set["significant"].get<Pairs>()).value();
        for (std::size_t i = 0; i < letters.size(); ++i)
            EXPECT_EQ(letters[i], set["letters"]["T" + std::to_string(i + 1)]) << set.dump();
    }
}

bool share(const std::string& a, const std::string& b) {
    return a.find_first_of(b) != std::string::npos;
}

// Up to 6 items need at most 9 columns (maximal cliques on 6 vertices), so letters are single.
RC_GTEST_PROP(Letters, AreSharedExactlyWhenNotSignificant, ()) {
    const auto items = *rc::gen::inRange<std::size_t>(2, 7);
    Pairs significant;
    for (std::size_t i = 0; i < items; ++i)
        for (std::size_t j = i + 1; j < items; ++j)
            if (*rc::gen::arbitrary<bool>())
                significant.emplace_back(j, i);
    auto ranked = in_order(items);
    std::rotate(ranked.begin(), ranked.begin() + 1, ranked.end());
    const auto letters = compact_letters(ranked, significant).value();
    for (std::size_t i = 0; i < items; ++i)
        for (std::size_t j = i + 1; j < items; ++j) {
            const bool differs = std::find(significant.begin(), significant.end(),
                                           std::pair{j, i}) != significant.end();
            RC_ASSERT(share(letters[i], letters[j]) == !differs);
        }
    RC_ASSERT(letters[ranked[0]].front() == 'a'); // the best item has the first letter
}

TEST(Letters, GiveUpBeforeTheyFillTheMemory) {
    Pairs disjoint; // 2^n columns for n disjoint pairs
    for (std::size_t i = 0; i < 28; i += 2)
        disjoint.emplace_back(i, i + 1);
    EXPECT_FALSE(compact_letters(in_order(28), disjoint).has_value());
}

TEST(Letters, GoOnAfterZ) {
    EXPECT_EQ(analysis::anova::letter(0), "a");
    EXPECT_EQ(analysis::anova::letter(25), "z");
    EXPECT_EQ(analysis::anova::letter(26), "aa");
    EXPECT_EQ(analysis::anova::letter(27), "ab");
    EXPECT_EQ(analysis::anova::letter(26 * 27), "aaa");
}

} // namespace
