// The subjects of the checklist, one function each, in its order.
#include "experiment/report/facts.h"

#include "experiment/report/circumstances.h"
#include "experiment/report/numbers.h"
#include "experiment/report/sitting_words.h"
#include "experiment/store/screened.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

namespace experiment::report {

namespace {

using analysis::Findings;
using store::Sitting;

constexpr std::chrono::milliseconds fast_answer{300};

std::vector<SittingRow> sitting_rows(const std::vector<Sitting>& sittings) {
    std::vector<SittingRow> rows;
    for (const auto& sitting : sittings)
        rows.push_back({sitting.start.key.observer.value, sitting.start.key.session,
                        sitting.start.local_date, duration(sitting),
                        static_cast<int>(sitting.votes.size()), timing_grade(sitting),
                        late_frames(sitting), sitting.start.order_seed, sitting.start.sides_seed,
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

// "800 x 600 pixels", or scene by scene where they differ.
std::string sizes_of(const protocols::Study& study) {
    const auto text = [](const protocols::PictureSize& size) {
        return fmt::format("{} \u00d7 {} pixels", size.width, size.height);
    };
    std::string lines;
    std::set<std::string> different;
    for (const auto& [scene, size] : picture_sizes(study)) {
        different.insert(text(size));
        lines += fmt::format("{}{}: {}", lines.empty() ? "" : "\n", scene.value, text(size));
    }
    return different.size() == 1 ? *different.begin()
           : different.empty()   ? text({study.width, study.height})
                                 : lines;
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
             {"Size", sizes_of(study)},
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
    if (findings.design.observers.size() < store::formal_observers)
        deviations.push_back(fmt::format("{} observers, fewer than {}: informal",
                                         findings.design.observers.size(),
                                         store::formal_observers));
    else if (records.screened.size() < store::formal_observers)
        deviations.push_back(fmt::format("{} observers on record as screened, fewer than {}: "
                                         "informal",
                                         records.screened.size(), store::formal_observers));
    if (std::ranges::any_of(records.sittings, [](const Sitting& sitting) {
            return std::ranges::count(sitting.plan, protocols::Phase::Training,
                                      &protocols::PlannedTrial::phase) > 0;
        }))
        deviations.emplace_back("practice pairs were drawn from the session's own pictures");
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
    contents.screened = records.screened.size();
    contents.sittings = sitting_rows(records.sittings);
    contents.brightness = brightness_rows(records);
    contents.facts = {about_the_study(records, findings),     about_the_stimuli(records),
                      about_the_design(records, findings),    about_the_display(records),
                      about_the_observers(records, findings), about_the_sessions(records),
                      about_the_votes(records, findings),     about_deviations(records, findings)};
    contents.findings = std::move(findings);
    return contents;
}

} // namespace experiment::report
