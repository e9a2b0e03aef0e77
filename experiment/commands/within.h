// What values of options have to be.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace CLI {
class Validator;
}

namespace experiment::commands {

/// A number of the range; both ends belong to it and, unlike in CLI11's own, NaN does not.
CLI::Validator within(double least, double most);

/// One of `words`; to whoever misspells one, the nearest is offered.
CLI::Validator one_of(const std::vector<std::string>& words);

/// One of the words; what it stands for takes its place.
CLI::Validator word_for(const std::map<std::string, int>& numbers);

/// Words for an enumeration's values, as `word_for` takes them.
template <class Enumeration>
std::map<std::string, int> numbered(const std::map<std::string, Enumeration>& words) {
    std::map<std::string, int> numbers;
    for (const auto& [word, value] : words)
        numbers[word] = static_cast<int>(value);
    return numbers;
}

/// A folder, or what the names of several files begin with: "-" is standard output, which is
/// neither.
CLI::Validator not_standard_output();

/// Something other than blanks: "expected <wanted>".
CLI::Validator not_blank(const char* wanted);

} // namespace experiment::commands
