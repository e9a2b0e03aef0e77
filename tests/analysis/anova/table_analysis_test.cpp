#include "analysis/anova/table_analysis.h"
#include "analysis/anova/table_json.h"
#include "analysis/anova/table_text.h"
#include "analysis/findings.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/numerics/golden_json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>

namespace {

using nlohmann::json;
using namespace analysis::anova;
using testing::HasSubstr;

Measurements table_of(const std::string& text, const MeasurementColumns& columns) {
    return read_measurements(text, "t.csv", columns).value();
}

TableAnalysis analysis_of(const std::string& text,
                          const MeasurementColumns& columns,
                          SumsOfSquares type = SumsOfSquares::Hierarchical) {
    return analyze_table(table_of(text, columns), {.type = type}).value();
}

void expect_near(const json& expected, double found, double tolerance, const std::string& what) {
    const auto value = expected.get<double>();
    EXPECT_LE(std::abs(found - value), tolerance * std::abs(value))
        << what << ": expected " << value << ", found " << found;
}

const TableTerm& term(const TableAnalysis& analysis, const std::string& name) {
    for (const auto& term : analysis.terms)
        if (term.name == name)
            return term;
    throw std::out_of_range(name);
}

// Sums of squares are formed of exact residues in 64-bit mantissas: twelve digits leave room.
void expect_terms(const json& expected, const TableAnalysis& found) {
    ASSERT_EQ(expected.size(), found.terms.size());
    for (const auto& [name, row] : expected.items()) {
        const auto& own = term(found, name);
        expect_near(row["SS"], own.effect.ss, 1e-14, name + " SS");
        EXPECT_EQ(row["df"].get<double>(), own.effect.df) << name;
        expect_near(row["F"], own.test.f, 1e-14, name + " F");
        expect_near(row["p"], own.test.p, 1e-12, name + " p");
    }
}

TEST(TableAnalysis, AllTypesOfUnbalancedSetsAgreeWithTheGoldenOnes) {
    const auto golden = golden::read_json("sets/anova_sets.json");
    const std::pair<const char*, std::vector<std::string>> sets[] = {
        {"unbalanced_2way", {"method", "model"}},
        {"unbalanced_2way_empty_cell", {"method", "model"}},
        {"unbalanced_3way", {"A", "B", "C"}}};
    int compared = 0;
    for (const auto& [name, factors] : sets) {
        const auto& expected = golden.at(name);
        const auto text = golden_text(fmt::format("sets/{}.csv", name));
        auto swapped = factors;
        std::swap(swapped[0], swapped[1]);
        const std::tuple<const char*, std::vector<std::string>, SumsOfSquares> types[] = {
            {"type1", factors, SumsOfSquares::Sequential},
            {"type2", factors, SumsOfSquares::Hierarchical},
            {"type3", factors, SumsOfSquares::Partial},
            {"type1_first_two_factors_swapped", swapped, SumsOfSquares::Sequential}};
        for (const auto& [key, order, type] : types) {
            if (!expected.contains(key))
                continue;
            SCOPED_TRACE(fmt::format("{} {}", name, key));
            auto found = analysis_of(text, {"y", order, ""}, type);
            expect_near(expected["residual"]["SS"], found.residual.ss, 1e-14, "residual");
            EXPECT_EQ(expected["residual"]["df"].get<double>(), found.residual.df);
            auto rows = expected[key];
            if (order == swapped) { // the golden interactions keep their places, ours follow
                for (auto& own : found.terms)
                    if (own.name == swapped[0] + ":" + swapped[1])
                        own.name = factors[0] + ":" + factors[1];
                if (factors.size() > 2) {
                    std::erase_if(found.terms,
                                  [](const TableTerm& own) { return own.name.size() > 1; });
                    for (const auto* interaction : {"A:B", "A:C", "B:C", "A:B:C"})
                        rows.erase(interaction);
                }
            }
            expect_terms(rows, found);
            ++compared;
        }
    }
    EXPECT_GE(compared, 11);
}

TEST(TableAnalysis, TypeThreeWithAnEmptyCellIsRefusedByName) {
    const auto table = table_of(golden_text("sets/unbalanced_2way_empty_cell.csv"),
                                {"y", {"method", "model"}, ""});
    const auto refused = analyze_table(table, {.type = SumsOfSquares::Partial});
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error(), HasSubstr("no values for "));
    EXPECT_THAT(refused.error(), HasSubstr("type III sums of squares depend on the coding there"));
}

