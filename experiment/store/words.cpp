// Enumerators to words and back.
#include "experiment/store/words.h"

namespace experiment::store {

using protocols::Choice;
using protocols::Phase;

std::string_view word_of(Phase phase) {
    switch (phase) {
    case Phase::Training:
        return "training";
    case Phase::WarmUp:
        return "warmup";
    case Phase::Main:
        return "main";
    }
    return {};
}

std::string_view word_of(Choice choice) {
    switch (choice) {
    case Choice::Left:
        return "left";
    case Choice::Right:
        return "right";
    case Choice::Tie:
        return "tie";
    }
    return {};
}

std::optional<Phase> phase_of(std::string_view word) {
    for (const auto phase : {Phase::Training, Phase::WarmUp, Phase::Main})
        if (word == word_of(phase))
            return phase;
    return std::nullopt;
}

std::optional<Choice> choice_of(std::string_view word) {
    for (const auto choice : {Choice::Left, Choice::Right, Choice::Tie})
        if (word == word_of(choice))
            return choice;
    return std::nullopt;
}

} // namespace experiment::store
