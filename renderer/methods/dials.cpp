// Checking and reading dials.
#include "renderer/methods/dials.h"

#include "renderer/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace renderer::methods {

namespace {

bool fits(const Dial& dial, const DialValue& value) {
    if (const auto* name = std::get_if<std::string>(&value))
        return std::find(dial.names.begin(), dial.names.end(), *name) != dial.names.end();
    if (const auto* whole = std::get_if<std::int64_t>(&value);
        whole != nullptr && dial.whole && *whole >= dial.whole->least && *whole <= dial.whole->most)
        return true;
    const double number = std::holds_alternative<double>(value)
                              ? std::get<double>(value)
                              : static_cast<double>(std::get<std::int64_t>(value));
    return dial.number && number >= dial.number->least && number <= dial.number->most;
}

/// As it stands in a study file.
std::string shown(const DialValue& value) {
    return std::holds_alternative<std::string>(value)
               ? fmt::format("\"{}\"", std::get<std::string>(value))
               : text_of(value);
}

std::string expected_by(const Dial& dial) {
    if (!dial.whole && !dial.number)
        return fmt::format("one of {}", fmt::join(dial.names, ", "));
    std::vector<std::string> wanted;
    if (dial.whole)
        wanted.push_back(
            fmt::format("a whole number from {} to {}", dial.whole->least, dial.whole->most));
    if (dial.number)
        wanted.push_back(
            fmt::format("a number from {} to {}", dial.number->least, dial.number->most));
    for (const auto& name : dial.names)
        wanted.push_back(fmt::format("\"{}\"", name));
    return fmt::format("{}", fmt::join(wanted, " or "));
}

const DialValue& value_of(const Dials& dials, std::string_view name) {
    const auto found = dials.find(name);
    EXPECTS(found != dials.end());
    return found->second;
}

} // namespace

std::vector<Dials> one_at_a_time(const std::vector<DialSteps>& steps, const Dials& throughout) {
    std::vector<Dials> settings;
    for (const auto& step : steps)
        for (const auto& value : step.values)
            settings.emplace_back(throughout).insert_or_assign(step.dial, value);
    return settings;
}

tl::expected<Dials, DialProblem> complete(const std::vector<Dial>& dials, Dials given) {
    for (const auto& [name, value] : given)
        if (std::none_of(dials.begin(), dials.end(),
                         [&](const Dial& dial) { return dial.name == name; })) {
            std::vector<std::string> names;
            for (const auto& dial : dials)
                names.push_back(dial.name);
            return tl::make_unexpected(DialProblem{
                name,
                fmt::format("is no dial of this method, which has {}",
                            names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", ")))});
        }
    for (const auto& dial : dials) {
        auto& value = given.try_emplace(dial.name, dial.preset).first->second;
        if (!fits(dial, value))
            return tl::make_unexpected(DialProblem{
                dial.name, fmt::format("is {}, expected {}", shown(value), expected_by(dial))});
        if (!dial.whole && dial.number && std::holds_alternative<std::int64_t>(value))
            value = static_cast<double>(std::get<std::int64_t>(value));
    }
    return given;
}

std::string text_of(const DialValue& value) {
    return std::visit([](const auto& one) { return fmt::format("{}", one); }, value);
}

std::int64_t whole_in(const Dials& dials, std::string_view name) {
    const auto* value = std::get_if<std::int64_t>(&value_of(dials, name));
    EXPECTS(value != nullptr);
    return *value;
}

double number_in(const Dials& dials, std::string_view name) {
    const auto* value = std::get_if<double>(&value_of(dials, name));
    EXPECTS(value != nullptr);
    return *value;
}

std::string name_in(const Dials& dials, std::string_view name) {
    const auto* value = std::get_if<std::string>(&value_of(dials, name));
    EXPECTS(value != nullptr);
    return *value;
}

bool is_name(const Dials& dials, std::string_view name) {
    return std::holds_alternative<std::string>(value_of(dials, name));
}

} // namespace renderer::methods
