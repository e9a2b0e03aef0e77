// Constants are of R 4.2.2: `lm` of cell means with its `vcov`, `pt`, `TukeyHSD`, `pairwise.t.test`
// and `lm(difference ~ group)` with sum contrasts; the calls stand with each test.  Fifteen digits
// of them are right, but of `ptukey` only about five: the studentized range has tables of its own.
#include "analysis/anova/marginal_means.h"
#include "analysis/anova/table_analysis.h"
#include "analysis/anova/table_json.h"
#include "analysis/anova/table_text.h"
#include "analysis/vote_matrix.h"
#include "tests/analysis/golden.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace {

using namespace analysis::anova;
using testing::HasSubstr;

constexpr double digits_of_r = 1e-12;     // relative; R prints 17 and loses three
constexpr double digits_of_ptukey = 2e-5; // its quadrature is fixed

TableAnalysis analysis_of(const std::string& text,
                          const MeasurementColumns& columns,
                          SumsOfSquares type = SumsOfSquares::Hierarchical) {
    return analyze_table(read_measurements(text, "t.csv", columns).value(), {.type = type}).value();
}

const FactorComparisons& factor(const TableAnalysis& analysis, const std::string& name) {
    for (const auto& found : analysis.factors)
        if (found.factor == name)
            return found;
    throw std::out_of_range(name);
}

std::size_t place(const FactorComparisons& found, const std::string& level) {
    const auto at = std::find(found.levels.begin(), found.levels.end(), level);
    EXPECT_NE(at, found.levels.end()) << level;
    return static_cast<std::size_t>(at - found.levels.begin());
}

// Which way round a pair stands follows the order of levels; `sign` turns it.
template <class Pair>
std::pair<const Pair*, double> pair_of(const std::vector<Pair>& pairs,
                                       const FactorComparisons& found,
                                       const std::string& a,
                                       const std::string& b) {
    const auto i = place(found, a), j = place(found, b);
    for (const auto& pair : pairs)
        if (pair.first == std::min(i, j) && pair.second == std::max(i, j))
            return {&pair, i < j ? 1.0 : -1.0};
    throw std::out_of_range(a + b);
}

void expect_near(double expected, double found, double tolerance, const std::string& what) {
    EXPECT_LE(std::abs(found - expected), tolerance * std::abs(expected))
        << what << ": expected " << expected << ", found " << found;
}

struct Row {
    const char *factor, *a, *b;
    double difference, standard_error, t, p, p_tukey;
};

// m <- lm(y ~ 0 + interaction(method, model)); L %*% coef(m), sqrt(L %*% vcov(m) %*% t(L)),
// 2 * pt(-|t|, 39), ptukey(|t| * sqrt(2), k, 39, lower = FALSE)
TEST(MarginalMeans, OfUnequalCellsWeighCombinationsAlike) {
    const Row rows[] = {{"method", "Green", "Patro", -0.4236666666666673, 0.34538453355773285,
                         -1.2266521094693117, 0.22730767928135745, 0.61400649810856001},
                        {"method", "Green", "PRT", -1.7470000000000003, 0.34882128023002063,
                         -5.0082953621636532, 1.2200530644390111e-05, 6.9947877571752137e-05},
                        {"method", "Green", "SHSS", -1.5878055555555564, 0.37038364896958753,
                         -4.2869213043633367, 0.00011505398670391673, 0.00064193386286903742},
                        {"method", "Patro", "PRT", -1.323333333333333, 0.31275899721212186,
                         -4.2311599190728044, 0.00013636235354006607, 0.00075865821317389059},
                        {"method", "Patro", "SHSS", -1.1641388888888891, 0.33663920184649926,
                         -3.4581203927037385, 0.0013297687875969033, 0.0069876282778210674},
                        {"method", "PRT", "SHSS", 0.15919444444444397, 0.34016431579497863,
                         0.46799278187778076, 0.64239464948379121, 0.96562194966232562},
                        {"model", "Armadillo", "Athena", 0.031333333333333213, 0.29534921802889169,
                         0.10608910205500567, 0.91605547606255666, 0.99381519698129861},
                        {"model", "Armadillo", "Dragon", 0.19112500000000066, 0.28611726471734911,
                         0.66799534166108476, 0.50807074027761767, 0.78330164790004964},
                        {"model", "Athena", "Dragon", 0.15979166666666744, 0.30867987903601368,
                         0.51766142699577955, 0.6076186132224789, 0.86320915759022632}};
    const auto found =
        analysis_of(golden_text("sets/unbalanced_2way.csv"), {"y", {"method", "model"}, ""});
    ASSERT_EQ(found.factors.size(), 2u);
    const auto& method = factor(found, "method");
    expect_near(4.1853333333333333, method.means.mean[place(method, "Green")], 1e-14, "mean");
    expect_near(5.7731388888888890, method.means.mean[place(method, "SHSS")], 1e-14, "mean");
    for (const auto& row : rows) {
        const auto& own = factor(found, row.factor);
        const auto what = fmt::format("{} {} {}", row.factor, row.a, row.b);
        const auto [t, sign] = pair_of(own.means.t, own, row.a, row.b);
        expect_near(row.difference, sign * t->difference, digits_of_r, what + " difference");
        expect_near(row.standard_error, t->standard_error, digits_of_r, what + " se");
        expect_near(row.t, sign * t->t, digits_of_r, what + " t");
        EXPECT_EQ(t->df, 39) << what;
        expect_near(row.p, t->p, 1e-11, what + " p"); // t^2 multiplies what t lost
        const auto range = pair_of(own.means.tukey->pairs, own, row.a, row.b).first;
        expect_near(row.p_tukey, range->p, digits_of_ptukey, what + " Tukey");
    }
    // Holm by hand: of six, the smallest times 6, then 5, ...
    const auto holm = pair_of(method.means.t, method, "Green", "SHSS").first->p_holm;
    expect_near(5 * 0.00011505398670391673, holm, 1e-11, "Holm");
    EXPECT_EQ(pair_of(method.means.t, method, "Green", "PRT").first->p_bonferroni,
              6 * pair_of(method.means.t, method, "Green", "PRT").first->p);
}

