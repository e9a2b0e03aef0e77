#include "tests/analysis/precision.h"

#include "analysis/anova/shapiro_wilk.h"
#include "analysis/anova/table_analysis.h"
#include "analysis/findings_json.h"
#include "analysis/numerics/distributions.h"
#include "analysis/numerics/dunnett.h"
#include "analysis/numerics/nist_file.h"
#include "analysis/numerics/one_way_exact.h"
#include "analysis/numerics/studentized_range.h"
#include "tests/analysis/golden.h"
#include "tests/analysis/numerics/golden_table.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

namespace precision {

namespace {

using namespace analysis;
using golden::Table;
using nlohmann::json;

// The worst of many comparisons.  NaN is the worst of all.
class Worst {
  public:
    Worst(std::string what, std::string reference)
        : row_{std::move(what), std::move(reference), 0, 17} {}

    void see(double found, long double expected) {
        const long double error = golden::relative_error(found, expected);
        ++row_.values;
        if (!(error <= worst_))
            worst_ = error;
    }

    // p where a double holds all its digits, its logarithm elsewhere.
    void see_tail(const numerics::Tail& found, long double p, long double log10_p) {
        if (p > 1e-300L)
            see(found.p, p);
        else if (std::isfinite(log10_p))
            see(found.log10_p, log10_p);
    }

    Row row() const {
        Row result = row_;
        result.digits = worst_ > 0 ? static_cast<double>(-std::log10(worst_)) : 17;
        if (std::isnan(worst_))
            result.digits = 0;
        return result;
    }

