#include "analysis/consistency/repeatability.h"

#include "analysis/exact.h"
#include "analysis/numerics/distributions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace analysis::consistency {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

// A sitting's answers: question (scene and unordered pair) to the chosen condition, -1 for a tie.
using Answers = std::unordered_map<std::uint64_t, std::int32_t>;

std::uint64_t question(const VoteTable& table, std::size_t vote) {
    std::uint64_t code = 0;
    for (std::size_t f = 0; f < table.factor.size(); ++f)
        code = code * table.factors[f].size() + table.factor[f][vote];
    const auto [low, high] = std::minmax(table.left[vote], table.right[vote]);
    return (code * table.conditions.size() + low) * table.conditions.size() + high;
}

std::int32_t chosen(const VoteTable& table, std::size_t vote) {
    if (table.chosen[vote] == protocols::Choice::Tie)
        return -1;
    return table.chosen[vote] == protocols::Choice::Left ? table.left[vote] : table.right[vote];
}

struct Tally {
    std::int64_t same = 0;
    std::int64_t both = 0;

    double share() const { return both > 0 ? to_double({same, both}) : undefined; }
};

void compare(Tally& tally, const Answers& one, const Answers& other) {
    for (const auto& [key, answer] : one)
        if (const auto found = other.find(key); found != other.end()) {
            ++tally.both;
            tally.same += found->second == answer ? 1 : 0;
        }
}

// Mean of the values that are numbers.
class Mean {
  public:
    void add(double value) {
        if (!std::isnan(value)) {
            sum_ += value;
            ++count_;
        }
    }

    double value() const { return count_ > 0 ? sum_ / count_ : undefined; }

  private:
    double sum_ = 0;
    double count_ = 0;
};

using Sittings = std::vector<std::vector<Answers>>; // [observer][session]

ObserverRepeatability
within_observer(const VoteTable& table, const Sittings& sittings, std::size_t o) {
    ObserverRepeatability result{table.observers.name(o), {}, undefined, undefined};
    Mean mean;
    for (std::size_t s = 0; s < table.sessions.size(); ++s)
        for (std::size_t r = s + 1; r < table.sessions.size(); ++r) {
            Tally tally;
            compare(tally, sittings[o][s], sittings[o][r]);
            mean.add(tally.share());
            result.sessions.push_back(
                {table.sessions.name(s), table.sessions.name(r), tally.share()});
        }
    result.mean = mean.value();
    result.chance_corrected = 2 * result.mean - 1;
    return result;
}

} // namespace

Repeatability repeatability(const VoteTable& table) {
    Sittings sittings(table.observers.size(), std::vector<Answers>(table.sessions.size()));
    for (std::size_t vote = 0; vote < table.size(); ++vote)
        sittings[table.observer[vote]][table.session[vote]].try_emplace(question(table, vote),
                                                                        chosen(table, vote));
    Repeatability result;
    Mean within, between;
    for (std::size_t o = 0; o < sittings.size(); ++o) {
        result.within.push_back(within_observer(table, sittings, o));
        within.add(result.within.back().mean);
        for (std::size_t other = o + 1; other < sittings.size(); ++other) {
            Tally tally;
            for (std::size_t s = 0; s < table.sessions.size(); ++s)
                compare(tally, sittings[o][s], sittings[other][s]);
            result.between.push_back(
                {table.observers.name(o), table.observers.name(other), tally.share()});
            between.add(tally.share());
        }
    }
    result.within_mean = within.value();
    result.between_mean = between.value();
    return result;
}

SideBias side_bias(std::int64_t left, std::int64_t answers) {
    SideBias bias{left, answers, undefined, undefined};
    if (answers == 0)
        return bias;
    const auto n = static_cast<double>(answers);
    const auto most = static_cast<double>(std::max(left, answers - left));
    bias.z = static_cast<double>(2 * left - answers) / std::sqrt(n);
    // P(X >= x) for X binomial (n, 1/2) is an incomplete beta, hence a tail of F.
    const double tail =
        numerics::f_upper_tail(most / (n - most + 1), 2 * (n - most + 1), 2 * most).p;
    bias.p = std::min(1.0, 2 * tail);
    return bias;
}

SideBias side_bias(const VoteTable& table) {
    const auto left = std::count(table.chosen.begin(), table.chosen.end(), protocols::Choice::Left);
    const auto right =
        std::count(table.chosen.begin(), table.chosen.end(), protocols::Choice::Right);
    return side_bias(left, left + right);
}

} // namespace analysis::consistency
