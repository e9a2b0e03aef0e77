// Texts of studies, read with names that stand for those of the renderer.
#pragma once

#include "protocols/study.h"

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

namespace study_texts {

using namespace protocols;

/// Dials by name alone, and one that is checked: what they mean is not this room's business.
inline tl::expected<Dials, DialProblem> complete(const std::string& method, const Dials& given) {
    const std::map<std::string, std::set<std::string>> dials_of{
        {"phong", {}},
        {"green", {"law", "depth_map"}},
        {"shss", {"bands", "law", "thickness", "directions"}},
        {"guess", {}}};
    for (const auto& [name, value] : given)
        if (!dials_of.at(method).contains(name))
            return tl::unexpected(DialProblem{name, "is no dial of " + method});
    auto dials = given;
    if (method == "shss" &&
        dials.try_emplace("bands", std::int64_t{5}).first->second == DialValue(std::int64_t{9}))
        return tl::unexpected(DialProblem{"bands", "is 9, expected less"});
    return dials;
}

inline KnownNames known_names() {
    return {.methods = {"phong", "green", "shss", "guess"},
            .materials = {"apple", "chicken1", "chicken2", "cream", "ketchup", "marble", "potato",
                          "skim-milk", "skin1", "skin2", "spectralon", "whole-milk"},
            .caveats = {{"guess", "reconstruction"}},
            .complete = complete};
}

inline std::string contents(const std::string& path_from_root) {
    std::ifstream file(std::string(PAIRLIGHT_SOURCE_DIR) + "/" + path_from_root);
    EXPECT_TRUE(file.is_open()) << path_from_root;
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

inline Study parsed(const std::string& text) {
    const auto study = parse_study(text, "study.toml", known_names());
    EXPECT_TRUE(study.has_value()) << (study ? "" : study.error());
    return study.value_or(Study{});
}

/// The first complaint about a text, without the file's name: "line: what".
inline std::string complaint(const std::string& text) {
    const auto study = parse_study(text, "study.toml", known_names());
    EXPECT_FALSE(study.has_value());
    const auto message = study ? "study.toml:it was read" : study.error();
    EXPECT_TRUE(message.starts_with("study.toml:")) << message;
    return message.substr(std::string_view("study.toml:").size());
}

/// The smallest rendered study, whose lines the complaints refer to.
inline const std::string minimal = R"([study]
id = "pilot"
title = "A pilot"
question = "Which?"
seed = 7
width = 320
height = 240

[[scene]]
id = "bunny"
model = "bunny"
material = "marble"

[[condition]]
id = "glow"
method = "shss"

[[condition]]
id = "plain"
method = "phong"
)";

inline std::string changed(const std::string& line, const std::string& replacement) {
    auto text = minimal;
    const auto place = text.find(line);
    EXPECT_NE(place, std::string::npos) << line;
    return text.replace(place, line.size(), replacement);
}

/// The example of the manual: the text between ```toml and ```.
inline std::string example() {
    const auto page = contents("docs/study-file.md");
    const auto begin = page.find("```toml\n") + 8;
    return page.substr(begin, page.find("```", begin) - begin);
}

} // namespace study_texts
