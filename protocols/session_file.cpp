// How people are asked, read strictly.  The form is documented in docs/study-file.md.
#include "protocols/session_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace protocols {

namespace {

std::optional<double> gamma_of(const std::string& text) {
    constexpr std::string_view kind = "gamma:";
    if (!text.starts_with(kind))
        return std::nullopt;
    double gamma = 0;
    const auto* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data() + kind.size(), last, gamma);
    return error == std::errc() && end == last && gamma >= 1 && gamma <= 4 ? std::optional(gamma)
                                                                           : std::nullopt;
}

bool is_inside(const std::string& file) {
    return !file.empty() && !file.starts_with("/") && file.find("..") == std::string::npos;
}

Eotf read_eotf(Section& section) {
    Eotf eotf;
    const auto text = section.text("eotf", "srgb");
    const auto gamma = gamma_of(text);
    if (gamma) {
        eotf.kind = Eotf::Kind::Gamma;
        eotf.gamma = *gamma;
    } else if (text.starts_with("table:") && is_inside(text.substr(6))) {
        eotf.kind = Eotf::Kind::Measured;
        eotf.file = text.substr(6);
    } else if (text != "srgb" && !text.empty()) {
        section.refuse("eotf", "\"srgb\", \"gamma:2.2\" (1 to 4) or \"table:FILE\", measurements "
                               "inside the study folder");
    }
    return eotf;
}

// With a table that is still to be read, the grey is found again once it is.
Surround read_surround(Section& section, const Eotf& eotf) {
    const auto definition = section.text("surround", "code:128");
    const auto surround =
        surround_of(definition, eotf.kind == Eotf::Kind::Measured ? Eotf{} : eotf);
    if (!surround && !definition.empty())
        section.refuse("surround", "\"code:0\" to \"code:255\", the grey's 8-bit code value, or "
                                   "\"lstar:50\" (0 to 100) or \"linear:0.5\" (0 to 1), its light");
    return surround.value_or(Surround{});
}

void read_display(Section section, Study& study) {
    auto& display = study.display;
    display.eotf = read_eotf(section);
    study.surround = read_surround(section, display.eotf);
    section.number("screen_width_mm", {1, 100000}, display.screen_width_mm);
    section.number("distance_mm", {1, 100000}, display.distance_mm);
    section.whole("photodiode_px", {0, 500}, display.photodiode_px);
    section.number("text_scale", {0.5, 3}, display.text_scale);
    display.high_contrast =
        section.one_of("text", {"plain", "high-contrast"}, "plain") == "high-contrast";
    section.expect_nothing_else();
}

void read_room(Section section, Room& room) {
    const auto measured = [&](const char* key, Range<double> range, std::optional<double>& value) {
        if (!section.has(key))
            return;
        value = 0;
        section.number(key, range, *value);
    };
    measured("peak_cd_m2", {1, 10000}, room.peak_cd_m2);
    measured("black_ratio", {0, 1}, room.black_ratio);
    measured("screen_off_ratio", {0, 1}, room.screen_off_ratio);
    measured("background_ratio", {0, 1}, room.background_ratio);
    measured("ambient_lux", {0, 100000}, room.ambient_lux);
    measured("max_angle_deg", {0, 90}, room.max_angle_deg);
    room.background_white = section.text("background_white", "");
    section.expect_nothing_else();
}

template <class Enum>
Enum read_word(Section& section,
               const char* key,
               const std::vector<std::pair<std::string, Enum>>& words) {
    std::vector<std::string> names;
    for (const auto& [name, value] : words)
        names.push_back(name);
    const auto word = section.one_of(key, names, names.front());
    const auto found = std::find(names.begin(), names.end(), word);
    return found == names.end() ? words.front().second
                                : words[static_cast<std::size_t>(found - names.begin())].second;
}

std::optional<ConditionPair> read_pair(Section& section, const char* key) {
    if (!section.has(key))
        return std::nullopt;
    const auto names = section.several(key);
    if (names.size() == 2 && names[0] != names[1])
        return ConditionPair{ConditionId{names[0]}, ConditionId{names[1]}};
    section.refuse(key, "the ids of two conditions, such as [\"first\", \"second\"]");
    return std::nullopt;
}

