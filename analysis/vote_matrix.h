// Who beat whom how often, as 64-bit counts, for any part of a study.
#pragma once

#include "analysis/exact.h"
#include "analysis/vote_table.h"

#include <cstdint>
#include <string>
#include <vector>

namespace analysis {

/// Counts of every ordered pair (left, right) of t conditions, row-major t x t.
/// Convention: (i, j) is "i shown left, j shown right".
class VoteMatrix {
  public:
    explicit VoteMatrix(std::size_t conditions = 0);

    std::size_t conditions() const { return conditions_; }

    void add(std::size_t left, std::size_t right, protocols::Choice chosen, std::int64_t votes = 1);
    void add(const VoteMatrix& other);

    std::int64_t left_chosen(std::size_t left, std::size_t right) const;
    std::int64_t right_chosen(std::size_t left, std::size_t right) const;
    std::int64_t tied(std::size_t left, std::size_t right) const;

    /// Votes for `winner` over `loser`, from either side.
    std::int64_t wins(std::size_t winner, std::size_t loser) const;
    /// Ties between the two, from either side.
    std::int64_t ties(std::size_t a, std::size_t b) const;
    /// How often the two were compared.
    std::int64_t comparisons(std::size_t a, std::size_t b) const;

    /// Twice the votes of `condition`: a win counts 2, a tie 1, so that halves stay integers.
    std::int64_t half_votes(std::size_t condition) const;
    /// Comparisons that `condition` took part in.
    std::int64_t comparisons(std::size_t condition) const;

    std::int64_t total_comparisons() const;
    std::int64_t total_ties() const;

    /// m when every pair was compared the same m > 0 times, else 0.
    std::int64_t complete() const;

  private:
    std::size_t at(std::size_t i, std::size_t j) const { return i * conditions_ + j; }

    std::size_t conditions_;
    std::vector<std::int64_t> left_chosen_, right_chosen_;
    std::vector<std::int64_t> tied_; ///< empty before the first tie: a study may have none
};

/// Which columns a scope keeps apart; everything else is pooled.
struct Scope {
    bool observer = false;
    bool session = false;
    std::vector<bool> factors; ///< one per scene factor; shorter means false
};

/// The matrix of one level of a scope; "" where the scope pools.
struct ScopedMatrix {
    std::string scope; ///< "all", "observer", "model*light", ...
    std::string observer;
    std::string session;
    std::vector<std::string> scene; ///< one element per scene factor
    VoteMatrix matrix;
};

/// "all", or the kept columns joined by '*'.
std::string scope_name(const VoteTable& table, const Scope& scope);

/// One matrix for every combination of kept levels that has votes, sorted by level names in
/// natural order (session 2 before 10).  One pass over the votes.
std::vector<ScopedMatrix> count_votes(const VoteTable& table, const Scope& scope);

/// Everything pooled.
VoteMatrix count_votes(const VoteTable& table);

/// The scopes a report keeps: all, observer, session, each scene factor, the scene,
/// observer*session, observer*first factor, and every round.
std::vector<Scope> usual_scopes(const VoteTable& table);

} // namespace analysis
