// A method's settings by their names in a study file: what they may be, and what they are when
// nobody says.
#pragma once

#include "renderer/expected.h"

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace renderer::methods {

using DialValue = std::variant<std::int64_t, double, std::string>;
using Dials = std::map<std::string, DialValue, std::less<>>;

/// Both ends belong to it; NaN does not.
template <class Number>
struct DialRange {
    Number least, most;
};

/// A value is right when it is a whole number within `whole`, any number within `number`, or one of
/// `names`.
struct Dial {
    std::string name;
    std::string meaning; ///< a line for people
    DialValue preset;
    std::optional<DialRange<std::int64_t>> whole = {};
    std::optional<DialRange<double>> number = {};
    std::vector<std::string> names = {};
};

/// Some values of a dial, as those worth measuring.
struct DialSteps {
    std::string dial;
    std::vector<DialValue> values;
};

/// Settings that differ in one dial each: every value of every step in turn, together with
/// `throughout`.
std::vector<Dials> one_at_a_time(const std::vector<DialSteps>& steps, const Dials& throughout = {});

/// What a dial is set to that it cannot be: "bands" and "is 9, expected 1..6".
struct DialProblem {
    std::string dial;
    std::string what;
};

/// The dials as they are, presets in the place of what was not given.
/// Errors: the first value that its dial cannot take, or that has no dial.
tl::expected<Dials, DialProblem> complete(const std::vector<Dial>& dials, Dials given);

/// A value as people write it.
std::string text_of(const DialValue& value);

/// The value of a dial that is there and of that kind.  Errors: EXPECTS it is.
std::int64_t whole_in(const Dials& dials, std::string_view name);
double number_in(const Dials& dials, std::string_view name);
std::string name_in(const Dials& dials, std::string_view name);

/// Whether a dial that takes numbers as well as names is set to a name.
bool is_name(const Dials& dials, std::string_view name);

} // namespace renderer::methods
