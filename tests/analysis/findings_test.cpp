#include "analysis/findings.h"
#include "analysis/findings_json.h"
#include "analysis/findings_text.h"
#include "tests/analysis/golden.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <sstream>

namespace {

using namespace analysis;
using testing::HasSubstr;

VoteTable small_study(int observers, std::size_t conditions) {
    const std::vector<std::string> names{"A", "B", "C", "D"};
    std::vector<VoteRow> rows;
    for (int o = 0; o < observers; ++o)
        for (const auto* scene : {"x", "y"})
            for (std::size_t i = 0; i < conditions; ++i)
                for (std::size_t j = i + 1; j < conditions; ++j)
                    rows.push_back({"O" + std::to_string(o),
                                    "1",
                                    1,
                                    {scene},
                                    names[i],
                                    names[j],
                                    (static_cast<std::size_t>(o) + i + j) % 3 == 0
                                        ? protocols::Choice::Right
                                        : protocols::Choice::Left,
                                    -1});
    return vote_table({"scene"}, rows).value();
}

TEST(Findings, OneWayFIsTOverTMinusOneTimesWithinF) {
    for (const auto& table : {golden_votes(), small_study(5, 3), small_study(7, 4)}) {
        const auto findings = analyze(table);
        const auto t = static_cast<double>(table.conditions.size());
        EXPECT_NEAR(findings.one_way_observers->anova.test.f,
                    t / (t - 1) * findings.method_effect()->test.f,
                    1e-14 * findings.one_way_observers->anova.test.f);
    }
}

TEST(Findings, EffectsWithoutTheMethodAreIpsative) {
    const auto findings = analyze(golden_votes());
    int ipsative = 0;
    for (const auto& named : findings.within)
        for (const auto& effect : named.analysis.effects)
            if (effect.name.find("method") == std::string::npos) {
                ++ipsative;
                EXPECT_EQ(effect.effect.ss, 0);
                EXPECT_EQ(effect.test.outcome, anova::Outcome::Ipsative);
                EXPECT_EQ(effect.test.reason, "not estimable: scores are ipsative");
            }
    EXPECT_EQ(ipsative, 1 + 7);
}

// Equal as documents; a failure should not print them whole.
bool same(const Findings& a, const Findings& b) {
    return findings_json(a) == findings_json(b);
}

TEST(Findings, MirroringEveryTrialChangesOnlyTheSideTerm) {
    auto mirrored = golden_votes();
    std::swap(mirrored.left, mirrored.right);
    for (auto& choice : mirrored.chosen)
        choice =
            choice == protocols::Choice::Left ? protocols::Choice::Right : protocols::Choice::Left;
    const auto before = analyze(golden_votes());
    auto after = analyze(mirrored);
    EXPECT_EQ(before.consistency.side.left, 849);
    EXPECT_EQ(after.consistency.side.left, 1620 - 849);
    EXPECT_EQ(after.consistency.side.p, before.consistency.side.p);
    EXPECT_NEAR(after.scales.side.fit.side->value, -before.scales.side.fit.side->value, 1e-12);
    after.consistency.side = before.consistency.side;
    after.scales.side = before.scales.side;
    after.scales.first_chosen = before.scales.first_chosen;
    after.scales.second_chosen = before.scales.second_chosen;
    ASSERT_EQ(after.screening.size(), before.screening.size());
    for (std::size_t o = 0; o < after.screening.size(); ++o) {
        EXPECT_EQ(after.screening[o].left, before.screening[o].answers - before.screening[o].left);
        EXPECT_EQ(after.screening[o].side_z, -before.screening[o].side_z);
        after.screening[o].left = before.screening[o].left;
        after.screening[o].side_z = before.screening[o].side_z;
    }
    EXPECT_TRUE(same(after, before));
}

TEST(Findings, RelabellingChangesNothingButLabels) {
    auto table = golden_votes();
    const std::vector<std::string> order{"PRT", "Green", "SHSS", "Patro"};
    const auto before = analyze(table);
    const auto after = analyze(with_condition_order(table, order).value());
    EXPECT_DOUBLE_EQ(before.method_effect()->test.f, after.method_effect()->test.f);
    EXPECT_NEAR(before.method_effect()->sphericity.greenhouse_geisser,
                after.method_effect()->sphericity.greenhouse_geisser, 1e-14);
    ASSERT_EQ(before.ranking.size(), after.ranking.size());
    for (std::size_t i = 0; i < before.ranking.size(); ++i) {
        EXPECT_EQ(before.design.conditions[before.ranking[i].condition],
                  after.design.conditions[after.ranking[i].condition]);
        EXPECT_EQ(before.ranking[i].letters, after.ranking[i].letters);
        EXPECT_EQ(before.ranking[i].votes, after.ranking[i].votes);
        const auto one = before.ranking[i].condition, other = after.ranking[i].condition;
        EXPECT_NEAR(before.scales.jod.theta[one], after.scales.jod.theta[other], 1e-13);
        EXPECT_NEAR(before.scales.bradley_terry.theta[one], after.scales.bradley_terry.theta[other],
                    1e-13);
        // The same observers are drawn: intervals agree to what refits leave.
        EXPECT_NEAR(before.scales.odds->bca[one].lower, after.scales.odds->bca[other].lower, 1e-9);
    }
    EXPECT_NEAR(before.scales.parts[0].heterogeneity.chi_squared,
                after.scales.parts[0].heterogeneity.chi_squared, 1e-9);
    EXPECT_NEAR(before.scales.side.fit.side->value, after.scales.side.fit.side->value, 1e-12);
}

TEST(Findings, TheOrderOfRowsDoesNotMatter) {
    const auto table = golden_votes();
    auto reversed = table;
    std::reverse(reversed.observer.begin(), reversed.observer.end());
    std::reverse(reversed.session.begin(), reversed.session.end());
    for (auto& column : reversed.factor)
        std::reverse(column.begin(), column.end());
    std::reverse(reversed.left.begin(), reversed.left.end());
    std::reverse(reversed.right.begin(), reversed.right.end());
    std::reverse(reversed.chosen.begin(), reversed.chosen.end());
    std::reverse(reversed.trial.begin(), reversed.trial.end());
    std::reverse(reversed.response_ms.begin(), reversed.response_ms.end());
    EXPECT_TRUE(same(analyze(reversed), analyze(table)));
}

TEST(Findings, LeaveOutAnObserverWithHolesAndSaySo) {
    auto table = small_study(6, 4);
    table.observer.pop_back();
    table.session.pop_back();
    table.factor[0].pop_back();
    table.left.pop_back();
    table.right.pop_back();
    table.chosen.pop_back();
    table.trial.pop_back();
    table.response_ms.pop_back();
    const auto findings = analyze(table);
    EXPECT_FALSE(findings.design.complete);
    EXPECT_EQ(findings.design.missing, 1);
    EXPECT_THAT(findings.design.incomplete_observers, testing::ElementsAre("O5"));
    EXPECT_EQ(findings.within[0].analysis.observers, 5u);
    EXPECT_THAT(findings_text(findings), HasSubstr("Left out of the analyses of variance, because "
                                                   "they did not answer everything: O5."));
}

TEST(Findings, SayWhyThereIsNoAnalysisOfVariance) {
    const auto findings = analyze(small_study(1, 3));
    EXPECT_EQ(findings.method_effect(), nullptr);
    EXPECT_EQ(findings.why_no_anova, "fewer than two observers compared every pair equally often");
    EXPECT_EQ(findings.scores.size(), 3u); // what can be said is said
    const auto json = nlohmann::json::parse(findings_json(findings));
    EXPECT_EQ(json["anova"]["reason"], findings.why_no_anova);
    EXPECT_TRUE(json["ranking"][0]["lower"].is_null());
    EXPECT_THAT(findings_text(findings), HasSubstr("No analysis of variance"));
}

TEST(Findings, TwoConditionsAreEnough) {
    const auto findings = analyze(small_study(4, 2));
    ASSERT_NE(findings.method_effect(), nullptr);
    EXPECT_EQ(findings.within_tukey.pairs.size(), 1u);
    EXPECT_NEAR(findings.within_tukey.pairs[0].p, findings.method_effect()->test.p, 1e-12);
}

TEST(Findings, SimulatedVotesAreNamedEverywhere) {
    auto table = small_study(4, 3);
    table.simulated = true;
    const auto findings = analyze(table);
    EXPECT_THAT(findings_text(findings), testing::StartsWith("SIMULATED: "));
    EXPECT_THAT(findings_json(findings), HasSubstr("\"simulated\": true"));
    EXPECT_THAT(findings_text(findings), HasSubstr("These votes are simulated"));
}

TEST(Findings, TextSaysTheGoldenStory) {
    const auto text = findings_text(analyze(golden_votes()));
    EXPECT_THAT(text,
                HasSubstr("1620 votes of 10 observers in 3 sessions: 9 scenes, 4 conditions"));
    EXPECT_THAT(text, HasSubstr("59.3422"));
    EXPECT_THAT(text, HasSubstr("5.19e-12"));
    EXPECT_THAT(text, HasSubstr("not estimable: scores are ipsative"));
    EXPECT_EQ(text.find("nan"), std::string::npos);
}

// One vote a row: winner over loser, by an observer, on alternating sides.
VoteTable votes_of(const std::vector<std::array<std::string, 3>>& rows) {
    std::vector<VoteRow> votes;
    for (const auto& [observer, winner, loser] : rows) {
        const bool left = votes.size() % 2 == 0;
        votes.push_back({observer,
                         std::to_string(votes.size()),
                         1,
                         {"s"},
                         left ? winner : loser,
                         left ? loser : winner,
                         left ? protocols::Choice::Left : protocols::Choice::Right,
                         -1});
    }
    return vote_table({"scene"}, votes).value();
}

TEST(Findings, AWinnerWhoNeverLosesIsNamedAndPenalised) {
    const auto findings = analyze(votes_of({{"O1", "A", "B"},
                                            {"O1", "A", "C"},
                                            {"O1", "B", "C"},
                                            {"O2", "A", "B"},
                                            {"O2", "C", "B"},
                                            {"O2", "A", "C"}}));
    EXPECT_EQ(findings.scales.bradley_terry.estimate, scaling::Estimate::Firth);
    const auto text = findings_text(findings);
    EXPECT_THAT(text, HasSubstr("no condition of a later group was ever chosen over one of an "
                                "earlier group in {A} above {B, C}"));
    EXPECT_THAT(text, HasSubstr("Firth's penalised estimates"));
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST(Findings, ConditionsNeverComparedAreNamed) {
    const auto findings = analyze(votes_of({{"O1", "A", "B"},
                                            {"O1", "B", "A"},
                                            {"O1", "C", "D"},
                                            {"O2", "D", "C"},
                                            {"O2", "A", "B"}}));
    EXPECT_EQ(findings.scales.bradley_terry.estimate, scaling::Estimate::None);
    const auto text = findings_text(findings);
    EXPECT_THAT(text, HasSubstr("no vote decides between these groups, neither directly nor "
                                "through others: {A, B}, {C, D}"));
    const auto json = nlohmann::json::parse(findings_json(findings));
    EXPECT_TRUE(json["choice_models"]["bradley_terry"]["theta_centered"][0].is_null());
    EXPECT_EQ(json["choice_models"]["bradley_terry"]["estimate"], "none");
}

TEST(Findings, OfNothingButTiesHaveNoScaleAndSaySo) {
    std::vector<VoteRow> votes;
    for (const auto* observer : {"O1", "O2", "O3"})
        for (const auto& [left, right] : {std::pair{"A", "B"}, {"A", "C"}, {"B", "C"}})
            votes.push_back({observer, "1", 1, {"s"}, left, right, protocols::Choice::Tie, -1});
    const auto findings = analyze(vote_table({"scene"}, votes).value());
    EXPECT_EQ(findings.method_effect()->test.outcome, anova::Outcome::Undefined);
    EXPECT_EQ(findings.ranking[0].share, 0.5);
    EXPECT_EQ(findings.scales.davidson->estimate, scaling::Estimate::None);
    const auto text = findings_text(findings);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
    EXPECT_TRUE(nlohmann::json::accept(findings_json(findings)));
}

TEST(Findings, UnanimousObserversMakeFInfinite) {
    std::vector<VoteRow> votes;
    for (const auto* observer : {"O1", "O2", "O3"})
        for (const auto& [left, right] : {std::pair{"A", "B"}, {"A", "C"}, {"B", "C"}})
            votes.push_back({observer, "1", 1, {"s"}, left, right, protocols::Choice::Left, -1});
    const auto findings = analyze(vote_table({"scene"}, votes).value());
    EXPECT_EQ(findings.method_effect()->test.outcome, anova::Outcome::Infinite);
    EXPECT_EQ(findings.scales.bradley_terry.estimate, scaling::Estimate::Firth);
    EXPECT_EQ(findings.consistency.triads.mean_zeta, 1);
    const auto text = findings_text(findings);
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST(Findings, AMissingSittingLeavesThatObserverOutOfTheTestsOnly) {
    auto rows = golden_text("experiment/votes.csv");
    std::string kept, line;
    std::istringstream lines(rows);
    while (std::getline(lines, line))
        if (!line.starts_with("O03,2,"))
            kept += line + "\n";
    const auto findings = analyze(read_votes_csv(kept, "votes.csv").value());
    EXPECT_EQ(findings.design.votes, 1620 - 54);
    EXPECT_EQ(findings.within[0].analysis.observers, 9u);
    EXPECT_THAT(findings.design.incomplete_observers, testing::ElementsAre("O03"));
    EXPECT_EQ(findings.scales.left_out.size(), 10u); // the scales use every vote
    EXPECT_EQ(findings.scales.observers[2], "O03");
}

TEST(Findings, SmallPAreToldByTheirLogarithm) {
    EXPECT_EQ(p_text(0.0120556), "0.0121");
    EXPECT_EQ(p_text(0, -366.98), "< 1e-300 (log10 p = -367.0)");
    EXPECT_EQ(p_text(std::nan("")), "n/e");
}

} // namespace