// What is written and would change nothing was meant to change something.
void read_practice(Section& section, SessionPlan& plan) {
    section.whole("training", {0, 100}, plan.training);
    plan.easy_pair = read_pair(section, "easy_pair");
    plan.hard_pair = read_pair(section, "hard_pair");
    for (const auto* key : {"easy_pair", "hard_pair"})
        if (section.has(key) && plan.training == 0)
            section.refuse(key, "no such key, or training = 1 or more: with training = 0, nothing "
                                "is practised");
    if (plan.easy_pair && plan.hard_pair &&
        std::is_permutation(plan.easy_pair->begin(), plan.easy_pair->end(),
                            plan.hard_pair->begin()))
        section.refuse("hard_pair", "another pair than easy_pair: the same two cannot differ both "
                                    "most and least");
}

void read_deadline(Section& section, SessionPlan& plan) {
    section.whole("deadline_s", {0, 600}, plan.deadline_s);
    if (plan.deadline_s > 0 && 1000 * plan.deadline_s <= plan.closed_ms)
        section.note("deadline_s",
                     fmt::format("deadline_s in [session] is {} s, which is over before an answer "
                                 "counts (closed_ms = {}), expected more, or 0 for none",
                                 plan.deadline_s, plan.closed_ms));
    plan.after_deadline = read_word<AfterDeadline>(
        section, "after_deadline",
        {{"again", AfterDeadline::Again}, {"missing", AfterDeadline::Missing}});
    if (section.has("after_deadline") && !section.has("deadline_s"))
        section.refuse("after_deadline", "a 'deadline_s' beside it, or neither: without one, an "
                                         "answer is waited for as long as it takes");
}

SessionPlan read_plan(Section section) {
    SessionPlan plan;
    section.whole("sessions", {1, 100}, plan.sessions);
    section.whole("days_apart", {0, 365}, plan.days_apart);
    section.whole("warm_ups", {0, 100}, plan.warm_ups);
    section.whole("repetitions", {1, 100}, plan.repetitions);
    section.whole("grey_ms", {0, 60000}, plan.grey_ms);
    section.whole("closed_ms", {0, 10000}, plan.closed_ms);
    section.whole("adapt_s", {0, 3600}, plan.adapt_s);
    section.whole("break_every", {0, 10000}, plan.break_every);
    section.whole("gap_px", {16, 2000}, plan.gap_px);
    section.whole("view_ms", {0, 600000}, plan.view_ms);
    section.whole("between_ms", {0, 60000}, plan.between_ms);
    section.whole("longest_minutes", {0, 600}, plan.longest_minutes);
    read_deadline(section, plan);
    plan.response = read_word<Response>(section, "response",
                                        {{"forced-choice", Response::ForcedChoice},
                                         {"not-sure", Response::WithNotSure},
                                         {"seven-grades", Response::SevenGrades}});
    plan.presentation = read_word<Presentation>(section, "presentation",
                                                {{"side-by-side", Presentation::SideBySide},
                                                 {"sequential", Presentation::Sequential},
                                                 {"flip", Presentation::Flip}});
    if (plan.presentation == Presentation::Sequential && plan.view_ms == 0)
        section.note("presentation", "pictures in sequence have no 'view_ms' in [session], "
                                     "expected how long each of them is seen");
    if (const auto reference = section.text("reference", ""); !reference.empty())
        plan.reference = ConditionId{reference};
    read_practice(section, plan);
    section.expect_nothing_else();
    return plan;
}

KeyMap read_keys(Section section) {
    auto keys = standard_keys();
    std::map<std::string, Action> taken;
    for (const auto action : all_actions()) {
        const auto name = name_of(action);
        if (section.has(name))
            keys[action] = section.several_of(name, key_names());
        for (const auto& key : keys[action])
            if (const auto [earlier, is_new] = taken.emplace(key, action); !is_new)
                section.note(name, fmt::format("the key '{}' means both '{}' and '{}' in [keys], "
                                               "expected one meaning",
                                               key, name_of(earlier->second), name));
    }
    section.expect_nothing_else();
    return keys;
}