// TukeyHSD(aov(y ~ A * B)): balanced, so marginal means are plain means.
TEST(MarginalMeans, OfABalancedDesignAreTukeysOwn) {
    const double values[] = {4.1, 5.2, 3.9, 6.3, 7.1, 5.8, 5.0, 4.4, 6.1,
                             3.3, 4.8, 2.9, 8.2, 7.7, 9.1, 5.5, 6.2, 4.9};
    std::string text = "A,B,y\n";
    for (int i = 0; i < 18; ++i)
        text += fmt::format("a{},b{},{}\n", i / 3 % 3 + 1, i / 9 + 1, values[i]);
    const auto found = analysis_of(text, {"y", {"A", "B"}, ""});
    const auto& a = factor(found, "A").means.tukey->pairs;
    expect_near(-3.3333333333333339, a[0].difference, 1e-14, "a1 - a2");
    expect_near(2.1106002872417484e-05, a[0].p, digits_of_ptukey, "a1 a2");
    expect_near(3.0483032297490165e-02, a[1].p, digits_of_ptukey, "a1 a3");
    expect_near(1.8944675577441394e-03, a[2].p, digits_of_ptukey, "a2 a3");
    expect_near(-2.14133367583680023, a[0].upper, digits_of_ptukey, "upper");
    expect_near(-2.50866632416320101, a[1].lower, digits_of_ptukey, "lower");
    // Two levels: the studentized range is t itself, and t is the root of the factor's F.
    const auto& b = factor(found, "B").means;
    expect_near(0.17781576680315581, b.tukey->pairs[0].p, digits_of_ptukey, "b1 b2");
    EXPECT_NEAR(b.tukey->pairs[0].p, b.t[0].p, 1e-14);
    EXPECT_NEAR(b.t[0].t * b.t[0].t, found.terms[1].test.f, 1e-13);
    EXPECT_EQ(factor(found, "A").means.letters, (std::vector<std::string>{"c", "a", "b"}));
}

// Totals of each observer in each session, of the golden experiment.
std::string session_totals(bool with_sex) {
    const auto table = golden_votes();
    std::string text = "observer,sex,session,method,votes\n";
    for (const auto& scoped : analysis::count_votes(table, {true, true, {}}))
        for (std::size_t a = 0; a < 4; ++a)
            text += fmt::format("{},{},{},{},{}\n", scoped.observer,
                                with_sex && scoped.observer <= "O04" ? "M" : "F", scoped.session,
                                table.conditions.name(a), scoped.matrix.half_votes(a) / 2);
    return text;
}

