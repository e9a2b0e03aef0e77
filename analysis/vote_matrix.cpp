#include "analysis/vote_matrix.h"

#include "protocols/contract.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace analysis {

VoteMatrix::VoteMatrix(std::size_t conditions)
    : conditions_(conditions), left_chosen_(conditions * conditions),
      right_chosen_(conditions * conditions) {}

void VoteMatrix::add(std::size_t left,
                     std::size_t right,
                     protocols::Choice chosen,
                     std::int64_t votes) {
    EXPECTS(left < conditions_ && right < conditions_ && left != right);
    if (chosen == protocols::Choice::Tie)
        tied_.resize(conditions_ * conditions_);
    auto& counts = chosen == protocols::Choice::Left    ? left_chosen_
                   : chosen == protocols::Choice::Right ? right_chosen_
                                                        : tied_;
    counts[at(left, right)] += votes;
}

void VoteMatrix::add(const VoteMatrix& other) {
    EXPECTS(other.conditions_ == conditions_);
    tied_.resize(std::max(tied_.size(), other.tied_.size()));
    for (std::size_t k = 0; k < left_chosen_.size(); ++k) {
        left_chosen_[k] += other.left_chosen_[k];
        right_chosen_[k] += other.right_chosen_[k];
    }
    for (std::size_t k = 0; k < other.tied_.size(); ++k)
        tied_[k] += other.tied_[k];
}

std::int64_t VoteMatrix::left_chosen(std::size_t left, std::size_t right) const {
    return left_chosen_[at(left, right)];
}

std::int64_t VoteMatrix::right_chosen(std::size_t left, std::size_t right) const {
    return right_chosen_[at(left, right)];
}

std::int64_t VoteMatrix::tied(std::size_t left, std::size_t right) const {
    return tied_.empty() ? 0 : tied_[at(left, right)];
}

std::int64_t VoteMatrix::wins(std::size_t winner, std::size_t loser) const {
    return left_chosen_[at(winner, loser)] + right_chosen_[at(loser, winner)];
}

std::int64_t VoteMatrix::ties(std::size_t a, std::size_t b) const {
    return tied(a, b) + tied(b, a);
}

std::int64_t VoteMatrix::comparisons(std::size_t a, std::size_t b) const {
    return wins(a, b) + wins(b, a) + ties(a, b);
}

std::int64_t VoteMatrix::half_votes(std::size_t condition) const {
    std::int64_t sum = 0;
    for (std::size_t other = 0; other < conditions_; ++other)
        if (other != condition)
            sum += 2 * wins(condition, other) + ties(condition, other);
    return sum;
}

std::int64_t VoteMatrix::comparisons(std::size_t condition) const {
    std::int64_t sum = 0;
    for (std::size_t other = 0; other < conditions_; ++other)
        if (other != condition)
            sum += comparisons(condition, other);
    return sum;
}

std::int64_t VoteMatrix::total_comparisons() const {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < conditions_; ++i)
        sum += comparisons(i);
    return sum / 2;
}

std::int64_t VoteMatrix::total_ties() const {
    std::int64_t sum = 0;
    for (const auto count : tied_)
        sum += count;
    return sum;
}

std::int64_t VoteMatrix::complete() const {
    if (conditions_ < 2)
        return 0;
    const auto m = comparisons(0, 1);
    for (std::size_t i = 0; i < conditions_; ++i)
        for (std::size_t j = i + 1; j < conditions_; ++j)
            if (comparisons(i, j) != m)
                return 0;
    return m;
}

namespace {

bool keeps(const Scope& scope, std::size_t factor) {
    return factor < scope.factors.size() && scope.factors[factor];
}

// "session 2" before "session 10": runs of digits compare as numbers.
bool natural_less(const std::string& a, const std::string& b) {
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (!digit(a[i]) || !digit(b[j])) {
            if (a[i] != b[j])
                return a[i] < b[j];
            ++i, ++j;
            continue;
        }
        const auto run = [&](const std::string& text, std::size_t& at) {
            while (at < text.size() && text[at] == '0')
                ++at;
            const auto begin = at;
            while (at < text.size() && digit(text[at]))
                ++at;
            return std::string_view(text).substr(begin, at - begin);
        };
        const auto left = run(a, i), right = run(b, j);
        if (left.size() != right.size())
            return left.size() < right.size();
        if (left != right)
            return left < right;
    }
    if (a.size() - i != b.size() - j)
        return a.size() - i < b.size() - j;
    return a < b;
}

// Place of each code when the names are sorted.
std::vector<std::uint32_t> natural_places(const Dictionary& names) {
    std::vector<std::uint32_t> order(names.size()), places(names.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(),
              [&](auto a, auto b) { return natural_less(names.name(a), names.name(b)); });
    for (std::uint32_t i = 0; i < order.size(); ++i)
        places[order[i]] = i;
    return places;
}

// One kept column: its codes, its dictionary, and where each code sorts.
struct KeptColumn {
    const std::vector<std::uint32_t>* codes;
    const Dictionary* names;
    std::vector<std::uint32_t> places;
};

