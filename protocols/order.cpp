// Counting by insertion.  Labels join one after the other; of a sequence it matters only how long
// it is and how many of its gaps lie between equal neighbours.  The n items of the next label go in
// as k runs, l of them into such gaps, which mends those l and makes n - k new ones:
//
//     C(n-1, k-1)  ways to cut n items into k runs
//   x C(bad, l)    ways to choose the gaps that are mended
//   x C(good, k-l) ways to choose the others
//
// Walking back through the table with one uniform number a step undoes the insertions with their
// exact weights.  It costs N c^2 multiplications per label of c items, where deciding place by
// place with the inclusion-exclusion count (tests/protocols/order_test.cpp, its slow twin) costs
// N^2 c S^2; and one table serves every number of equal neighbours.
#include "protocols/order.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <numeric>

namespace protocols {

namespace {

using Number = boost::multiprecision::cpp_int;

/// Pascal's triangle up to row `last`.
class Binomials {
  public:
    explicit Binomials(int last) {
        for (int n = 0; n <= last; ++n) {
            std::vector<Number> row(static_cast<std::size_t>(n) + 1, 1);
            for (std::size_t k = 1; k + 1 < row.size(); ++k)
                row[k] = rows_.back()[k - 1] + rows_.back()[k];
            rows_.push_back(std::move(row));
        }
    }

    const Number& operator()(int n, int k) const {
        return rows_[static_cast<std::size_t>(n)][static_cast<std::size_t>(k)];
    }

  private:
    std::vector<std::vector<Number>> rows_;
};

/// How one label joins a sequence that has `bad` equal neighbours.
struct Insertion {
    int bad = 0;    ///< equal neighbours before it
    int runs = 0;   ///< runs its items form
    int mended = 0; ///< runs that part equal neighbours
};

/// A label about to join.
struct Step {
    int label = 0;
    int items = 0;
    int length = 0; ///< items already in the sequence
    int gaps = 0;   ///< places where a run may go
};

/// The number of sequences by equal neighbours, after each label has joined.
class InsertionTable {
  public:
    InsertionTable(std::span<const int> counts, int equal_neighbours, std::optional<int> after)
        : beginning_(after ? static_cast<std::size_t>(counts[index(*after)]) + 1 : 0,
                     after.value_or(0)),
          equal_neighbours_(equal_neighbours),
          binomials_(std::accumulate(counts.begin(), counts.end(), 2)) {
        int length = static_cast<int>(beginning_.size());
        for (int label = 0; label < static_cast<int>(counts.size()); ++label)
            if (const auto items = counts[index(label)]; items > 0 && label != after) {
                // What was shown before stays first: nothing joins in front of it.
                steps_.push_back({label, items, length, after ? length : length + 1});
                length += items;
            }
        fill(length);
    }

    const Number& total() const { return ways_.back()[index(equal_neighbours_)]; }

    std::vector<int> draw(Rng& rng) const {
        std::vector<Insertion> insertions(steps_.size());
        int bad = equal_neighbours_;
        for (auto i = steps_.size(); i-- > 0;) {
            insertions[i] = draw_insertion(i, bad, rng);
            bad = insertions[i].bad;
        }
        auto sequence = beginning_;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            sequence = insert(sequence, steps_[i], insertions[i], rng);
        return sequence;
    }

  private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }

    void fill(int length) {
        ways_.assign(steps_.size() + 1,
                     std::vector<Number>(index(length + equal_neighbours_ + 1), 0));
        ways_.front()[beginning_.empty() ? 0 : beginning_.size() - 1] = 1;
        for (std::size_t i = 0; i < steps_.size(); ++i)
            for_each_insertion(i, [&](const Insertion& insertion, int bad_after) {
                ways_[i + 1][index(bad_after)] += ways(i, insertion);
            });
    }

    /// Every possible insertion of step `i`, always in the same order.
    template <class Visit>
    void for_each_insertion(std::size_t i, Visit visit) const {
        const auto& step = steps_[i];
        for (int bad = 0; bad <= step.length; ++bad) {
            if (ways_[i][index(bad)] == 0)
                continue;
            const int good = step.gaps - bad;
            for (int runs = 1; runs <= step.items; ++runs)
                for (int mended = std::max(0, runs - good); mended <= std::min(runs, bad); ++mended)
                    visit(Insertion{bad, runs, mended}, bad - mended + step.items - runs);
        }
    }