// m <- aggregate(votes ~ observer + method, FUN = mean);
// pairwise.t.test(m$votes, m$method, paired = TRUE, p.adjust = "none" / "holm" / "bonferroni")
TEST(MarginalMeans, WithinSubjectsHaveAnErrorOfTheirOwn) {
    const struct {
        const char *a, *b;
        double p, holm, bonferroni;
    } rows[] = {
        {"Patro", "Green", 0.001379769266057936, 0.0027595385321158719, 0.0082786155963476167},
        {"PRT", "Green", 3.2530006695608567e-06, 1.6265003347804284e-05, 1.951800401736514e-05},
        {"PRT", "Patro", 7.0568760440753098e-05, 0.00028227504176301239, 0.00042341256264451861},
        {"SHSS", "Green", 9.4863371260224367e-09, 5.691802275613462e-08, 5.691802275613462e-08},
        {"SHSS", "Patro", 0.00036874526592273698, 0.001106235797768211, 0.002212471595536422},
        {"SHSS", "PRT", 0.27788885084345161, 0.27788885084345161, 1}};

    const auto found =
        analysis_of(session_totals(false), {"votes", {"session", "method"}, "observer"});
    const auto& method = factor(found, "method");
    EXPECT_TRUE(method.within);
    EXPECT_FALSE(method.means.tukey);
    for (const auto& row : rows) {
        const auto what = fmt::format("{} {}", row.a, row.b);
        const auto* pair = pair_of(method.means.t, method, row.a, row.b).first;
        EXPECT_EQ(pair->df, 9);
        expect_near(row.p, pair->p, 1e-11, what + " p");
        expect_near(row.holm, pair->p_holm, 1e-11, what + " Holm");
        expect_near(row.bonferroni, pair->p_bonferroni, 1e-11, what + " Bonferroni");
    }
    // Every session hands out the same number of votes: nothing over nothing.
    for (const auto& pair : factor(found, "session").means.t)
        EXPECT_TRUE(std::isnan(pair.t)) << pair.t;
    EXPECT_EQ(method.means.letters, (std::vector<std::string>{"a", "b", "c", "a"}));
}

// summary(lm(difference ~ sex)), contrasts(sex) = contr.sum(2): the intercept weighs both groups
// alike; p.adjust(p, "holm")
TEST(MarginalMeans, GroupsOfUnequalSizeWeighTheSame) {
    const struct {
        const char *a, *b;
        double difference, standard_error, t, p, holm;
    } rows[] = {{"SHSS", "Patro", 8.2916666666666679, 1.62657953859329307, 5.0976091054468258,
                 9.3260024187396585e-04, 2.7978007256218977e-03},
                {"SHSS", "Green", 14.1944444444444464, 0.77236459518884892, 18.3779066685129422,
                 7.9111872778515896e-08, 4.7467123667109535e-07},
                {"SHSS", "PRT", 1.4027777777777779, 1.39551371409763258, 1.0052052972369694,
                 3.4423014152149595e-01, 3.4423014152149595e-01},
                {"Patro", "Green", 5.9027777777777777, 1.40275199371243020, 4.2079981381141209,
                 2.9639593916924675e-03, 5.9279187833849349e-03},
                {"Patro", "PRT", -6.8888888888888893, 1.05500716749071932, -6.5297081395890038,
                 1.8231519689318273e-04, 7.2926078757273090e-04},
                {"Green", "PRT", -12.7916666666666643, 1.34948442658394252, -9.4789287039400882,
                 1.2638469897921060e-05, 6.3192349489605307e-05}};

    const auto found =
        analysis_of(session_totals(true), {"votes", {"sex", "session", "method"}, "observer"});
    EXPECT_EQ(found.design, "mixed");
    const auto& method = factor(found, "method");
    for (const auto& row : rows) {
        const auto what = fmt::format("{} {}", row.a, row.b);
        const auto [pair, sign] = pair_of(method.means.t, method, row.a, row.b);
        EXPECT_EQ(pair->df, 8);
        expect_near(row.difference, sign * pair->difference, digits_of_r, what);
        expect_near(row.standard_error, pair->standard_error, digits_of_r, what + " se");
        expect_near(row.t, sign * pair->t, digits_of_r, what + " t");
        expect_near(row.p, pair->p, 1e-11, what + " p");
        expect_near(row.holm, pair->p_holm, 1e-11, what + " Holm");
    }
    EXPECT_FALSE(factor(found, "sex").within);
    EXPECT_TRUE(std::isnan(factor(found, "sex").means.t[0].t)) << "votes are ipsative";
}

constexpr const char* three_groups =
    "s,g,c,y\n1,p,x,1.5\n2,p,x,2.5\n3,q,x,3.1\n4,q,x,4.2\n5,q,x,3.7\n"
    "6,r,x,6.0\n7,r,x,5.1\n1,p,y,2.0\n2,p,y,2.2\n3,q,y,3.9\n"
    "4,q,y,5.0\n5,q,y,3.3\n6,r,y,7.2\n7,r,y,6.4\n";

