// The scores an analysis of variance works on: votes of every observer for every condition, in
// every cell of chosen factors, from observers who answered everything.
#pragma once

#include "analysis/findings.h"
#include "analysis/vote_table.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace analysis {

/// What was asked and what is missing.
DesignFacts design_facts(const VoteTable& table);

/// Observers (codes) who compared every pair equally often in every scene.
std::vector<std::uint32_t> complete_observers(const VoteTable& table, const DesignFacts& design);

struct ScoreCells {
    std::vector<std::uint32_t> observers; ///< codes, in order
    std::vector<anova::Factor> factors;   ///< kept factors, then "method"
    std::vector<std::int64_t> half_votes; ///< observers x factors x conditions
    std::int64_t divisor = 0;             ///< half votes that make one vote per round: 2 m
};

/// Cells of `scope` (its observer flag is taken as set) for `observers`; nothing unless every
/// combination of the kept levels is there, with every pair equally often.
std::optional<ScoreCells>
score_cells(const VoteTable& table, const std::vector<std::uint32_t>& observers, Scope scope);

} // namespace analysis
