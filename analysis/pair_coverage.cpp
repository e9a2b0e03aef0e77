#include "analysis/pair_coverage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace analysis {

namespace {

constexpr std::int64_t few_comparisons = 5;

using Pair = std::pair<std::size_t, std::size_t>;

// Tarjan's bridges: an edge is one when nothing below it reaches above it otherwise.
class Bridges {
  public:
    explicit Bridges(const VoteMatrix& matrix)
        : matrix_(matrix), entered_(matrix.conditions(), 0), reaches_(matrix.conditions(), 0) {
        for (std::size_t i = 0; i < matrix.conditions(); ++i)
            if (entered_[i] == 0)
                visit(i, i);
    }

    std::vector<Pair> found() && { return std::move(found_); }

  private:
    void visit(std::size_t at, std::size_t from) {
        entered_[at] = reaches_[at] = ++clock_;
        for (std::size_t to = 0; to < matrix_.conditions(); ++to) {
            if (to == at || to == from || matrix_.comparisons(at, to) == 0)
                continue;
            if (entered_[to] == 0) {
                visit(to, at);
                if (reaches_[to] > entered_[at])
                    found_.push_back(std::minmax(at, to));
                reaches_[at] = std::min(reaches_[at], reaches_[to]);
            } else {
                reaches_[at] = std::min(reaches_[at], entered_[to]);
            }
        }
    }

    const VoteMatrix& matrix_;
    std::vector<std::size_t> entered_, reaches_;
    std::size_t clock_ = 0;
    std::vector<Pair> found_;
};

} // namespace

PairCoverage pair_coverage(const VoteMatrix& matrix) {
    PairCoverage coverage;
    const auto t = matrix.conditions();
    for (std::size_t i = 0; i < t; ++i)
        for (std::size_t j = i + 1; j < t; ++j) {
            ++coverage.pairs;
            const auto comparisons = matrix.comparisons(i, j);
            if (comparisons == 0)
                continue;
            if (coverage.compared++ == 0 || comparisons < coverage.fewest) {
                coverage.fewest = comparisons;
                coverage.rarest = {i, j};
            }
            coverage.most = std::max(coverage.most, comparisons);
        }
    if (t > 2) // two conditions have one pair, which cannot but be needed
        coverage.bridges = Bridges(matrix).found();
    return coverage;
}

std::vector<std::string> coverage_notes(const PairCoverage& coverage,
                                        const std::vector<std::string>& conditions) {
    std::vector<std::string> notes;
    const auto named = [&](const Pair& pair) {
        return fmt::format("{} with {}", conditions[pair.first], conditions[pair.second]);
    };
    if (coverage.compared < coverage.pairs)
        notes.push_back(fmt::format("{} of {} pairs of conditions were compared at least once.",
                                    coverage.compared, coverage.pairs));
    if (coverage.fewest != coverage.most)
        notes.push_back(fmt::format("Pairs were compared between {} and {} times: shares depend on "
                                    "which opponents were met, scales do not.",
                                    coverage.fewest, coverage.most));
    if (coverage.compared > 0 && coverage.fewest < few_comparisons)
        notes.push_back(fmt::format("Few comparisons: {} only {} times.", named(coverage.rarest),
                                    coverage.fewest));
    std::vector<std::string> bridges;
    for (const auto& pair : coverage.bridges)
        bridges.push_back(named(pair));
    if (!bridges.empty())
        notes.push_back(fmt::format("The scale hangs on single pairs, without which conditions "
                                    "would fall apart in two groups: {}.",
                                    fmt::join(bridges, "; ")));
    return notes;
}

} // namespace analysis