// sm <- aggregate(y ~ s + g, FUN = mean); TukeyHSD(aov(y ~ g, sm)), and
// summary(lm(y_x - y_y ~ g)) with contr.sum(3)
TEST(MarginalMeans, BetweenSubjectsAreComparedOnSubjectsMeans) {
    const auto found = analysis_of(three_groups, {"y", {"g", "c"}, "s"}, SumsOfSquares::Partial);
    const auto& groups = factor(found, "g");
    EXPECT_FALSE(groups.within);
    const auto& pairs = groups.means.tukey->pairs;
    expect_near(-1.8166666666666673, pairs[0].difference, 1e-14, "p - q");
    expect_near(0.056339447022784261, pairs[0].p, digits_of_ptukey, "p q");
    expect_near(0.004576983037290927, pairs[1].p, digits_of_ptukey, "p r");
    expect_near(0.026153206676704066, pairs[2].p, digits_of_ptukey, "q r");
    expect_near(-6.1938921535378331, pairs[1].lower, digits_of_ptukey, "lower");
    const auto& within = factor(found, "c").means.t[0];
    expect_near(-0.58333333333333337, within.difference, digits_of_r, "x - y");
    expect_near(-2.6739120119164017, within.t, digits_of_r, "t");
    expect_near(0.055579282595572606, within.p, 1e-11, "p");
    // One degree of freedom: the same test as the factor's F of type III.
    for (const auto& term : found.terms)
        if (term.name == "c") {
            EXPECT_NEAR(within.t * within.t, term.test.f, 1e-12);
        }
}

TEST(MarginalMeans, WhatCannotBeComparedSaysWhy) {
    const auto empty = analysis_of(golden_text("sets/unbalanced_2way_empty_cell.csv"),
                                   {"y", {"method", "model"}, ""});
    EXPECT_EQ(factor(empty, "method").means.reason, "some combination of levels has no values");
    EXPECT_THAT(table_text(empty), HasSubstr("method, means over the other factors: n/e (some "));
    const auto json = nlohmann::json::parse(table_json(empty, ""));
    EXPECT_EQ(json["marginal_means"]["model"]["reason"],
              "some combination of levels has no values");
}

// A level that only subjects with holes had is gone, and the others keep their names.
TEST(MarginalMeans, LevelsKeepTheirNamesWhenSubjectsAreLeftOut) {
    const auto found =
        analysis_of(std::string("s,g,c,y\n0,a,x,9\n") + (three_groups + 8), {"y", {"g", "c"}, "s"});
    EXPECT_EQ(factor(found, "g").levels, (std::vector<std::string>{"p", "q", "r"}));
    EXPECT_EQ(factor(found, "g").means.mean.size(), 3u);
}

TEST(MarginalMeans, TextAndJsonSayTheTestAndTheUnit) {
    const auto found = analysis_of(three_groups, {"y", {"g", "c"}, "s"});
    const auto text = table_text(found);
    EXPECT_THAT(text, HasSubstr("Pairs: Tukey-Kramer, simultaneous level 0.05, critical q 5.04"));
    EXPECT_THAT(text, HasSubstr("Pairs: paired t, each with its own error, Holm"));
    const auto json = nlohmann::json::parse(table_json(found, ""));
    EXPECT_EQ(json["marginal_means"]["g"]["levels"][2]["level"], "r");
    EXPECT_EQ(json["marginal_means"]["g"]["tukey_kramer"]["pairs"].size(), 3u);
    EXPECT_TRUE(json["marginal_means"]["c"]["within"].get<bool>());
    EXPECT_NEAR(json["marginal_means"]["c"]["paired_t"][0]["p_holm"].get<double>(),
                0.055579282595572606, 1e-12);
}

// 1e12 and fractions, as clocks give: shifting everything moves the means and nothing else.
TEST(MarginalMeans, LargeOffsetsCostNoDigits) {
    std::string far = three_groups;
    for (std::size_t at = far.find(",x,"); at != far.npos; at = far.find(",x,", at + 3))
        far.insert(at + 3, "100000000000");
    for (std::size_t at = far.find(",y,", 10); at != far.npos; at = far.find(",y,", at + 3))
        far.insert(at + 3, "100000000000");
    const auto near = analysis_of(three_groups, {"y", {"g", "c"}, "s"});
    const auto moved = analysis_of(far, {"y", {"g", "c"}, "s"});
    EXPECT_GT(factor(moved, "g").means.mean[0], 9e10);
    for (const auto* name : {"g", "c"})
        for (std::size_t i = 0; i < factor(near, name).means.t.size(); ++i)
            expect_near(factor(near, name).means.t[i].t, factor(moved, name).means.t[i].t, 1e-14,
                        name);
}

} // namespace