    Number ways(std::size_t i, const Insertion& insertion) const {
        const auto& step = steps_[i];
        return ways_[i][index(insertion.bad)] * binomials_(step.items - 1, insertion.runs - 1) *
               binomials_(insertion.bad, insertion.mended) *
               binomials_(step.gaps - insertion.bad, insertion.runs - insertion.mended);
    }

    Insertion draw_insertion(std::size_t i, int bad_after, Rng& rng) const {
        auto rest = draw_wide_below(rng, ways_[i + 1][index(bad_after)]);
        std::optional<Insertion> drawn;
        for_each_insertion(i, [&](const Insertion& insertion, int bad) {
            if (drawn || bad != bad_after)
                return;
            const auto share = ways(i, insertion);
            if (rest < share)
                drawn = insertion;
            else
                rest -= share;
        });
        EXPECTS(drawn.has_value());
        return *drawn;
    }

    /// `chosen` of the numbers, all choices equally likely, in their order.
    static std::vector<int> choose(std::vector<int> numbers, int chosen, Rng& rng) {
        shuffle(std::span(numbers), rng);
        numbers.resize(index(chosen));
        std::sort(numbers.begin(), numbers.end());
        return numbers;
    }

    /// Lengths of `runs` runs that make `items` together: the cuts are a choice among items - 1.
    static std::vector<int> draw_run_lengths(int items, int runs, Rng& rng) {
        std::vector<int> cuts(index(items) - 1);
        std::iota(cuts.begin(), cuts.end(), 1);
        cuts = choose(std::move(cuts), runs - 1, rng);
        cuts.push_back(items);
        std::adjacent_difference(cuts.begin(), cuts.end(), cuts.begin());
        return cuts;
    }

    static std::vector<int>
    insert(const std::vector<int>& sequence, const Step& step, const Insertion& how, Rng& rng) {
        const auto length = static_cast<int>(sequence.size());
        std::vector<int> bad, good; // gap i lies before item i
        for (int gap = length + 1 - step.gaps; gap <= length; ++gap) {
            const auto i = index(gap);
            const bool equal = gap > 0 && gap < length && sequence[i - 1] == sequence[i];
            (equal ? bad : good).push_back(gap);
        }
        auto gaps = choose(std::move(bad), how.mended, rng);
        for (const auto gap : choose(std::move(good), how.runs - how.mended, rng))
            gaps.push_back(gap);
        std::sort(gaps.begin(), gaps.end());
        const auto lengths = draw_run_lengths(step.items, how.runs, rng);

        std::vector<int> longer;
        std::size_t run = 0;
        for (int gap = 0; gap <= length; ++gap) {
            if (run < gaps.size() && gaps[run] == gap)
                longer.insert(longer.end(), index(lengths[run++]), step.label);
            if (gap < length)
                longer.push_back(sequence[index(gap)]);
        }
        return longer;
    }

    std::vector<int> beginning_; ///< what was shown before, and all of its label
    int equal_neighbours_;
    Binomials binomials_;
    std::vector<Step> steps_;
    std::vector<std::vector<Number>> ways_; ///< [steps done][equal neighbours]
};

void expect_labels(std::span<const int> counts, std::optional<int> after) {
    EXPECTS(std::all_of(counts.begin(), counts.end(), [](int count) { return count >= 0; }));
    EXPECTS(!after || (*after >= 0 && *after < static_cast<int>(counts.size())));
}

} // namespace

std::string
count_sequences(std::span<const int> counts, int equal_neighbours, std::optional<int> after) {
    expect_labels(counts, after);
    EXPECTS(equal_neighbours >= 0);
    return InsertionTable(counts, equal_neighbours, after).total().str();
}

int least_equal_neighbours(std::span<const int> counts, std::optional<int> after) {
    expect_labels(counts, after);
    const int items = std::accumulate(counts.begin(), counts.end(), 0);
    int least = 0;
    for (int label = 0; label < static_cast<int>(counts.size()); ++label) {
        // The other items part this label's into at most (others + 1) runs, or as many as there are
        // others where the first run would follow its own label.
        const int count = counts[static_cast<std::size_t>(label)];
        const int runs = items - count + (label == after ? 0 : 1);
        least = std::max(least, count - runs);
    }
    return least;
}

std::vector<int> draw_sequence(std::span<const int> counts, Rng& rng, std::optional<int> after) {
    const int least = least_equal_neighbours(counts, after);
    auto sequence = InsertionTable(counts, least, after).draw(rng);
    if (after)
        sequence.erase(sequence.begin());
    return sequence;
}

} // namespace protocols
