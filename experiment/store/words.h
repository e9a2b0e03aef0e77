// How the vocabulary is spelled in stores and tables.
#pragma once

#include "protocols/vocabulary.h"

#include <optional>
#include <string_view>

namespace experiment::store {

std::string_view word_of(protocols::Phase phase);   ///< "training", "warmup", "main"
std::string_view word_of(protocols::Choice choice); ///< "left", "right", "tie"

/// The way back; empty for any other word.
std::optional<protocols::Phase> phase_of(std::string_view word);
std::optional<protocols::Choice> choice_of(std::string_view word);

} // namespace experiment::store
