// Strict reading of one table of a file: every key is asked for by name and type, and what nobody
// asked for must not be there.
#pragma once

#include "protocols/document.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace protocols {

/// What is wrong with a file; the offence nearest to its beginning is the one to be told.
class Problems {
  public:
    explicit Problems(std::string_view file) : file_(file) {}

    void note(int line, std::string_view what);

    const std::optional<std::string>& first() const { return first_; }

  private:
    std::string file_;
    int line_ = 0;
    std::optional<std::string> first_;
};

/// Both ends belong to it; NaN does not.
template <class Number>
struct Range {
    Number low, high;

    bool has(Number value) const { return value >= low && value <= high; }
};

/// A table being read.  A reader that is disappointed notes it in `problems` and answers with a
/// value that nobody will see; one without a fallback also wants its key to be there.
class Section {
  public:
    /// `name` as it stands in the file, such as "[study]".  Both references must outlive this.
    Section(const Table& table, int line, std::string name, Problems& problems);

    int line() const { return line_; }

    /// Whether the key is there; it may be, from now on.
    bool has(std::string_view key);

    /// One line of text, not empty.
    std::string text(std::string_view key, const std::optional<std::string>& fallback = {});

    /// Text that is one of the names.
    std::string one_of(std::string_view key,
                       const std::vector<std::string>& names,
                       const std::optional<std::string>& fallback = {});

    /// A list of texts, each on one line and not empty; at least one.
    std::vector<std::string> several(std::string_view key);

    /// A list of texts that are among the names.
    std::vector<std::string> several_of(std::string_view key,
                                        const std::vector<std::string>& names);

    /// The text under "id": a name that can also be that of a file, anywhere.
    std::string id();

    std::int64_t whole(std::string_view key, Range<std::int64_t> range);

    /// Replaces `value`, its own fallback, if the key is there.
    void whole(std::string_view key, Range<int> range, int& value);
    void number(std::string_view key, Range<double> range, double& value);

    /// Three numbers, one for each colour channel, or one number for all.
    std::array<double, 3> rgb(std::string_view key, Range<double> range);

    /// Three numbers of any length in the file, a unit vector ever after.
    std::array<double, 3> direction(std::string_view key,
                                    std::optional<std::array<double, 3>> fallback = {});

    /// Three numbers within the range.
    std::array<double, 3>
    triple(std::string_view key, Range<double> range, std::array<double, 3> fallback);

    /// Every entry that nobody asked for so far; now all have been.
    std::vector<Entry> rest();

    /// The table [key]: empty where it is missing and need not be there.
    Section table(std::string_view key, bool required);

    /// All tables [[key]].
    std::vector<Section> tables(std::string_view key);

    /// Notes every key that was not asked for.
    void expect_nothing_else() const;

    /// Notes that the value of `key` is not what it should be.
    void refuse(std::string_view key, std::string_view wanted) const;

    /// Notes something else, at the line of `key`, or of the section where it has no such key.
    void note(std::string_view key, std::string_view what) const;

  private:
    const Entry* entry(std::string_view key) const;
    const Node* find(std::string_view key, std::string_view wanted, bool optional);
    void note_missing(std::string_view key, std::string_view wanted) const;

    const Table* table_;
    int line_;
    std::string name_;
    Problems* problems_;
    std::vector<std::string> asked_;
};

} // namespace protocols
