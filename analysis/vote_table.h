// All the votes of a study, as columns of small codes with dictionaries.
#pragma once

#include "protocols/expected.h"
#include "protocols/vocabulary.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace analysis {

using protocols::Expected;

/// Names in order of first appearance; a name's code is its place.
class Dictionary {
  public:
    /// The code of `name`, given now if it is new.
    std::uint32_t code(std::string_view name);

    /// The code of `name`, or -1 when it was never seen.
    std::int64_t find(std::string_view name) const;

    const std::string& name(std::size_t code) const { return names_.at(code); }

    const std::vector<std::string>& names() const { return names_; }

    std::size_t size() const { return names_.size(); }

  private:
    struct Hash {
        using is_transparent = void;

        std::size_t operator()(std::string_view text) const {
            return std::hash<std::string_view>{}(text);
        }
    };

    std::vector<std::string> names_;
    std::unordered_map<std::string, std::uint32_t, Hash, std::equal_to<>> codes_;
    std::uint32_t last_ = 0; ///< votes come in runs of one observer, session, scene
};

/// One vote as the program holds it.  `scene` has one level for every scene factor.
struct VoteRow {
    std::string observer;
    std::string session;
    std::int32_t trial = 0;
    std::vector<std::string> scene;
    std::string left;
    std::string right;
    protocols::Choice chosen{};
    std::int32_t response_ms = -1; ///< -1 when it was not recorded
};

/// Columns have one element per vote.  Scene factors are what a scene is made of: a model and a
/// light, or a scene and a variant.
struct VoteTable {
    std::string study;                 ///< "" when the source does not name one
    bool simulated = false;            ///< at least one vote is a simulated observer's
    std::int64_t skipped_not_main = 0; ///< training and warm-up rows found in the source
    std::vector<std::string> notes;    ///< what the reader did, in plain words
    std::vector<std::string> factor_names;

    Dictionary observers;
    Dictionary sessions;
    Dictionary conditions;
    std::vector<Dictionary> factors; ///< one per scene factor

    std::vector<std::uint32_t> observer;
    std::vector<std::uint32_t> session;
    std::vector<std::vector<std::uint32_t>> factor; ///< [scene factor][vote]
    std::vector<std::uint16_t> left;
    std::vector<std::uint16_t> right;
    std::vector<protocols::Choice> chosen;
    std::vector<std::int32_t> trial;
    std::vector<std::int32_t> response_ms; ///< -1 when it was not recorded

    std::size_t size() const { return observer.size(); }
};

/// An empty table whose scenes are made of these factors, e.g. {"scene", "variant"}.
VoteTable empty_vote_table(std::vector<std::string> factor_names);

/// Memory for as many votes: growing by doubling would need half as much again.
void reserve_votes(VoteTable& table, std::size_t votes);

/// Appends one vote; EXPECTS one level per scene factor.
void append_vote(VoteTable& table, const VoteRow& row);

/// What a table may hold besides one answer per question.
enum class Repeats { Refuse, Allow };

/// A table from rows.  Errors: a condition against itself; the same observer, session, scene and
/// pair asked twice unless repeats are allowed.  Messages count rows from 1.
Expected<VoteTable> vote_table(std::vector<std::string> factor_names,
                               std::span<const VoteRow> rows,
                               Repeats repeats = Repeats::Refuse);

/// The same votes with conditions in this order, which tables, pairs and ties in rank follow (a
/// study lists its conditions in the order its author thinks in).
/// Errors: `order` must name every condition of the table once.
Expected<VoteTable> with_condition_order(VoteTable table, std::span<const std::string> order);

/// A pair of votes on the same observer, session, scene and unordered pair, as row numbers from 0;
/// {-1, -1} when every question was answered once.
std::pair<std::int64_t, std::int64_t> first_repeat(const VoteTable& table);

} // namespace analysis
