// Every figure of the golden experiment that the analysis computes, leaf by leaf.
#include "analysis/findings_json.h"
#include "analysis/vote_matrix_csv.h"
#include "tests/analysis/golden.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <sstream>

namespace {

using nlohmann::json;

// Counts how many leaves agree, and names those that do not.
struct Comparison {
    std::size_t compared = 0;
    double worst = 0;
    std::string worst_at;
    std::vector<std::string> wrong;

    void number(double expected, double found, const std::string& at) {
        ++compared;
        const double error =
            expected == 0 ? std::abs(found) : std::abs(found - expected) / std::abs(expected);
        if (!(error <= 1e-12))
            wrong.push_back(at + ": expected " + json(expected).dump() + ", found " +
                            json(found).dump());
        if (!(error <= worst)) {
            worst = error;
            worst_at = at;
        }
    }

    void leaf(const json& expected, const json& found, const std::string& at) {
        if (expected.is_number() && found.is_number()) {
            number(expected.get<double>(), found.get<double>(), at);
        } else {
            ++compared;
            if (expected != found)
                wrong.push_back(at + ": expected " + expected.dump() + ", found " + found.dump());
        }
    }

    void tree(const json& expected, const json& found, const std::string& at) {
        if (expected.is_object()) {
            for (const auto& [key, value] : expected.items())
                if (found.is_object() && found.contains(key))
                    tree(value, found[key], at + "/" + key);
                else
                    wrong.push_back(at + "/" + key + ": missing");
        } else if (expected.is_array()) {
            if (!found.is_array() || found.size() != expected.size()) {
                wrong.push_back(at + ": another number of elements");
                return;
            }
            for (std::size_t i = 0; i < expected.size(); ++i)
                tree(expected[i], found[i], at + "/" + std::to_string(i));
        } else {
            leaf(expected, found, at);
        }
    }
};

// What the program does not compute: in the golden file, not among our claims.
void leave_out(json& expected, const std::vector<std::string>& pointers) {
    for (const auto& pointer : pointers) {
        const json::json_pointer path(pointer);
        ASSERT_TRUE(expected.contains(path)) << pointer;
        expected[path.parent_pointer()].erase(path.back());
    }
}

TEST(GoldenExperiment, EveryComputedLeafAgreesTo12Digits) {
    auto expected = json::parse(golden_text("experiment/expected.json"));
    leave_out(expected,
              {"/anova/oneway_rounds_pseudoreplicated/levene_mean",
               "/anova/oneway_rounds_pseudoreplicated/brown_forsythe",
               "/anova/oneway_rounds_pseudoreplicated/welch",
               "/anova/oneway_observer_means/levene_mean",
               "/anova/oneway_observer_means/brown_forsythe", "/anova/oneway_observer_means/welch",
               "/anova/rm_method_arcsine_sqrt_share", "/anova/rm_method_logit_plus_half",
               "/anova/mixed_sex_method", "/friedman_observer_means", "/nemenyi",
               "/paired_comparison", "/choice_models"});
    const auto found = json::parse(analysis::findings_json(analysis::analyze(golden_votes())));
    Comparison comparison;
    comparison.tree(expected, found, "");
    for (const auto& wrong : comparison.wrong)
        ADD_FAILURE() << wrong;
    EXPECT_GT(comparison.compared, 700u);
    RecordProperty("leaves", static_cast<int>(comparison.compared));
    std::printf("%zu leaves, worst relative error %.2g at %s\n", comparison.compared,
                comparison.worst, comparison.worst_at.c_str());
}

// Rows of a CSV as last-column-by-key; the key is everything before the value columns.
std::map<std::string, std::string> rows_by_key(const std::string& text, std::size_t value_columns) {
    std::map<std::string, std::string> rows;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        auto cut = line.size();
        for (std::size_t i = 0; i < value_columns; ++i)
            cut = line.rfind(',', cut - 1);
        rows[line.substr(0, cut)] = line.substr(cut + 1);
    }
    return rows;
}

TEST(GoldenExperiment, VoteMatricesAgreeInEveryScope) {
    const auto expected = rows_by_key(golden_text("experiment/vote_matrices.csv"), 1);
    EXPECT_EQ(expected.size(), 4309u); // 4308 counts and the header
    EXPECT_EQ(rows_by_key(analysis::vote_matrices_csv(golden_votes()), 1), expected);
}

TEST(GoldenExperiment, ScoresAgreeInEveryScope) {
    // The golden shares have 20 digits; votes and maximum are compared as text, shares as numbers.
    const auto expected = rows_by_key(golden_text("experiment/scores.csv"), 3);
    const auto found = rows_by_key(analysis::scores_csv(golden_votes()), 3);
    ASSERT_EQ(expected.size(), found.size());
    ASSERT_GT(expected.size(), 1400u);
    for (const auto& [key, text] : expected) {
        ASSERT_TRUE(found.contains(key)) << key;
        const auto& other = found.at(key);
        EXPECT_EQ(text.substr(0, text.rfind(',')), other.substr(0, other.rfind(','))) << key;
        if (key.starts_with("scope"))
            continue;
        const double share = std::stod(text.substr(text.rfind(',') + 1));
        EXPECT_LE(std::abs(std::stod(other.substr(other.rfind(',') + 1)) - share), 1e-16) << key;
    }
}

} // namespace
