// Simulated votes are marked in every row.
#include "analysis/formats/vote_writers.h"

#include "analysis/csv.h"
#include "analysis/vote_matrix.h"

#include <fmt/format.h>

namespace analysis::formats {

namespace {

// A table with simulated votes says so in every row, in its last column.
std::string header(const VoteTable& table, const std::string& before, const std::string& after) {
    std::string line = before;
    for (const auto& factor : table.factor_names)
        line += "," + csv_field(factor);
    return line + after + (table.simulated ? ",simulated\n" : "\n");
}

const char* row_end(const VoteTable& table) {
    return table.simulated ? ",1\n" : "\n";
}

std::vector<ScopedMatrix> rounds_of(const VoteTable& table) {
    return count_votes(table, {true, true, std::vector<bool>(table.factors.size(), true)});
}

std::string labels_of(const ScopedMatrix& round) {
    auto line = csv_field(round.observer) + "," + csv_field(round.session);
    for (const auto& level : round.scene)
        line += "," + csv_field(level);
    return line;
}

const char* answer_of(const VoteMatrix& matrix, std::size_t first, std::size_t second) {
    if (matrix.comparisons(first, second) == 0)
        return "NA";
    if (matrix.ties(first, second) > 0)
        return "0";
    return matrix.wins(first, second) > 0 ? "1" : "-1";
}

} // namespace

std::string pwcmp_csv(const VoteTable& table) {
    auto csv = header(table, "observer,session_id", ",condition_A,condition_B,is_A_selected");
    for (std::size_t vote = 0; vote < table.size(); ++vote) {
        csv += csv_field(table.observers.name(table.observer[vote])) + "," +
               csv_field(table.sessions.name(table.session[vote]));
        for (std::size_t f = 0; f < table.factors.size(); ++f)
            csv += "," + csv_field(table.factors[f].name(table.factor[f][vote]));
        csv += "," + csv_field(table.conditions.name(table.left[vote])) + "," +
               csv_field(table.conditions.name(table.right[vote]));
        csv += table.chosen[vote] == protocols::Choice::Left    ? ",1"
               : table.chosen[vote] == protocols::Choice::Right ? ",0"
                                                                : ",0.5";
        csv += row_end(table);
    }
    return csv;
}

std::string pair_counts_csv(const VoteTable& table) {
    const bool ties = count_votes(table).total_ties() > 0;
    auto csv = header(table, "observer,session",
                      std::string(",player1,player2,win1,win2") + (ties ? ",ties" : ""));
    const auto t = table.conditions.size();
    for (const auto& round : rounds_of(table))
        for (std::size_t i = 0; i < t; ++i)
            for (std::size_t j = i + 1; j < t; ++j) {
                if (round.matrix.comparisons(i, j) == 0)
                    continue;
                csv += fmt::format("{},{},{},{},{}", labels_of(round),
                                   csv_field(table.conditions.name(i)),
                                   csv_field(table.conditions.name(j)), round.matrix.wins(i, j),
                                   round.matrix.wins(j, i));
                csv += ties ? fmt::format(",{}", round.matrix.ties(i, j)) : "";
                csv += row_end(table);
            }
    return csv;
}

Expected<std::string> paired_comparison_csv(const VoteTable& table) {
    const auto& names = table.conditions.names();
    std::string pairs;
    for (std::size_t j = 0; j < names.size(); ++j) {
        if (names[j].find(':') != std::string::npos)
            return tl::unexpected(fmt::format(
                "condition '{}' has a colon, which parts the two of a pair in this form",
                names[j]));
        for (std::size_t i = 0; i < j; ++i)
            pairs += "," + csv_field(names[i] + ":" + names[j]);
    }
    auto csv = header(table, "observer,session", pairs);
    for (const auto& round : rounds_of(table)) {
        csv += labels_of(round);
        for (std::size_t j = 0; j < names.size(); ++j)
            for (std::size_t i = 0; i < j; ++i) {
                if (round.matrix.comparisons(i, j) > 1)
                    return tl::unexpected(
                        fmt::format("{} compared {} and {} {} times in session {}: this form holds "
                                    "one answer; export pairs instead",
                                    round.observer, names[i], names[j],
                                    round.matrix.comparisons(i, j), round.session));
                csv += fmt::format(",{}", answer_of(round.matrix, i, j));
            }
        csv += row_end(table);
    }
    return csv;
}

} // namespace analysis::formats