TEST(TableAnalysis, OneWayHasChecksAndComparisonsOfUnequalGroups) {
    const auto golden = golden::read_json("sets/anova_sets.json")["unequal_1way"];
    std::string header;
    std::istringstream lines(golden_text("sets/unequal_1way.csv"));
    std::getline(lines, header);
    const auto comma = header.find(',');
    const auto found = analysis_of(golden_text("sets/unequal_1way.csv"),
                                   {header.substr(comma + 1), {header.substr(0, comma)}, ""});
    const auto& levels = *found.levels;
    const auto& anova = golden["anova"];
    expect_near(anova["SS_between"], found.terms[0].effect.ss, 1e-15, "SS");
    expect_near(anova["F"], found.terms[0].test.f, 1e-15, "F");
    expect_near(anova["eta2"], found.terms[0].eta_squared, 1e-14, "eta2");
    expect_near(anova["epsilon2"], found.terms[0].epsilon_squared, 1e-13, "epsilon2");
    expect_near(anova["residual_sd"], found.residual_sd, 1e-15, "sd");
    expect_near(anova["grand_mean"], found.grand_mean, 1e-15, "grand mean");
    const std::pair<const char*, const FTest*> checks[] = {
        {"welch", &*levels.welch},
        {"levene_mean", &*levels.levene},
        {"brown_forsythe", &*levels.brown_forsythe}};
    for (const auto& [key, test] : checks) {
        expect_near(golden[key]["F"], test->f, 1e-12, key);
        expect_near(golden[key]["df2"], test->df2, 1e-12, key);
        expect_near(golden[key]["p"], test->p, 1e-11, key);
    }
    ASSERT_EQ(golden["tukey_kramer"]["pairs"].size(), levels.tukey.pairs.size());
    for (std::size_t i = 0; i < levels.tukey.pairs.size(); ++i) {
        const auto& pair = golden["tukey_kramer"]["pairs"][i];
        expect_near(pair["diff"], levels.tukey.pairs[i].difference, 1e-13, "diff");
        expect_near(pair["upper"], levels.tukey.pairs[i].upper, 1e-12, "upper");
        expect_near(pair["p"], levels.tukey.pairs[i].p, 1e-12, "p");
        expect_near(golden["games_howell"][i]["p"], levels.games_howell[i].p, 1e-12, "GH");
    }
}

TEST(TableAnalysis, HardOneWayCasesAreRightOrUndefined) {
    const auto cases = golden::read_json("hard_cases.json").at("oneway");
    int computed = 0;
    for (const auto& [name, hard] : cases.items()) {
        std::string text = "g,y\n";
        for (std::size_t g = 0; g < hard["groups"].size(); ++g)
            for (const auto& value : hard["groups"][g])
                text += fmt::format("g{},{}\n", g, value.get<std::string>());
        const auto found = analysis_of(text, {"y", {"g"}, ""});
        if (hard["F"].is_number()) {
            ++computed;
            expect_near(hard["F"], found.terms[0].test.f, 1e-15, name);
            expect_near(hard["p"], found.terms[0].test.p, 1e-13, name);
            EXPECT_GT(found.terms[0].eta_squared, 0) << name;
            EXPECT_LT(found.terms[0].eta_squared, 1) << name;
            EXPECT_GT(found.levels->tukey.pairs[0].p, 0) << name; // also where squares underflow
        } else if (hard["F"].is_null()) {
            EXPECT_TRUE(std::isnan(found.terms[0].test.f)) << name;
            EXPECT_THAT(table_json(found, ""), HasSubstr("\"F\": null")) << name;
        } else {
            EXPECT_TRUE(std::isinf(found.terms[0].test.f)) << name;
            EXPECT_EQ(found.terms[0].test.p, 0) << name;
        }
    }
    EXPECT_GE(computed, 6);
}