Instructions read_instructions(Section section) {
    Instructions instructions;
    instructions.language = section.text("language", instructions.language);
    const auto file = section.text("file", instructions.file);
    if (file.starts_with("/") || file.find("..") != std::string::npos)
        section.refuse("file", "a file inside the study folder");
    instructions.file = file;
    section.expect_nothing_else();
    return instructions;
}

ObserverQuestion read_question(Section section) {
    ObserverQuestion question;
    question.line = section.line();
    question.id = section.id();
    question.ask = section.text("ask");
    if (section.has("choices")) {
        question.choices = section.several("choices");
        if (std::set<std::string>(question.choices.begin(), question.choices.end()).size() < 2)
            section.refuse("choices", "two different answers or more");
        if (section.has("passes"))
            question.passes = section.several_of("passes", question.choices);
    } else {
        question.kind = ObserverQuestion::Kind::Number;
        question.greatest = 1e6;
        section.number("least", {-1e6, 1e6}, question.least);
        section.number("greatest", {-1e6, 1e6}, question.greatest);
        if (!section.has("least") && !section.has("greatest"))
            section.note("ask", fmt::format("[[question]] '{}' has neither 'choices' nor 'least' "
                                            "and 'greatest', expected one of them",
                                            question.id));
        if (question.least >= question.greatest)
            section.refuse("least", "less than 'greatest': no answer fits between them");
        const auto limit = [&](const char* key, std::optional<double>& value) {
            if (!section.has(key))
                return;
            value = 0;
            section.number(key, {question.least, question.greatest}, *value);
        };
        limit("passes_from", question.passes_from);
        limit("passes_up_to", question.passes_up_to);
        if (question.passes_from && question.passes_up_to &&
            *question.passes_from > *question.passes_up_to)
            section.refuse("passes_from", "at most 'passes_up_to': nobody could pass");
    }
    section.expect_nothing_else();
    return question;
}

// A study without the table asks nothing of observers; one with it asks what BT.500 wants known.
void read_panel(Section& file, Panel& panel) {
    if (file.has("observer")) {
        auto section = file.table("observer", false);
        section.whole("required", {1, 1000}, panel.required);
        panel.consent = section.one_of("consent", {"asked", "not asked"}, "asked") == "asked";
        if (section.one_of("questions", {"standard", "own"}, "standard") == "standard")
            panel.questions = standard_questions();
        section.expect_nothing_else();
    }
    for (auto& each : file.tables("question")) {
        auto question = read_question(each);
        if (std::any_of(panel.questions.begin(), panel.questions.end(),
                        [&](const auto& other) { return other.id == question.id; }))
            each.refuse("id", "an id that no other question has");
        panel.questions.push_back(std::move(question));
    }
}

} // namespace

void read_session_tables(Section& file, Study& study) {
    read_display(file.table("display", false), study);
    read_room(file.table("room", false), study.room);
    study.plan = read_plan(file.table("session", false));
    study.keys = read_keys(file.table("keys", false));
    study.instructions = read_instructions(file.table("instructions", false));
    read_panel(file, study.panel);
}

void expect_known_conditions(Section& file, const Study& study) {
    const auto session = file.table("session", false);
    const auto& reference = study.plan.reference;
    const auto is_known = [&](const ConditionId& id) {
        return std::any_of(study.conditions.begin(), study.conditions.end(),
                           [&](const auto& each) { return each.id == id; });
    };
    if (reference && !is_known(*reference))
        session.refuse("reference", "the id of a [[condition]] of this study");
    const auto expect_compared = [&](const char* key, const std::optional<ConditionPair>& pair) {
        for (const auto& id : pair.value_or(ConditionPair{}))
            if (pair && (!is_known(id) || id == reference))
                session.refuse(key, fmt::format("the ids of two [[condition]] that are compared: "
                                                "'{}' is {}",
                                                id.value, is_known(id) ? "the reference" : "none"));
    };
    expect_compared("easy_pair", study.plan.easy_pair);
    expect_compared("hard_pair", study.plan.hard_pair);
}

} // namespace protocols
