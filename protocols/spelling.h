// What a person probably meant by a word we do not know.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace protocols {

/// The name that needs the fewest insertions, deletions and replacements of a letter to become
/// `word`; none where even that one needs more than about a third of the word's letters.
std::optional<std::string> nearest_name(std::string_view word, std::span<const std::string> names);

} // namespace protocols
