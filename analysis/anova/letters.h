// Compact letters: two conditions share a letter exactly when they do not differ significantly.
// Insert and absorb.  [Piepho2004]
#pragma once

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace analysis::anova {

/// Letter columns grow exponentially in the worst case; beyond this many, list the pairs instead.
inline constexpr std::size_t letter_column_limit = 10'000;

/// Letters of `ranked.size()` items.  `ranked` lists the items best first; `significant` the pairs
/// that differ.  Column a holds the best item.  Nothing when more than `letter_column_limit`
/// columns would be needed.
std::optional<std::vector<std::string>>
compact_letters(std::span<const std::size_t> ranked,
                std::span<const std::pair<std::size_t, std::size_t>> significant);

/// The same with the largest mean best; empty when too many columns would be needed.
std::vector<std::string>
letters_by_means(std::span<const double> means,
                 std::span<const std::pair<std::size_t, std::size_t>> significant);

/// "a".."z", "aa", "ab", ...
std::string letter(std::size_t column);

} // namespace analysis::anova
