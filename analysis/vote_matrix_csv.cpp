#include "analysis/vote_matrix_csv.h"

#include "analysis/csv.h"
#include "analysis/vote_matrix.h"

#include <fmt/format.h>

namespace analysis {

namespace {

std::string header(const VoteTable& table) {
    std::string line = "scope,observer,session";
    for (const auto& factor : table.factor_names)
        line += "," + csv_field(factor);
    return line;
}

std::string labels(const ScopedMatrix& cell) {
    auto line =
        csv_field(cell.scope) + "," + csv_field(cell.observer) + "," + csv_field(cell.session);
    for (const auto& level : cell.scene)
        line += "," + csv_field(level);
    return line;
}

/// A table with simulated votes says so in every row.
std::string_view header_end(const VoteTable& table) {
    return table.simulated ? ",simulated\n" : "\n";
}

std::string_view row_end(const VoteTable& table) {
    return table.simulated ? ",1\n" : "\n";
}

void append_votes(std::string& csv, const ScopedMatrix& cell, const VoteTable& table, bool ties) {
    const auto prefix = labels(cell);
    const auto t = table.conditions.size();
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = 0; j < t; ++j)
            if (i != j) {
                csv += fmt::format("{},{},{},{}", prefix, csv_field(table.conditions.name(i)),
                                   csv_field(table.conditions.name(j)), cell.matrix.wins(i, j));
                csv += ties ? fmt::format(",{}", cell.matrix.ties(i, j)) : "";
                csv += row_end(table);
            }
}

void append_scores(std::string& csv, const ScopedMatrix& cell, const VoteTable& table) {
    const auto prefix = labels(cell);
    for (std::size_t i = 0; i < table.conditions.size(); ++i) {
        const auto half = cell.matrix.half_votes(i), met = cell.matrix.comparisons(i);
        csv += fmt::format("{},{},{}{},{},{}{}", prefix, csv_field(table.conditions.name(i)),
                           half / 2, half % 2 != 0 ? ".5" : "", met,
                           met > 0 ? fmt::format("{:.17g}", to_double({half, 2 * met})) : "",
                           row_end(table));
    }
}

} // namespace

std::string vote_matrices_csv(const VoteTable& table) {
    const bool ties = count_votes(table).total_ties() > 0;
    auto csv = header(table) + ",winner,loser,votes" + (ties ? ",ties" : "");
    csv += header_end(table);
    for (const auto& scope : usual_scopes(table))
        for (const auto& cell : count_votes(table, scope))
            append_votes(csv, cell, table, ties);
    return csv;
}

std::string scores_csv(const VoteTable& table) {
    auto csv = header(table) + ",method,votes,max_votes,share";
    csv += header_end(table);
    for (const auto& scope : usual_scopes(table))
        for (const auto& cell : count_votes(table, scope))
            append_scores(csv, cell, table);
    return csv;
}

} // namespace analysis