  private:
    Row row_;
    long double worst_ = 0;
};

void nist(std::vector<Row>& rows) {
    const Table table("nist_exact.csv");
    const std::string reference = "exact rational arithmetic";
    Worst f("NIST's eleven sets: F", reference), ss("the same: sums of squares", reference),
        rest("the same: R squared, residual deviation", reference);
    for (std::size_t i = 0; i < table.rows(); ++i) {
        if (table.text(i, "input") != "decimal")
            continue;
        std::ifstream file(PAIRLIGHT_TEST_DATA "/nist/" + table.text(i, "set") + ".dat");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const auto sums = numerics::one_way_exact(
            numerics::read_nist_one_way(text, table.text(i, "set")).value().groups);
        f.see(sums.f, table.number(i, "F"));
        ss.see(sums.ss_between, table.number(i, "SS_between"));
        ss.see(sums.ss_within, table.number(i, "SS_within"));
        rest.see(sums.r_squared, table.number(i, "R2"));
        rest.see(sums.residual_sd, table.number(i, "residual_sd"));
    }
    for (const auto* worst : {&f, &ss, &rest})
        rows.push_back(worst->row());
}

void studentized_range(std::vector<Row>& rows) {
    const std::string reference = "113-bit quadrature";
    Worst upper("studentized range: upper tail, p > 1e-16", reference),
        far("the same, smaller p (then log10 p)", reference),
        shared("the same: upper tails of one k that share their work", reference),
        lower("the same: lower tail", reference), quantile("the same: quantiles", reference);
    std::map<double, numerics::StudentizedRanges> ranges;
    const Table tails("ptukey.csv");
    for (std::size_t i = 0; i < tails.rows(); ++i) {
        const double k = tails.argument(i, "k"), df = tails.argument(i, "df");
        const double q = tails.argument(i, "q");
        const auto p = tails.number(i, "upper"), below = tails.number(i, "lower");
        (p > 1e-16L ? upper : far)
            .see_tail(numerics::studentized_range_upper_tail(q, k, df), p, std::log10(p));
        shared.see_tail(ranges.try_emplace(k, k).first->second.upper_tail(q, df), p, std::log10(p));
        lower.see_tail(numerics::studentized_range_lower_tail(q, k, df), below, std::log10(below));
    }
    const Table quantiles("qtukey.csv");
    for (std::size_t i = 0; i < quantiles.rows(); ++i)
        quantile.see(numerics::studentized_range_quantile(quantiles.argument(i, "p_upper"),
                                                          quantiles.argument(i, "k"),
                                                          quantiles.argument(i, "df")),
                     quantiles.number(i, "q"));
    for (const auto* worst : {&upper, &far, &shared, &lower, &quantile})
        rows.push_back(worst->row());
}

void distributions(std::vector<Row>& rows) {
    const std::string reference = "50 to 60 digits";
    const Table f_table("f_tails.csv"), t_table("t_tails.csv"), chi_table("chi2_tails.csv"),
        z_table("normal_tails.csv"), noncentral("noncentral_f.csv"),
        dunnett("dunnett_two_sided.csv");
    Worst f("F: upper tail", reference), t("t: upper tail", reference),
        chi("chi-squared: upper tail", reference), z("normal: lower tail", reference),
        power("noncentral F: upper tail", reference), many("Dunnett: two-sided", "28 digits");
    for (std::size_t i = 0; i < f_table.rows(); ++i)
        f.see_tail(numerics::f_upper_tail(f_table.argument(i, "F"), f_table.argument(i, "df1"),
                                          f_table.argument(i, "df2")),
                   f_table.number(i, "upper"), f_table.number(i, "log10_upper"));
    for (std::size_t i = 0; i < t_table.rows(); ++i)
        t.see_tail(numerics::t_upper_tail(t_table.argument(i, "t"), t_table.argument(i, "df")),
                   t_table.number(i, "upper_one_sided"), t_table.number(i, "log10_upper"));
    for (std::size_t i = 0; i < chi_table.rows(); ++i)
        chi.see_tail(numerics::chi_squared_upper_tail(chi_table.argument(i, "x"),
                                                      chi_table.argument(i, "df")),
                     chi_table.number(i, "upper"), chi_table.number(i, "log10_upper"));
    for (std::size_t i = 0; i < z_table.rows(); ++i)
        if (z_table.number(i, "cdf") > 1e-300L)
            z.see(numerics::normal_upper_tail(-z_table.argument(i, "z")).p,
                  z_table.number(i, "cdf"));
    for (std::size_t i = 0; i < noncentral.rows(); ++i)
        power.see(numerics::noncentral_f_upper_tail(
                      noncentral.argument(i, "F"), noncentral.argument(i, "df1"),
                      noncentral.argument(i, "df2"), noncentral.argument(i, "lambda"))
                      .p,
                  noncentral.number(i, "power"));
    for (std::size_t i = 0; i < dunnett.rows(); ++i) {
        const std::vector<double> loading(
            static_cast<std::size_t>(dunnett.argument(i, "comparisons")), std::sqrt(0.5));
        many.see(numerics::dunnett_upper_tail(dunnett.argument(i, "abs_t"), loading,
                                              dunnett.argument(i, "df"))
                     .p,
                 dunnett.number(i, "upper"));
    }
    for (const auto* worst : {&f, &t, &chi, &z, &power, &many})
        rows.push_back(worst->row());
}

// Numbers of the golden tree that the findings have under the same names.
void see_numbers(Worst& worst, const json& expected, const json& found) {
    if (expected.is_number() && found.is_number()) {
        if (expected.get<double>() != 0)
            worst.see(found.get<double>(), expected.get<double>());
    } else if (expected.is_object() && found.is_object()) {
        for (const auto& [key, value] : expected.items())
            if (key != "newton_iterations" && found.contains(key))
                see_numbers(worst, value, found[key]);
    } else if (expected.is_array() && found.is_array() && expected.size() == found.size()) {
        for (std::size_t i = 0; i < expected.size(); ++i)
            see_numbers(worst, expected[i], found[i]);
    }
}

void experiment(std::vector<Row>& rows) {
    const auto expected = json::parse(golden_text("experiment/expected.json"));
    const auto found = json::parse(findings_json(analyze(golden_votes())));
    const std::pair<const char*, const char*> parts[] = {
        {"anova", "golden experiment: analyses of variance"},
        {"friedman_observer_means", "the same: Friedman"},
        {"nemenyi", "the same: Nemenyi"},
        {"choice_models", "the same: choice models"}};
    for (const auto& [part, what] : parts) {
        Worst worst(what, "rational and 50-digit arithmetic");
        see_numbers(worst, expected.at(part), found.at(part));
        rows.push_back(worst.row());
    }
}

void unbalanced(std::vector<Row>& rows) {
    const auto sets = json::parse(golden_text("sets/anova_sets.json"));
    Worst worst("types I, II, III of unbalanced designs: SS and F", "exact rational arithmetic");
    const std::pair<const char*, std::vector<std::string>> designs[] = {
        {"unbalanced_2way", {"method", "model"}},
        {"unbalanced_2way_empty_cell", {"method", "model"}},
        {"unbalanced_3way", {"A", "B", "C"}}};
    for (const auto& [name, factors] : designs) {
        const auto table = anova::read_measurements(golden_text(fmt::format("sets/{}.csv", name)),
                                                    name, {"y", factors, ""})
                               .value();
        for (int type = 1; type <= 3; ++type) {
            const auto key = fmt::format("type{}", type);
            if (!sets.at(name).contains(key))
                continue;
            const auto found =
                anova::analyze_table(table, {.type = static_cast<anova::SumsOfSquares>(type - 1)})
                    .value();
            for (const auto& term : found.terms) {
                const auto& row = sets.at(name).at(key).at(term.name);
                worst.see(term.effect.ss, row["SS"].get<double>());
                worst.see(term.test.f, row["F"].get<double>());
            }
        }
    }
    rows.push_back(worst.row());
}

} // namespace

std::vector<Row> measure() {
    std::vector<Row> rows;
    nist(rows);
    studentized_range(rows);
    distributions(rows);
    unbalanced(rows);
    experiment(rows);
    return rows;
}

std::string page(const std::vector<Row>& rows) {
    std::string text =
        "# Precision\n\n"
        "How many digits of the analysis's numbers are right, against values from exact rational "
        "arithmetic, from\n"
        "50-digit arithmetic or from quadrature in 113 bits "
        "(`tests/data/golden/README.md`). Digits are -log10 of the\n"
        "worst relative error among all values of a row, rounded down; 17 means that every value "
        "is "
        "equal to the last bit.\n"
        "A double has 15.95 digits. What is hard on arithmetic, in the renderer too, stands in\n"
        "[precision-hard-cases.md](precision-hard-cases.md).\n\n"
        "This page is written by a program: `cmake --build --preset release --target "
        "precision_report`, then run\n"
        "`build/release/tests/analysis/precision_report docs/precision.md`. A test measures again "
        "and fails where a figure is lost.\n\n"
        "Of light and of image errors: [precision-transport.md](precision-transport.md).\n\n"
        "| quantity | compared with | values | digits |\n|---|---|---|---|\n";
    for (const auto& row : rows)
        text += fmt::format("| {} | {} | {} | {:.1f} |\n", row.what, row.reference, row.values,
                            std::floor(10 * row.digits) / 10);
    return text;
}

} // namespace precision
