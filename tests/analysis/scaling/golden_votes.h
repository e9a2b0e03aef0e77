// The golden experiment's win matrices, and golden JSON in the shapes of the scaling tests.
#pragma once

#include "analysis/scaling/counts.h"
#include "tests/analysis/numerics/golden_json.h"
#include "tests/analysis/numerics/golden_table.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace golden {

inline const std::vector<std::string>& methods() {
    static const std::vector<std::string> names{"SHSS", "Patro", "Green", "PRT"};
    return names;
}

/// Win matrices of one scope of the shared experiment, by its level ("" for the scope "all").
inline std::map<std::string, std::vector<std::int64_t>> win_matrices(const std::string& scope) {
    const Table table("experiment/vote_matrices.csv");
    const auto index = [](const std::string& name) {
        return static_cast<std::size_t>(std::find(methods().begin(), methods().end(), name) -
                                        methods().begin());
    };
    std::map<std::string, std::vector<std::int64_t>> matrices;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (table.text(row, "scope") != scope)
            continue;
        auto& wins = matrices[scope == "all" ? "" : table.text(row, scope)];
        wins.resize(16);
        wins.at(index(table.text(row, "winner")) * 4 + index(table.text(row, "loser"))) =
            static_cast<std::int64_t>(table.argument(row, "votes"));
    }
    return matrices;
}

inline std::vector<analysis::scaling::WinCounts>
views(const std::map<std::string, std::vector<std::int64_t>>& matrices, std::size_t conditions) {
    std::vector<analysis::scaling::WinCounts> counts;
    for (const auto& [name, wins] : matrices)
        counts.push_back({conditions, wins});
    return counts;
}

/// Counts of rows [first, second, first wins, second wins, ties (if any)].
struct Votes {
    std::size_t conditions = 0;
    std::vector<std::int64_t> first_chosen, second_chosen, tied;

    explicit Votes(std::size_t t)
        : conditions(t), first_chosen(t * t, 0), second_chosen(t * t, 0), tied(t * t, 0) {}

    Votes(std::size_t t, const nlohmann::json& rows) : Votes(t) {
        for (const auto& row : rows) {
            const auto at = row.at(0).get<std::size_t>() * t + row.at(1).get<std::size_t>();
            first_chosen.at(at) += row.at(2).get<std::int64_t>();
            second_chosen.at(at) += row.at(3).get<std::int64_t>();
            tied.at(at) += row.size() > 4 ? row.at(4).get<std::int64_t>() : 0;
        }
    }

    analysis::scaling::OrderedCounts ordered() const {
        return {conditions, first_chosen, second_chosen, tied};
    }

    std::vector<std::int64_t> wins() const {
        std::vector<std::int64_t> result(conditions * conditions, 0);
        for (std::size_t i = 0; i < conditions; ++i)
            for (std::size_t j = 0; j < conditions; ++j) {
                result[i * conditions + j] += first_chosen[i * conditions + j];
                result[j * conditions + i] += second_chosen[i * conditions + j];
            }
        return result;
    }
};

} // namespace golden
