// Under which circumstances votes were given.
#include "experiment/report/circumstances.h"

#include "experiment/report/sitting_words.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace experiment::report {

namespace {

using analysis::Findings;
using store::Sitting;

std::optional<std::string> measured(std::optional<double> value, std::string_view unit) {
    return value ? std::optional(fmt::format("{}{}", *value, unit)) : std::nullopt;
}

std::optional<std::string> luminances(const protocols::Room& room) {
    const auto ratio = [&](std::optional<double> value, std::string_view what) {
        return value ? fmt::format("{} {} of white", what, *value) : "";
    };
    return known(
        joined({room.peak_cd_m2 ? fmt::format("white {} cd/m\u00b2", *room.peak_cd_m2) : "",
                ratio(room.black_ratio, "black"), ratio(room.screen_off_ratio, "switched off")}));
}

std::optional<std::string> calibration(const protocols::Study& study) {
    const auto& eotf = study.display.eotf;
    if (eotf.kind != protocols::Eotf::Kind::Measured)
        return {};
    return fmt::format("{}, {} greys measured", eotf.file, eotf.steps.size());
}

std::optional<std::string> viewing_distance(const Records& records) {
    const auto& display = records.study.display;
    if (!(display.distance_mm > 0))
        return {};
    const auto density = tallied(records.sittings, [](const auto& sitting) {
        return value_in(sitting.start.display, "pixels_per_degree");
    });
    return fmt::format("{} mm{}", display.distance_mm,
                       density.empty() ? "" : ", pixels per degree: " + density);
}

// What the observers answered to a question: each answer once, with how often.
std::string answers_to(const Records& records, const std::string& question) {
    std::map<std::string, int> tally;
    for (const auto& [observer, answers] : records.answers) {
        const auto last = std::find_if(answers.rbegin(), answers.rend(), [&](const auto& answer) {
            return answer.question == question;
        });
        if (last != answers.rend())
            ++tally[last->answer];
    }
    std::vector<std::string> items;
    for (const auto& [answer, count] : tally)
        items.push_back(fmt::format("{}: {}", answer, count));
    return fmt::format("{}", fmt::join(items, "; "));
}

std::optional<std::string> screened(const Records& records) {
    const auto verdicts = answers_to(records, "screening");
    if (verdicts.empty())
        return {};
    return fmt::format("{} passed and finished a sitting ({}); nobody is left out of the analyses",
                       records.screened.size(), verdicts);
}

// Kinds of events with how often each happened, over all sessions.
std::string events_in_words(const std::vector<Sitting>& sittings) {
    std::map<std::string, int> tally;
    for (const auto& sitting : sittings)
        for (const auto& event : sitting.events)
            ++tally[event.kind];
    std::vector<std::string> items;
    for (const auto& [kind, count] : tally)
        items.push_back(fmt::format("{} {}", kind, count));
    return fmt::format("{}", fmt::join(items, ", "));
}

std::optional<std::string> simulations(const std::vector<Sitting>& sittings) {
    if (sittings.empty())
        return {};
    const auto specifications =
        tallied(sittings, [](const auto& s) { return s.start.simulation.value_or(""); });
    return specifications.empty() ? "none" : specifications;
}

// Over the sessions whose displays keep time; the others have nothing to be late by.
std::string frames_late(const std::vector<Sitting>& sittings) {
    FrameCount verified;
    int unverified = 0;
    for (const auto& sitting : sittings) {
        const auto [all, late] = frames_seen(sitting);
        if (all > 0 && timing_grade(sitting) == "U")
            ++unverified;
        else
            verified = {verified.all + all, verified.late + late};
    }
    return joined({verified.all > 0 ? fmt::format("{} of {}", verified.late, verified.all) : "",
                   unverified > 0 ? fmt::format("not verifiable in {} session{} (grade U)",
                                                unverified, unverified == 1 ? "" : "s")
                                  : ""});
}

} // namespace

FactList about_the_display(const Records& records) {
    const auto& room = records.study.room;
    return {"Display and room",
            {{"Display",
              known(tallied(records.sittings, [](const auto& s) { return s.start.display; }))},
             {"Shown by",
              known(tallied(records.sittings, [](const auto& s) { return s.start.renderer; }))},
             {"Calibration", calibration(records.study)},
             {"Peak and black luminance", luminances(room)},
             {"Surround",
              fmt::format("code value {} of 255 in every channel", records.study.surround.code)},
             {"Surround as measured", {}},
             {"Room illuminance", measured(room.ambient_lux, " lux")},
             {"Background ratio and chromaticity",
              known(joined({measured(room.background_ratio, " of white").value_or(""),
                            room.background_white}))},
             {"Largest angle to the screen's normal", measured(room.max_angle_deg, " degrees")},
             {"Room, as recorded with the sessions",
              known(tallied(records.sittings, [](const auto& s) { return last_word(s, "room"); }))},
             {"Viewing distance", viewing_distance(records)}}};
}

FactList about_the_observers(const Records& records, const Findings& findings) {
    const auto told = [&](const std::string& question, const std::string& name) {
        const auto answers = answers_to(records, question);
        return answers.empty() ? "" : name + " " + answers;
    };
    const auto lines = [](std::vector<std::string> parts) {
        std::erase(parts, "");
        return known(fmt::format("{}", fmt::join(parts, "\n")));
    };
    return {"Observers",
            {{"Took part", fmt::format("{}", findings.design.observers.size())},
             {"Invited", {}},
             {"Screened, excluded", screened(records)},
             {"Ages, sex", lines({told("age", "age"), told("sex", "sex")})},
             {"Expertise", lines({told("expert", "picture quality is part of their work"),
                                  told("worked_on_methods", "took part in what is compared")})},
             {"Vision tests",
              lines({told("acuity", "decimal acuity"),
                     told("ishihara_errors", "Ishihara plates, errors"),
                     told("ishihara_medium", "plates"), told("glasses", "glasses or lenses")})}}};
}

FactList about_the_sessions(const Records& records) {
    const auto& sittings = records.sittings;
    const auto finished = std::ranges::count_if(
        sittings, [](const auto& sitting) { return sitting.finished_utc.has_value(); });
    return {
        "Sessions as held",
        {{"Begun, finished", fmt::format("{}, {}", sittings.size(), finished)},
         {"Days apart, at least", fmt::format("{}", records.study.plan.days_apart)},
         {"Exceptions from that",
          sittings.empty() ? std::nullopt
                           : known(overrides(sittings).empty() ? "none" : overrides(sittings))},
         {"Simulated observers", simulations(sittings)},
         {"Events", known(events_in_words(sittings))},
         {"Timing grade", known(tallied(sittings, [](const auto& s) { return timing_grade(s); }))},
         {"Frames late", known(frames_late(sittings))}}};
}

} // namespace experiment::report
