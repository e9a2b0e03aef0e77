// Two names are twins when they are equal without the blanks around them.
#include "analysis/twin_names.h"

#include <fmt/format.h>

#include <map>
#include <string_view>

namespace analysis {

namespace {

std::string_view without_blanks_around(std::string_view name) {
    constexpr std::string_view blanks = " \t\r\n";
    const auto first = name.find_first_not_of(blanks);
    if (first == name.npos)
        return {};
    return name.substr(first, name.find_last_not_of(blanks) - first + 1);
}

} // namespace

std::string twins_but_for_blanks(const Dictionary& names, const std::string& what) {
    std::map<std::string_view, const std::string*> seen;
    for (const auto& name : names.names()) {
        const auto [known, added] = seen.emplace(without_blanks_around(name), &name);
        if (!added)
            return fmt::format("{} '{}' and '{}' differ only in blanks around them, expected one "
                               "spelling",
                               what, *known->second, name);
    }
    return {};
}

} // namespace analysis
