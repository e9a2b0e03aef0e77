// Words that spell a number, in decimal digits as people write it: a leading zero changes nothing,
// and no prefix or suffix means another base.
#pragma once

#include <optional>
#include <string_view>

namespace experiment::commands {

/// The number, of the types int, std::uint64_t and double; nothing where the word spells none, or
/// one that the type does not hold.
template <class Number>
std::optional<Number> number_in(std::string_view word);

/// Whether the word is digits alone, after a sign or without.
bool spells_whole_number(std::string_view word);

} // namespace experiment::commands
