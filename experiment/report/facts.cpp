// The subjects of the checklist, one function each, in its order.
#include "experiment/report/facts.h"

#include "experiment/report/numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <map>
#include <set>

namespace experiment::report {

namespace {

using analysis::Findings;
using store::Sitting;

constexpr std::chrono::milliseconds fast_answer{300};

// "not recorded" when there is nothing to say.
std::optional<std::string> known(std::string text) {
    return text.empty() ? std::nullopt : std::optional(std::move(text));
}

// What differs between sittings, each once, with how often when there are several.
template <class Text>
std::string tallied(const std::vector<Sitting>& sittings, Text&& text_of) {
    std::map<std::string, int> tally;
    for (const auto& sitting : sittings)
        if (const std::string text = text_of(sitting); !text.empty())
            ++tally[text];
    std::string lines;
    for (const auto& [text, count] : tally)
        lines += (lines.empty() ? "" : "\n") +
                 (tally.size() == 1
                      ? text
                      : fmt::format("{} ({} session{})", text, count, count == 1 ? "" : "s"));
    return lines;
}

std::optional<int> number_at(const std::string& text, std::size_t at, std::size_t length) {
    int value = 0;
    if (text.size() < at + length)
        return {};
    const auto* end = text.data() + at + length;
    const auto read = std::from_chars(text.data() + at, end, value);
    return read.ec == std::errc{} && read.ptr == end ? std::optional(value) : std::nullopt;
}

// YYYY-MM-DDThh:mm:ss..., to the second.
std::optional<std::chrono::sys_seconds> time_point(const std::string& utc) {
    const auto year = number_at(utc, 0, 4);
    const auto month = number_at(utc, 5, 2);
    const auto day = number_at(utc, 8, 2);
    const auto hours = number_at(utc, 11, 2);
    const auto minutes = number_at(utc, 14, 2);
    const auto seconds = number_at(utc, 17, 2);
    if (!year || !month || !day || !hours || !minutes || !seconds)
        return {};
    const std::chrono::year_month_day date{std::chrono::year(*year),
                                           std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    return std::chrono::sys_days(date) + std::chrono::hours(*hours) +
           std::chrono::minutes(*minutes) + std::chrono::seconds(*seconds);
}

std::string duration(const Sitting& sitting) {
    if (!sitting.finished_utc)
        return "";
    const auto start = time_point(sitting.start.started_utc);
    const auto end = time_point(*sitting.finished_utc);
    if (!start || !end || *end < *start)
        return "not known";
    const auto seconds = (*end - *start).count();
    return seconds < 60 ? fmt::format("{} s", seconds)
                        : fmt::format("{} min {} s", seconds / 60, seconds % 60);
}

std::vector<SittingRow> sitting_rows(const std::vector<Sitting>& sittings) {
    std::vector<SittingRow> rows;
    for (const auto& sitting : sittings)
        rows.push_back({sitting.start.key.observer.value, sitting.start.key.session,
                        sitting.start.local_date, duration(sitting),
                        static_cast<int>(sitting.votes.size()), sitting.start.timing_grade,
                        sitting.start.order_seed, sitting.start.sides_seed,
                        sitting.start.simulation.has_value()});
    return rows;
}

std::vector<BrightnessRow> brightness_rows(const Records& records) {
    std::vector<BrightnessRow> rows;
    if (!records.manifest)
        return rows;
    for (const auto& scene : records.study.scenes)
        for (const auto& variant : protocols::shown_variants(records.study))
            for (const auto& condition : records.study.conditions) {
                const protocols::Picture picture{scene.id, variant.id, condition.id};
                const auto found = records.manifest->pictures.find(picture);
                if (found == records.manifest->pictures.end() || !found->second.brightness)
                    continue;
                const auto& match = *found->second.brightness;
                rows.push_back(
                    {picture, match.mean_before, match.target, match.gain, match.clipped_share});
            }
    return rows;
}

Labels labels_of(const protocols::Study& study) {
    Labels labels;
    for (const auto& condition : study.conditions)
        labels.conditions[condition.id.value] = condition.label;
    for (const auto& scene : study.scenes)
        labels.scenes[scene.id.value] = scene.label;
    for (const auto& variant : study.variants)
        labels.variants[variant.id.value] = variant.label;
    return labels;
}

// "shss-5: SHSS, 25 coefficients (bands 5, method shss)", from the manifest's dials.
std::string condition_line(const protocols::Condition& condition, const Records& records) {
    std::set<std::string> dials;
    if (records.manifest)
        for (const auto& [picture, record] : records.manifest->pictures)
            if (picture.condition == condition.id)
                for (const auto& [name, value] : record.dials)
                    dials.insert(name + " " + value);
    std::string line = condition.label.empty() ? condition.id.value : condition.label;
    if (!dials.empty())
        line += fmt::format(" ({})", fmt::join(dials, ", "));
    else if (std::holds_alternative<protocols::OwnImages>(condition.source))
        line += " (own images)";
    return line;
}

template <class Thing>
std::string lines_of(const std::vector<Thing>& things) {
    std::string text;
    for (const auto& thing : things)
        text += (text.empty() ? "" : ", ") + (thing.label.empty() ? thing.id.value : thing.label);
    return text;
}

FactList about_the_study(const Records& records, const Findings& findings) {
    const auto& study = records.study;
    return {"Study",
            {{"Name", known(study.id)},
             {"Study file, SHA-256", known(records.study_sha256)},
             {"Program", known(findings.options.program)},
             {"Question", known(study.question)},
             {"Language", known(study.instructions.language)},
             {"Instructions", known(records.instructions)}}};
}

FactList about_the_stimuli(const Records& records) {
    const auto& study = records.study;
    std::string conditions;
    for (const auto& condition : study.conditions)
        conditions += (conditions.empty() ? "" : "\n") + condition_line(condition, records);
    std::set<std::string> renderers;
    std::string hashes;
    if (records.manifest) {
        for (const auto& [picture, record] : records.manifest->pictures)
            renderers.insert(record.renderer);
        hashes = fmt::format("{} files, SHA-256 of each in stimuli/manifest.json",
                             records.manifest->pictures.size());
    }
    const bool matched = !brightness_rows(records).empty();
    return {"Stimuli",
            {{"Conditions", known(conditions)},
             {"Scenes", known(lines_of(study.scenes))},
             {"Variants", known(study.variants.empty() ? "one" : lines_of(study.variants))},
             {"Size", fmt::format("{} \u00d7 {} pixels", study.width, study.height)},
             {"Drawn by", known(fmt::format("{}", fmt::join(renderers, "\n")))},
             {"Files", known(hashes)},
             {"Brightness", matched ? known("means equalised, by the factors in the table above")
                                    : std::nullopt}}};
}

std::string training_content(const std::vector<Sitting>& sittings) {
    return tallied(sittings, [](const Sitting& sitting) {
        const auto of_phase = [&](protocols::Phase phase) {
            return std::ranges::count(sitting.plan, phase, &protocols::PlannedTrial::phase);
        };
        return fmt::format("{} training trials, questions of the main part; {} warm-ups; {} main "
                           "trials",
                           of_phase(protocols::Phase::Training), of_phase(protocols::Phase::WarmUp),
                           of_phase(protocols::Phase::Main));
    });
}

FactList about_the_design(const Records& records, const Findings& findings) {
    const auto& study = records.study;
    const auto conditions = findings.design.conditions.size();
    return {
        "Design",
        {{"Pairs", fmt::format("{} for each scene and variant", conditions * (conditions - 1) / 2)},
         {"Repetitions", fmt::format("{} in a session, {} sessions of an observer planned",
                                     study.plan.repetitions, study.plan.sessions)},
         {"Complete", findings.design.complete ? "yes" : "no"},
         {"Order",
          known(tallied(records.sittings, [](const auto& s) { return s.start.scene_rule; }))},
         {"Seed of the study", fmt::format("{}", study.seed)},
         {"Generator",
          known(tallied(records.sittings, [](const auto& s) { return s.start.generator; }))},
         {"Warm-ups", fmt::format("{} at the start of a session; their answers are not kept",
                                  study.plan.warm_ups)},
         {"A session as planned", known(training_content(records.sittings))}}};
}

FactList about_the_display(const Records& records) {
    return {"Display and room",
            {{"Display",
              known(tallied(records.sittings, [](const auto& s) { return s.start.display; }))},
             {"Shown by",
              known(tallied(records.sittings, [](const auto& s) { return s.start.renderer; }))},
             {"Calibration", {}},
             {"Peak and black luminance", {}},
             {"Surround",
              fmt::format("code value {} of 255 in every channel", records.study.surround.code)},
             {"Surround as measured", {}},
             {"Room illuminance", {}},
             {"Background ratio and chromaticity", {}},
             {"Viewing distance", {}}}};
}

FactList about_the_observers(const Findings& findings) {
    return {"Observers",
            {{"Took part", fmt::format("{}", findings.design.observers.size())},
             {"Invited", {}},
             {"Screened, excluded", {}},
             {"Ages, sex", {}},
             {"Expertise", {}},
             {"Vision tests", {}}}};
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

std::string overrides(const std::vector<Sitting>& sittings) {
    std::string lines;
    for (const auto& sitting : sittings)
        if (sitting.start.override_reason)
            lines += fmt::format("{}{}, session {}: {}", lines.empty() ? "" : "\n",
                                 sitting.start.key.observer.value, sitting.start.key.session,
                                 *sitting.start.override_reason);
    return lines;
}

std::optional<std::string> simulations(const std::vector<Sitting>& sittings) {
    if (sittings.empty())
        return {};
    const auto specifications =
        tallied(sittings, [](const auto& s) { return s.start.simulation.value_or(""); });
    return specifications.empty() ? "none" : specifications;
}

FactList about_the_sessions(const Records& records) {
    const auto& sittings = records.sittings;
    const auto finished = std::ranges::count_if(
        sittings, [](const auto& sitting) { return sitting.finished_utc.has_value(); });
    return {"Sessions as held",
            {{"Begun, finished", fmt::format("{}, {}", sittings.size(), finished)},
             {"Days apart, at least", fmt::format("{}", records.study.plan.days_apart)},
             {"Exceptions from that",
              sittings.empty() ? std::nullopt
                               : known(overrides(sittings).empty() ? "none" : overrides(sittings))},
             {"Simulated observers", simulations(sittings)},
             {"Events", known(events_in_words(sittings))},
             {"Timing grade",
              known(tallied(sittings, [](const auto& s) { return s.start.timing_grade; }))},
             {"Dropped frames", {}}}};
}

std::string response_times(const std::vector<Sitting>& sittings) {
    std::vector<std::chrono::milliseconds> times;
    for (const auto& sitting : sittings)
        for (const auto& vote : sitting.votes)
            times.push_back(vote.response_time);
    if (times.empty())
        return "";
    std::ranges::sort(times);
    const auto middle = times.size() / 2;
    const auto median =
        times.size() % 2 == 1 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
    return fmt::format("median {} ms; {} of {} under {} ms", median.count(),
                       std::ranges::count_if(times, [](auto t) { return t < fast_answer; }),
                       times.size(), fast_answer.count());
}

std::string early_keys(const std::vector<Sitting>& sittings) {
    int early = 0;
    bool any = false;
    for (const auto& sitting : sittings)
        for (const auto& vote : sitting.votes) {
            early += vote.early_keys;
            any = true;
        }
    return any ? fmt::format("{}", early) : "";
}

std::string left_side(const Findings& findings) {
    const auto& side = findings.consistency.side;
    return fmt::format("{} of {} votes, exact binomial {}", side.left, side.answers,
                       p_equals(side.p));
}

std::string circular_triads(const Findings& findings) {
    const auto& triads = findings.consistency.triads;
    if (triads.rounds == 0)
        return "";
    return fmt::format("{} in {} rounds, {} expected by chance; mean zeta {}", triads.total,
                       triads.rounds, decimal(triads.expected_if_random, 0),
                       decimal(triads.mean_zeta, 3));
}

/// Shares of identical answers; NaN where nothing was answered twice.
std::string identical_answers(double share) {
    return share >= 0 ? percent(share) + " identical answers, by chance " + percent(0.5) : "";
}

FactList about_the_votes(const Records& records, const Findings& findings) {
    const auto& design = findings.design;
    return {"Votes",
            {{"Votes, ties, missing",
              fmt::format("{}, {}, {}", design.votes, design.ties,
                          design.missing_known ? fmt::format("{}", design.missing) : "not known")},
             {"Answers before input opened", known(early_keys(records.sittings))},
             {"Response times", known(response_times(records.sittings))},
             {"Left picture chosen", known(left_side(findings))},
             {"Circular triads", known(circular_triads(findings))},
             {"Repeatability between sessions of an observer",
              known(identical_answers(findings.consistency.repeatability.within_mean))},
             {"Agreement between observers in the same session",
              known(identical_answers(findings.consistency.repeatability.between_mean))}}};
}

FactList about_deviations(const Records& records, const Findings& findings) {
    std::vector<std::string> deviations;
    if (findings.design.observers.size() < formal_observers)
        deviations.push_back(fmt::format("{} observers, fewer than {}: informal",
                                         findings.design.observers.size(), formal_observers));
    if (std::ranges::any_of(records.sittings, [&](const Sitting& sitting) {
            return sitting.start.study_sha256 != records.study_sha256;
        }))
        deviations.emplace_back("the study file was changed between sittings or after them; each "
                                "sitting keeps the digest of its own");
    if (!overrides(records.sittings).empty())
        deviations.emplace_back("sessions nearer to each other than planned, see above");
    deviations.emplace_back("viewing distance, display and room: what is not recorded above could "
                            "not be checked");
    return {"Deviations from ITU-R BT.500, data and licence",
            {{"Deviations", fmt::format("{}", fmt::join(deviations, "\n"))},
             {"Data and code location", {}},
             {"Licence of the data", {}}}};
}

} // namespace

ReportContents
report_contents(const Records& records, analysis::Findings findings, std::string written_on) {
    ReportContents contents;
    contents.title = records.study.title.empty() ? records.study.id : records.study.title;
    contents.question = records.study.question;
    contents.written_on = std::move(written_on);
    contents.labels = labels_of(records.study);
    contents.sittings = sitting_rows(records.sittings);
    contents.brightness = brightness_rows(records);
    contents.facts = {about_the_study(records, findings),  about_the_stimuli(records),
                      about_the_design(records, findings), about_the_display(records),
                      about_the_observers(findings),       about_the_sessions(records),
                      about_the_votes(records, findings),  about_deviations(records, findings)};
    contents.findings = std::move(findings);
    return contents;
}

} // namespace experiment::report