// Each observer's mean votes for each method, with his group, as a table.
std::string observer_means(int sessions_apart = 0) {
    const auto table = golden_votes();
    std::string text =
        sessions_apart != 0 ? "observer,sex,session,method,votes\n" : "observer,sex,method,votes\n";
    for (const auto& scoped : analysis::count_votes(table, {true, sessions_apart != 0, {}}))
        for (std::size_t a = 0; a < 4; ++a) {
            // half votes of 9 scenes (x 3 sessions): twice the total, to be divided by the rounds
            const auto sex = scoped.observer <= "O04" ? "M" : "F";
            const auto votes = scoped.matrix.half_votes(a) / 2;
            text += sessions_apart != 0
                        ? fmt::format("{},{},{},{},{}\n", scoped.observer, sex, scoped.session,
                                      table.conditions.name(a), votes)
                        : fmt::format("{},{},{},{}\n", scoped.observer, sex,
                                      table.conditions.name(a), votes);
        }
    return text;
}

TEST(TableAnalysis, WithinObserversAgreesWithTheGoldenExperiment) {
    const auto expected = json::parse(golden_text("experiment/expected.json"))["anova"];
    const auto found = analysis_of(observer_means(), {"votes", {"method"}, "observer"});
    EXPECT_EQ(found.design, "within");
    const auto& method = term(found, "method");
    const auto& row = expected["rm_method"]["method"];
    expect_near(row["SS"], method.effect.ss / (27 * 27), 1e-14, "SS"); // totals of 27 rounds
    expect_near(row["F"], method.test.f, 1e-14, "F");
    expect_near(row["p"], method.test.p, 1e-12, "p");
    expect_near(row["GG"], method.sphericity.greenhouse_geisser, 1e-13, "GG");
    expect_near(row["mauchly_W"], method.sphericity.mauchly_w, 1e-12, "W");
    for (std::size_t i = 0; i < 6; ++i)
        expect_near(expected["rm_method_tukey"]["pairs"][i]["p"], found.levels->tukey.pairs[i].p,
                    1e-11, "Tukey");
}

TEST(TableAnalysis, SeveralWithinFactorsAgreeWithTheIntegerAnalysis) {
    const auto found = analysis_of(observer_means(1), {"votes", {"session", "method"}, "observer"});
    // The same table from integers; sessions alone cannot vary.
    std::vector<std::int64_t> votes;
    for (const auto& scoped : analysis::count_votes(golden_votes(), {true, true, {}}))
        for (std::size_t a = 0; a < 4; ++a)
            votes.push_back(scoped.matrix.half_votes(a));
    const auto exact = within_observers_of_counts(10, {{"session", 3}, {"method", 4}}, votes, 2);
    ASSERT_EQ(found.terms.size(), exact.effects.size());
    for (std::size_t i = 0; i < exact.effects.size(); ++i) {
        const auto& effect = exact.effects[i];
        const auto& own = term(found, effect.name);
        EXPECT_LE(std::abs(own.effect.ss - effect.effect.ss), 1e-14 * effect.effect.ss);
        EXPECT_LE(std::abs(own.error->ss - effect.error.ss), 1e-14 * effect.error.ss);
        EXPECT_EQ(own.error->df, effect.error.df);
        if (effect.effect.ss > 0) {
            EXPECT_NEAR(own.sphericity.greenhouse_geisser, effect.sphericity.greenhouse_geisser,
                        1e-13);
        }
    }
    EXPECT_EQ(term(found, "session").test.outcome, Outcome::Undefined);
}

