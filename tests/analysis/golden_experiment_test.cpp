// Every figure of the golden experiment that the analysis computes, leaf by leaf.
#include "analysis/findings_json.h"
#include "analysis/vote_matrix_csv.h"
#include "tests/analysis/golden.h"

#include <nlohmann/json.hpp>

#include <algorithm>
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

// Scopes come in another order here and there; they are the same ones.
void sort_by_scope(json& rows) {
    const auto text = [](const json& value) {
        return value.is_number() ? value.dump() : value.get<std::string>();
    };
    for (auto& row : rows)
        if (row.contains("session"))
            row["session"] = text(row["session"]);
    std::sort(rows.begin(), rows.end(), [](const json& a, const json& b) {
        const auto key = [](const json& row) {
            return row.value("session", "") + "/" + row.value("model", "") + "/" +
                   row.value("light", "");
        };
        return key(a) < key(b);
    });
}

TEST(GoldenExperiment, EveryComputedLeafAgreesTo12Digits) {
    auto expected = json::parse(golden_text("experiment/expected.json"));
    // Words, and how many steps another program's Newton took.
    leave_out(expected,
              {"/anova/mixed_sex_method/note", "/choice_models/bradley_terry_cluster_robust/note"});
    for (auto& [name, model] : expected["choice_models"].items())
        if (model.is_object())
            model.erase("newton_iterations");
    analysis::AnalysisOptions options;
    options.group_name = "sex";
    for (int o = 1; o <= 10; ++o)
        options.groups[o < 10 ? "O0" + std::to_string(o) : "O10"] = o <= 4 ? "M" : "F";
    auto found = json::parse(analysis::findings_json(analysis::analyze(golden_votes(), options)));
    for (const auto* list :
         {"agreement_u_per_scene_session", "agreement_u_per_scene_sessions_as_judges",
          "agreement_u_per_session_scenes_as_judges"}) {
        sort_by_scope(expected["paired_comparison"][list]);
        sort_by_scope(found["paired_comparison"][list]);
    }
    Comparison comparison;
    comparison.tree(expected, found, "");
    for (const auto& wrong : comparison.wrong)
        ADD_FAILURE() << wrong;
    EXPECT_GT(comparison.compared, 1500u);
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
