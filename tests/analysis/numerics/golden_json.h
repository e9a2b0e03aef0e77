// A golden JSON file.
#pragma once

#include <nlohmann/json.hpp>

#include <cctype>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace golden {

/// Integers of more than 300 digits, which no double holds and the parser refuses, become null.
inline nlohmann::json read_json(const std::string& name) {
    std::ifstream stream(PAIRLIGHT_TEST_DATA "/golden/" + name);
    if (!stream)
        throw std::runtime_error("cannot open golden " + name);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    std::string kept;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0)
            ++end;
        if (end == at)
            kept += text[at++];
        else {
            kept += end - at > 300 ? "null" : text.substr(at, end - at);
            at = end;
        }
    }
    return nlohmann::json::parse(kept);
}

} // namespace golden