std::vector<KeptColumn> kept_columns(const VoteTable& table, const Scope& scope) {
    std::vector<KeptColumn> kept;
    if (scope.observer)
        kept.push_back({&table.observer, &table.observers, natural_places(table.observers)});
    if (scope.session)
        kept.push_back({&table.session, &table.sessions, natural_places(table.sessions)});
    for (std::size_t f = 0; f < table.factors.size(); ++f)
        if (keeps(scope, f))
            kept.push_back({&table.factor[f], &table.factors[f], natural_places(table.factors[f])});
    return kept;
}

ScopedMatrix labelled(const VoteTable& table,
                      const Scope& scope,
                      const std::vector<KeptColumn>& kept,
                      std::size_t vote) {
    ScopedMatrix cell{scope_name(table, scope),
                      {},
                      {},
                      std::vector<std::string>(table.factors.size()),
                      VoteMatrix(table.conditions.size())};
    std::size_t next = 0;
    const auto level = [&] {
        const auto& column = kept[next++];
        return column.names->name((*column.codes)[vote]);
    };
    if (scope.observer)
        cell.observer = level();
    if (scope.session)
        cell.session = level();
    for (std::size_t f = 0; f < table.factors.size(); ++f)
        if (keeps(scope, f))
            cell.scene[f] = level();
    return cell;
}

// Where the matrix of a cell stands; -1 while there is none.  A plain array where one fits.
class CellIndex {
  public:
    explicit CellIndex(const std::vector<KeptColumn>& kept) {
        double cells = 1;
        for (const auto& column : kept)
            cells *= static_cast<double>(column.names->size());
        if (cells <= 1 << 22)
            array_.assign(static_cast<std::size_t>(cells), -1);
    }

    std::int64_t& place(std::uint64_t cell) {
        return array_.empty() ? map_.try_emplace(cell, -1).first->second : array_[cell];
    }

  private:
    std::vector<std::int64_t> array_;
    std::unordered_map<std::uint64_t, std::int64_t> map_;
};

// Sorted by the places of the kept levels.
std::vector<ScopedMatrix> in_order(std::vector<ScopedMatrix> matrices,
                                   const std::vector<std::uint64_t>& cells) {
    std::vector<std::size_t> order(matrices.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return cells[a] < cells[b]; });
    std::vector<ScopedMatrix> sorted;
    sorted.reserve(matrices.size());
    for (const auto place : order)
        sorted.push_back(std::move(matrices[place]));
    return sorted;
}

} // namespace

std::string scope_name(const VoteTable& table, const Scope& scope) {
    std::vector<std::string> words;
    if (scope.observer)
        words.emplace_back("observer");
    if (scope.session)
        words.emplace_back("session");
    for (std::size_t f = 0; f < table.factors.size(); ++f)
        if (keeps(scope, f))
            words.push_back(table.factor_names[f]);
    std::string name;
    for (const auto& word : words)
        name += (name.empty() ? "" : "*") + word;
    return name.empty() ? "all" : name;
}

std::vector<ScopedMatrix> count_votes(const VoteTable& table, const Scope& scope) {
    const auto kept = kept_columns(table, scope);
    CellIndex index(kept);
    std::vector<ScopedMatrix> matrices;
    std::vector<std::uint64_t> cells; // of each matrix
    for (std::size_t vote = 0; vote < table.size(); ++vote) {
        std::uint64_t cell = 0;
        for (const auto& column : kept)
            cell = cell * column.names->size() + column.places[(*column.codes)[vote]];
        auto& place = index.place(cell);
        if (place < 0) {
            place = static_cast<std::int64_t>(matrices.size());
            matrices.push_back(labelled(table, scope, kept, vote));
            cells.push_back(cell);
        }
        matrices[static_cast<std::size_t>(place)].matrix.add(table.left[vote], table.right[vote],
                                                             table.chosen[vote]);
    }
    return in_order(std::move(matrices), cells);
}

VoteMatrix count_votes(const VoteTable& table) {
    VoteMatrix matrix(table.conditions.size());
    for (std::size_t vote = 0; vote < table.size(); ++vote)
        matrix.add(table.left[vote], table.right[vote], table.chosen[vote]);
    return matrix;
}

std::vector<Scope> usual_scopes(const VoteTable& table) {
    const auto count = table.factors.size();
    std::vector<Scope> scopes{{}, {true, false, {}}, {false, true, {}}};
    for (std::size_t f = 0; f < count; ++f) {
        std::vector<bool> one(count);
        one[f] = true;
        scopes.push_back({false, false, one});
    }
    if (count > 1)
        scopes.push_back({false, false, std::vector<bool>(count, true)});
    scopes.push_back({true, true, {}});
    if (count > 0) {
        std::vector<bool> first(count);
        first[0] = true;
        scopes.push_back({true, false, first});
        scopes.push_back({true, true, std::vector<bool>(count, true)});
    }
    return scopes;
}

} // namespace analysis
