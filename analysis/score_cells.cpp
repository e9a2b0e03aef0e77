#include "analysis/score_cells.h"

#include "protocols/contract.h"

#include <algorithm>
#include <map>
#include <set>

namespace analysis {

namespace {

Scope by_observer_and_scene(const VoteTable& table) {
    return {true, false, std::vector<bool>(table.factors.size(), true)};
}

// How often each pair should have been compared by an observer in a scene: what most observers
// did in all scenes, the larger number when that is undecided; 0 when nobody finished anything.
std::int64_t expected_comparisons(const std::vector<ScopedMatrix>& cells) {
    std::map<std::string, std::set<std::int64_t>> by_observer;
    for (const auto& cell : cells)
        by_observer[cell.observer].insert(cell.matrix.complete());
    std::map<std::int64_t, std::int64_t> observers_with;
    for (const auto& [observer, counts] : by_observer)
        if (counts.size() == 1)
            ++observers_with[*counts.begin()];
    observers_with.erase(0);
    std::int64_t expected = 0, most = 0;
    for (const auto& [m, count] : observers_with)
        if (count >= most) {
            most = count;
            expected = m;
        }
    if (expected == 0)
        for (const auto& cell : cells)
            expected = std::max(expected, cell.matrix.complete());
    return expected;
}

std::int64_t shortfall(const VoteMatrix& matrix, std::int64_t expected) {
    std::int64_t missing = 0;
    for (std::size_t i = 0; i < matrix.conditions(); ++i)
        for (std::size_t j = i + 1; j < matrix.conditions(); ++j)
            missing += std::max<std::int64_t>(0, expected - matrix.comparisons(i, j));
    return missing;
}

void completeness(DesignFacts& design, const VoteTable& table) {
    const auto cells = count_votes(table, by_observer_and_scene(table));
    const auto expected = expected_comparisons(cells);
    design.missing_known = expected > 0;
    const auto pairs =
        static_cast<std::int64_t>(table.conditions.size() * (table.conditions.size() - 1) / 2);
    std::map<std::string, std::int64_t> seen;
    std::set<std::string> incomplete;
    for (const auto& cell : cells) {
        ++seen[cell.observer];
        design.missing += shortfall(cell.matrix, expected);
        if (expected == 0 || cell.matrix.complete() != expected)
            incomplete.insert(cell.observer);
    }
    for (const auto& [observer, scenes] : seen) {
        design.missing += (design.scenes - scenes) * pairs * expected;
        if (scenes != design.scenes)
            incomplete.insert(observer);
    }
    for (const auto& observer : table.observers.names())
        if (incomplete.contains(observer))
            design.incomplete_observers.push_back(observer);
    design.complete = incomplete.empty();
}

// Codes of one kept factor and how many levels it has among the observers kept.
struct Axis {
    std::string name;
    const std::vector<std::uint32_t>* codes;
    std::size_t levels;
};

std::vector<Axis> axes(const VoteTable& table, const Scope& scope) {
    std::vector<Axis> kept;
    if (scope.session)
        kept.push_back({"session", &table.session, table.sessions.size()});
    for (std::size_t f = 0; f < table.factors.size(); ++f)
        if (f < scope.factors.size() && scope.factors[f])
            kept.push_back({table.factor_names[f], &table.factor[f], table.factors[f].size()});
    return kept;
}

} // namespace

DesignFacts design_facts(const VoteTable& table) {
    DesignFacts design;
    design.study = table.study;
    design.simulated = table.simulated;
    design.conditions = table.conditions.names();
    design.observers = table.observers.names();
    design.sessions = table.sessions.names();
    design.factor_names = table.factor_names;
    for (const auto& levels : table.factors)
        design.factors.push_back(levels.names());
    const std::vector<bool> every(table.factors.size(), true);
    design.scenes = static_cast<std::int64_t>(count_votes(table, {false, false, every}).size());
    design.rounds = static_cast<std::int64_t>(count_votes(table, {true, true, every}).size());
    design.votes = static_cast<std::int64_t>(table.size());
    design.ties = std::count(table.chosen.begin(), table.chosen.end(), protocols::Choice::Tie);
    design.skipped_not_main = table.skipped_not_main;
    completeness(design, table);
    return design;
}

std::vector<std::uint32_t> complete_observers(const VoteTable& table, const DesignFacts& design) {
    std::vector<std::uint32_t> kept;
    for (std::uint32_t o = 0; o < table.observers.size(); ++o)
        if (std::find(design.incomplete_observers.begin(), design.incomplete_observers.end(),
                      table.observers.name(o)) == design.incomplete_observers.end())
            kept.push_back(o);
    return kept;
}

std::optional<ScoreCells>
score_cells(const VoteTable& table, const std::vector<std::uint32_t>& observers, Scope scope) {
    const auto kept = axes(table, scope);
    const auto t = table.conditions.size();
    std::size_t per_observer = 1;
    ScoreCells cells{observers, {}, {}, 0};
    for (const auto& axis : kept) {
        cells.factors.push_back({axis.name, axis.levels});
        per_observer *= axis.levels;
    }
    cells.factors.push_back({"method", t});
    if (observers.empty() || t < 2 || observers.size() * per_observer > table.size())
        return std::nullopt; // fewer votes than cells: some are empty
    std::vector<std::int64_t> place(table.observers.size(), -1);
    for (std::size_t i = 0; i < observers.size(); ++i)
        place[observers[i]] = static_cast<std::int64_t>(i);
    std::vector<VoteMatrix> matrices(observers.size() * per_observer, VoteMatrix(t));
    for (std::size_t vote = 0; vote < table.size(); ++vote) {
        if (place[table.observer[vote]] < 0)
            continue;
        auto cell = static_cast<std::size_t>(place[table.observer[vote]]);
        for (const auto& axis : kept)
            cell = cell * axis.levels + (*axis.codes)[vote];
        matrices[cell].add(table.left[vote], table.right[vote], table.chosen[vote]);
    }
    const auto m = matrices[0].complete();
    for (const auto& matrix : matrices) {
        if (m == 0 || matrix.complete() != m)
            return std::nullopt;
        for (std::size_t a = 0; a < t; ++a)
            cells.half_votes.push_back(matrix.half_votes(a));
    }
    cells.divisor = 2 * m;
    return cells;
}

} // namespace analysis