TEST(TableAnalysis, MixedDesignsAgreeWithTheGoldenExperiment) {
    const auto expected =
        json::parse(golden_text("experiment/expected.json"))["anova"]["mixed_sex_method"];
    const MeasurementColumns columns{"votes", {"sex", "method"}, "observer"};
    const auto two = analysis_of(observer_means(), columns);
    const auto three = analysis_of(observer_means(), columns, SumsOfSquares::Partial);
    EXPECT_EQ(two.design, "mixed");
    expect_near(expected["method_type2_or_1"]["F"], term(two, "method").test.f, 1e-13, "II");
    expect_near(expected["method_type3"]["F"], term(three, "method").test.f, 1e-13, "III");
    for (const auto* found : {&two, &three}) {
        const auto& cross = term(*found, "sex:method");
        expect_near(expected["group_x_method"]["F"], cross.test.f, 1e-13, "sex x method");
        expect_near(expected["group_x_method"]["p"], cross.test.p, 1e-12, "sex x method");
        expect_near(expected["sphericity"]["GG"], cross.sphericity.greenhouse_geisser, 1e-13, "GG");
        EXPECT_EQ(term(*found, "sex").test.outcome, Outcome::Undefined); // votes are ipsative
    }
}

TEST(TableAnalysis, SubjectsWithHolesAreLeftOutAndNamed) {
    auto text = observer_means();
    text.erase(text.rfind("O10,"), std::string::npos);
    const auto found = analysis_of(text, {"votes", {"method"}, "observer"});
    EXPECT_EQ(found.subjects, 9);
    EXPECT_THAT(found.notes, testing::ElementsAre(HasSubstr(": O10.")));
}

TEST(TableAnalysis, RefusalsNameWhatIsMissing) {
    const auto refusal = [](const std::string& text, const MeasurementColumns& columns,
                            const TableOptions& options = {}) {
        const auto table = read_measurements(text, "t.csv", columns);
        if (!table)
            return table.error();
        const auto found = analyze_table(*table, options);
        return found ? "none" : found.error();
    };
    const std::string text = "s,a,b,y\n1,p,u,1\n1,q,v,2\n2,p,u,3\n2,q,v,5\n";
    EXPECT_EQ(refusal(text, {"z", {"a"}, ""}), "t.csv:1: no column 'z', the header has s, a, b, y");
    EXPECT_EQ(refusal(text, {"y", {"a", "a"}, ""}),
              "column 'a' is asked for twice, expected different columns as response, factors and "
              "within");
    EXPECT_EQ(refusal("a,y\np,1\nq,x\n", {"y", {"a"}, ""}),
              "t.csv:3: y: 'x', column 1: found 'x', expected a digit");
    EXPECT_EQ(refusal("a,y\np,1\n,2\n", {"y", {"a"}, ""}), "t.csv:3: a is empty, expected a level");
    EXPECT_EQ(refusal("a,y\np,1\np ,2\n", {"y", {"a"}, ""}),
              "t.csv: a 'p' and 'p ' differ only in blanks around them, expected one spelling");
    EXPECT_EQ(refusal("a,y\np,1\np,2\n", {"y", {"a"}, ""}),
              "'a' has one level, p; expected two or more");
    EXPECT_EQ(refusal("a,y\n", {"y", {"a"}, ""}), "t.csv:1: no values of 'y' below the header");
    EXPECT_EQ(refusal("", {"y", {"a"}, ""}), "t.csv:1: the file is empty, expected a header row");
    EXPECT_EQ(refusal(text, {"y", {"a"}, ""}, {.control = "r"}),
              "control 'r' is no level of a, expected one of p, q");
    EXPECT_EQ(refusal("s,a,y\n1,p,1\n2,q,2\n3,p,1\n", {"y", {"a"}, "s"}),
              "no factor varies within 's': leave --within out, or name the column of whoever was "
              "measured again");
    EXPECT_THAT(refusal("s,a,y\n1,p,1\n1,q,2\n2,p,1\n", {"y", {"a"}, "s"}),
                HasSubstr("1 of 's' have a value in every combination"));
}

