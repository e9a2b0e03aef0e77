// One head stands over all scenes, so every word of it must hold for each.
#include "experiment/cost/earlier_runs.h"

#include "experiment/cost/choices.h"
#include "protocols/contract.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace experiment::cost {

namespace {

/// What must agree, in words.
std::array<std::pair<const char*, std::string>, 6> circumstances(const CostReport& report) {
    return {{{"measured by", report.program},
             {"drawn by", report.renderer},
             {"law", report.law},
             {"timed by", report.timed_by},
             {"rounds", std::to_string(report.rounds)},
             {"held-out lights", std::to_string(report.held_out_lights)}}};
}

std::optional<std::string> what_differs(const EarlierRun& first, const EarlierRun& other) {
    const auto expected = circumstances(first.report), found = circumstances(other.report);
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i] != expected[i])
            return fmt::format("{}: {} {}; expected {} as in {}", other.file, found[i].first,
                               found[i].second, expected[i].second, first.file);
    return std::nullopt;
}

bool has(const CostReport& report, const std::string& scene, const std::string& light) {
    return std::ranges::any_of(report.scenes, [&](const SceneCost& one) {
        return one.id == scene &&
               std::ranges::find(one.lights, light, &LightCase::id) != one.lights.end();
    });
}

/// Subjects that were put together are all named, one after the other.
bool is_among(const std::string& subjects, const std::string& subject) {
    return fmt::format(", {}, ", subjects).find(fmt::format(", {}, ", subject)) !=
           std::string::npos;
}

std::optional<std::string> what_is_twice(const CostReport& whole, const EarlierRun& other) {
    for (const auto& scene : other.report.scenes)
        for (const auto& light : scene.lights)
            if (has(whole, scene.id, light.id))
                return fmt::format("{}: scene \"{}\"{} is in an earlier --from already, expected "
                                   "it once",
                                   other.file, scene.id,
                                   light.id.empty() ? "" : ", variant \"" + light.id + "\"");
    return std::nullopt;
}

} // namespace

tl::expected<CostReport, std::string> together(const std::vector<EarlierRun>& runs) {
    EXPECTS(!runs.empty());
    auto whole = runs.front().report;
    std::vector<std::string> subjects{whole.subject};
    for (std::size_t i = 1; i < runs.size(); ++i) {
        const auto& report = runs[i].report;
        if (auto differs = what_differs(runs.front(), runs[i]))
            return tl::unexpected(std::move(*differs));
        if (auto twice = what_is_twice(whole, runs[i]))
            return tl::unexpected(std::move(*twice));
        if (std::ranges::find(subjects, report.subject) == subjects.end())
            whole.subject += ", " + subjects.emplace_back(report.subject);
        whole.scenes.insert(whole.scenes.end(), report.scenes.begin(), report.scenes.end());
    }
    return whole;
}

tl::expected<void, std::string> expect_subject(const std::vector<EarlierRun>& runs,
                                               const std::string& subject,
                                               const std::string& name) {
    std::string measured;
    for (const auto& run : runs) {
        if (is_among(run.report.subject, subject))
            return {};
        measured += fmt::format("{}\"{}\"", measured.empty() ? "" : ", ", run.report.subject);
    }
    return tl::unexpected(
        fmt::format("{}: measured is {}, and {} is \"{}\"; expected the name of what was measured",
                    runs.front().file, measured, name, subject));
}

void choose_again(CostReport& report, const Wish& wish) {
    report.wish = wish;
    for (auto& scene : report.scenes)
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const auto before = std::exchange(scene.lights[i].choice, {});
            scene.lights[i].choice = choose(scene, i, wish);
            if (auto& choice = scene.lights[i].choice; choice && before &&
                                                       before->row == choice->row &&
                                                       before->predicted == choice->predicted)
                choice->measured = before->measured;
        }
}

} // namespace experiment::cost
