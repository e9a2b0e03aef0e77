#include "analysis/consistency/triads.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/numerics/golden_json.h"

#include <cmath>
#include <map>
#include <sstream>

namespace {

using namespace analysis::consistency;
using analysis::VoteMatrix;
using protocols::Choice;

TEST(CircularTriads, OfEveryGoldenRoundAgree) {
    std::map<std::string, std::string> expected;
    std::istringstream stream(golden_text("experiment/consistency_rounds.csv"));
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        std::istringstream fields(line);
        std::string observer, session, model, light, triads;
        for (auto* field : {&observer, &session, &model, &light, &triads})
            std::getline(fields, *field, ',');
        expected[observer + session + model + light] = triads;
    }
    ASSERT_EQ(expected.size(), 270u);
    for (const auto& round : analysis::count_votes(golden_votes(), {true, true, {true, true}}))
        EXPECT_EQ(std::to_string(circular_triads(round.matrix).value()),
                  expected.at(round.observer + round.session + round.scene[0] + round.scene[1]));
}

VoteMatrix tournament(const nlohmann::json& rows) {
    VoteMatrix matrix(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        for (std::size_t j = i + 1; j < rows.size(); ++j)
            matrix.add(i, j, rows[i][j] == 1 ? Choice::Left : Choice::Right);
    return matrix;
}

TEST(CircularTriads, OfSevenEqualsReachTheMaximum) {
    const auto golden =
        golden::read_json("hard_cases.json")["paired_comparison"]["zeta_k7_all_scores_equal"];
    EXPECT_EQ(circular_triads(tournament(golden["matrix"])), 14);
    EXPECT_EQ(most_triads(7), 14);
    EXPECT_EQ(expected_triads(7), 8.75);
    EXPECT_EQ(zeta(14, 7), 0);
}

TEST(CircularTriads, ATieBreaksTheCycle) {
    VoteMatrix round(3);
    round.add(0, 1, Choice::Left);
    round.add(1, 2, Choice::Left);
    auto tied = round;
    round.add(0, 2, Choice::Right);
    tied.add(0, 2, Choice::Tie);
    EXPECT_EQ(circular_triads(round), 1);
    EXPECT_EQ(circular_triads(tied), 0);
}

TEST(CircularTriads, NeedACompleteRoundAndThreeConditions) {
    EXPECT_EQ(circular_triads(VoteMatrix(3)), std::nullopt);
    EXPECT_TRUE(std::isnan(zeta(0, 2)));
}

} // namespace