TEST(TableAnalysis, TextNamesEveryUndefinedNumber) {
    const auto text = table_text(analysis_of("a,y\np,1\nq,2\n", {"y", {"a"}, ""}));
    EXPECT_THAT(text, HasSubstr("no degrees of freedom are left to test with"));
    EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

TEST(TableAnalysis, ADunnettOfTwoLevelsIsAPlainT) {
    const auto table = table_of("a,y\np,1\np,2\np,4\nq,5\nq,7\nq,6\n", {"y", {"a"}, ""});
    const auto found = analyze_table(table, {.control = "p"}).value();
    EXPECT_NEAR(found.levels->dunnett->pairs[0].p, found.terms[0].test.p, 1e-14);
    EXPECT_NEAR(found.levels->dunnett->pairs[0].p, found.levels->t[0].p, 1e-14);
}

// 1e155 squared is no double, and neither are sums of squares of 1e-165: such values are analysed
// in another unit, which is said.
TEST(TableAnalysis, ValuesWhoseSquaresAreNoNumbersAreAnalysedInAnotherUnit) {
    const auto in_units_of = [](int exponent, const MeasurementColumns& columns) {
        std::string text = "y,m,o\n";
        for (const auto* value :
             {"1|,a,P1", "2|,a,P2", "3.5|,b,P1", "5|,b,P2", "6|,c,P1", "9.5|,c,P2"}) {
            std::string row = value;
            text += row.replace(row.find('|'), 1, fmt::format("e{}", exponent)) + "\n";
        }
        return analysis_of(text, columns);
    };
    for (const auto& columns :
         {MeasurementColumns{"y", {"m"}, ""}, MeasurementColumns{"y", {"m"}, "o"}}) {
        const auto plain = in_units_of(0, columns);
        EXPECT_EQ(plain.unit_exponent, 0);
        for (const int exponent : {-3000, -400, -165, -101, 101, 155, 170, 308, 400, 3000}) {
            const auto found = in_units_of(exponent, columns);
            EXPECT_EQ(found.unit_exponent, exponent);
            EXPECT_EQ(found.total.ss, plain.total.ss); // of the same digits
            EXPECT_EQ(found.residual.ss, plain.residual.ss);
            EXPECT_EQ(found.residual_sd, plain.residual_sd);
            EXPECT_EQ(found.grand_mean, plain.grand_mean);
            EXPECT_EQ(found.terms[0].test.f, plain.terms[0].test.f);
            EXPECT_EQ(found.terms[0].test.p, plain.terms[0].test.p);
            EXPECT_THAT(found.notes, testing::Contains(HasSubstr(fmt::format(
                                         "everything here is of y / 1e{0}: means, differences and "
                                         "deviations want to be multiplied by 1e{0}, sums and "
                                         "means of squares by 1e{1}",
                                         exponent, 2 * exponent))));
            EXPECT_THAT(table_text(found),
                        testing::StartsWith(fmt::format("y / 1e{} by m", exponent)));
            EXPECT_EQ(json::parse(table_json(found, ""))["unit_exponent"], exponent);
        }
        for (const int exponent : {-100, 100}) {
            const auto found = in_units_of(exponent, columns);
            EXPECT_EQ(found.unit_exponent, 0);
            EXPECT_TRUE(std::isnormal(found.total.ss));
            EXPECT_TRUE(std::isnormal(found.residual.ss));
            EXPECT_FALSE(json::parse(table_json(found, "")).contains("unit_exponent"));
        }
    }
}

} // namespace
