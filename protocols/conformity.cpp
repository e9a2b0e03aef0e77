// BT.500, line by line.  Limits are those of protocol practice; each line says its own.
#include "protocols/conformity.h"

#include "protocols/questions.h"
#include "protocols/session_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace protocols {

namespace {

using Lines = std::vector<ConformityLine>;

constexpr int least_observers = 15;

Verdict met_if(bool kept) {
    return kept ? Verdict::Met : Verdict::NotMet;
}

/// A figure of the room against its limits; nobody but the experimenter has it.
void add_measured(Lines& lines,
                  std::string asked,
                  std::optional<double> value,
                  double low,
                  double high,
                  std::string_view key,
                  std::string_view unit = "") {
    if (value)
        lines.push_back({std::move(asked), met_if(*value >= low && *value <= high),
                         fmt::format("{}{} by [room] {}", *value, unit, key)});
    else
        lines.push_back({std::move(asked), Verdict::OnlyTheExperimenterKnows,
                         fmt::format("measure it, and record it as {} in [room]", key)});
}

void add_room(Lines& lines, const Study& study) {
    const auto& room = study.room;
    add_measured(lines, "inactive screen at most 0.02 of peak white", room.screen_off_ratio, 0,
                 0.02, "screen_off_ratio");
    add_measured(lines, "black in a dark room about 0.01 of peak white (at most 0.02)",
                 room.black_ratio, 0, 0.02, "black_ratio");
    // "About 0.15": half of it to half as much again.
    add_measured(lines, "background behind the display about 0.15 of peak white",
                 room.background_ratio, 0.075, 0.225, "background_ratio");
    lines.push_back({"background of chromaticity D65",
                     room.background_white.empty() ? Verdict::OnlyTheExperimenterKnows
                                                   : met_if(room.background_white == "D65"),
                     room.background_white.empty()
                         ? "see to it, and record it as background_white in [room]"
                         : fmt::format("{} by [room] background_white", room.background_white)});
    // "Low" has no number in BT.500; P.910 has 20 lux.
    add_measured(lines, "low room light (20 lux at most, after P.910)", room.ambient_lux, 0, 20,
                 "ambient_lux", " lux");
    add_measured(lines, "peak white of 70 to 250 cd/m2", room.peak_cd_m2, 70, 250, "peak_cd_m2",
                 " cd/m2");
    add_measured(lines, "observers within 30 degrees of the screen's normal", room.max_angle_deg, 0,
                 30, "max_angle_deg", " degrees");
    lines.push_back(
        {"brightness and contrast set with PLUGE", Verdict::OnlyTheExperimenterKnows,
         fmt::format("`pairlight display` shows bars for it{}",
                     study.display.eotf.kind == Eotf::Kind::Measured ? "; greys were measured"
                                                                     : "")});
}

void add_distance(Lines& lines, const Study& study) {
    const auto& display = study.display;
    if (display.distance_mm > 0)
        lines.push_back({"a stated viewing distance", Verdict::Met,
                         fmt::format("{} mm by [display] distance_mm", display.distance_mm)});
    else
        lines.push_back({"a stated viewing distance", Verdict::NotMet,
                         "free; [display] distance_mm states one"});
    lines.push_back({"screen size known, so that pixels per degree are",
                     met_if(display.screen_width_mm > 0),
                     display.screen_width_mm > 0
                         ? fmt::format("{} mm wide by [display]", display.screen_width_mm)
                         : "[display] screen_width_mm states it"});
    lines.push_back(
        {"a grey surround of known light", Verdict::Met,
         fmt::format("code {} ({}), {:.1f} % of white by its curve", study.surround.code,
                     study.surround.definition,
                     100 * relative_luminance(display.eotf.kind == Eotf::Kind::Measured &&
                                                      display.eotf.steps.empty()
                                                  ? Eotf{}
                                                  : display.eotf,
                                              study.surround.code))});
}

bool asks(const Panel& panel, std::string_view id) {
    return std::any_of(panel.questions.begin(), panel.questions.end(),
                       [&](const auto& question) { return question.id == id; });
}

void add_observers(Lines& lines, const Study& study, const PanelSoFar& so_far) {
    const auto& panel = study.panel;
    const bool enough =
        panel.required >= least_observers && so_far.screened.value_or(0) >= least_observers;
    lines.push_back(
        {"at least 15 observers after screening",
         enough || (!so_far.screened && panel.required >= least_observers) ? Verdict::Met
                                                                           : Verdict::NotMet,
         so_far.screened
             ? fmt::format("{} so far{}", *so_far.screened,
                           *so_far.screened < least_observers ? ": an informal study" : "")
             : fmt::format("{} by [observer] required{}", panel.required,
                           panel.required < least_observers ? ": an informal study" : "")});
    const auto asked = [&](std::string what, std::string_view id) {
        lines.push_back({std::move(what), met_if(asks(panel, id)),
                         asks(panel, id) ? fmt::format("asked as {}", id)
                                         : fmt::format("{} is not asked; [observer] asks it", id)});
    };
    asked("visual acuity tested", "acuity");
    asked("colour vision tested", "ishihara_errors");
    asked("observers who are no experts, or declared", "expert");
    asked("nobody who worked on what is compared", "worked_on_methods");
}

void add_session(Lines& lines, const Study& study) {
    const auto& plan = study.plan;
    const auto minutes = static_cast<double>(estimated_length(study).count()) / 60;
    lines.push_back({"written instructions, the same for all", Verdict::Met,
                     fmt::format("{} ({})", study.instructions.file, study.instructions.language)});
    lines.push_back({"training before the session, then questions", met_if(plan.training >= 4),
                     fmt::format("{} pairs for practice{}, repeated at the observer's wish",
                                 plan.training, plan.training < 4 ? ", expected 4 or more" : "")});
    lines.push_back({"training pictures other than those of the session", Verdict::NotMet,
                     "practice pairs are drawn from the session's own"});
    const bool both = plan.easy_pair && plan.hard_pair && plan.training >= 2;
    lines.push_back({"training over the whole range of differences", met_if(both),
                     both ? "an easy and a hard pair are in it"
                          : "easy_pair and hard_pair in [session] name one of each for it"});
    lines.push_back({"a session of at most 30 minutes", met_if(minutes <= 30),
                     fmt::format("about {:.0f} minutes", minutes)});
    lines.push_back({"stabilising trials that are not counted, about 5 first and 3 later",
                     met_if(plan.warm_ups >= 3),
                     fmt::format("{} in every sitting", plan.warm_ups)});
    lines.push_back({"a random order, another for each observer and sitting", Verdict::Met,
                     "drawn anew; neighbours show different scenes where they can"});
    lines.push_back({"time to adapt to the surround", met_if(plan.adapt_s >= 30),
                     fmt::format("{} s of grey{}", plan.adapt_s,
                                 plan.adapt_s < 30 ? ", expected 30 or more" : "")});
    lines.push_back(
        {"grey between presentations", met_if(plan.grey_ms >= 200),
         fmt::format("{} ms{}", plan.grey_ms, plan.grey_ms < 200 ? ", expected 200 or more" : "")});
}

} // namespace

std::vector<ConformityLine> bt500_conformity(const Study& study, const PanelSoFar& panel) {
    Lines lines;
    add_room(lines, study);
    add_distance(lines, study);
    add_observers(lines, study, panel);
    add_session(lines, study);
    return lines;
}

std::string words_of(Verdict verdict) {
    switch (verdict) {
    case Verdict::Met:
        return "met";
    case Verdict::NotMet:
        return "NOT MET";
    case Verdict::OnlyTheExperimenterKnows:
        return "only the experimenter can know";
    }
    return {};
}

} // namespace protocols
