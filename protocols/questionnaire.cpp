// Questions about observers.
#include "protocols/questionnaire.h"

#include "protocols/contract.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>

namespace protocols {

namespace {

using Kind = ObserverQuestion::Kind;

std::vector<std::string> age_bands() {
    std::vector<std::string> bands;
    for (int from = 15; from < 80; from += 5)
        bands.push_back(fmt::format("{}-{}", from, from + 4));
    bands.insert(bands.end(), {"80+", "not stated"});
    return bands;
}

std::optional<double> number_in(const std::string& text) {
    double number = 0;
    const auto* last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    return error == std::errc() && end == last ? std::optional(number) : std::nullopt;
}

} // namespace

std::vector<ObserverQuestion> standard_questions() {
    const auto choice = [](std::string id, std::string ask, std::vector<std::string> choices,
                           std::vector<std::string> passing = {}) {
        return ObserverQuestion{std::move(id),
                                std::move(ask),
                                Kind::Choice,
                                std::move(choices),
                                0,
                                0,
                                std::move(passing),
                                {},
                                {},
                                0};
    };
    const std::vector<std::string> yes_no{"yes", "no"};
    return {choice("age", "Age band", age_bands()),
            choice("sex", "Sex, as the observer wishes to state it",
                   {"female", "male", "other", "not stated"}),
            choice("glasses", "Wears glasses or lenses in the sitting", yes_no),
            {"acuity",
             "Decimal visual acuity of both eyes at the viewing distance (20/20 is 1)",
             Kind::Number,
             {},
             0.05,
             3,
             {},
             0.67,
             {},
             0},
            {"ishihara_errors",
             "Errors on the 12 screening plates of the Ishihara test",
             Kind::Number,
             {},
             0,
             12,
             {},
             {},
             2,
             0},
            choice("ishihara_medium", "The Ishihara plates were", {"print", "screen"}),
            choice("expert", "Picture quality is part of the observer's work", yes_no),
            choice("worked_on_methods", "Took part in making what is compared", yes_no, {"no"})};
}

Expected<std::string> checked_answer(const ObserverQuestion& question, const std::string& answer) {
    const auto refuse = [&](const std::string& wanted) {
        return tl::unexpected(fmt::format("{}: \"{}\", expected {}", question.id, answer, wanted));
    };
    if (question.kind == Kind::Choice) {
        if (std::find(question.choices.begin(), question.choices.end(), answer) ==
            question.choices.end())
            return refuse(fmt::format("one of {}", fmt::join(question.choices, ", ")));
        return answer;
    }
    const auto number = number_in(answer);
    if (!number || !(*number >= question.least && *number <= question.greatest))
        return refuse(fmt::format("a number from {} to {}", question.least, question.greatest));
    return fmt::format("{}", *number);
}

bool passes(const ObserverQuestion& question, const std::string& answer) {
    if (question.kind == Kind::Choice)
        return question.passes.empty() || std::find(question.passes.begin(), question.passes.end(),
                                                    answer) != question.passes.end();
    const auto number = number_in(answer);
    return number && (!question.passes_from || *number >= *question.passes_from) &&
           (!question.passes_up_to || *number <= *question.passes_up_to);
}

std::string screening(const std::vector<ObserverQuestion>& questions,
                      const std::map<std::string, std::string>& answers) {
    std::vector<std::string> failed;
    for (const auto& question : questions) {
        const auto answer = answers.find(question.id);
        EXPECTS(answer != answers.end());
        if (!passes(question, answer->second))
            failed.push_back(question.id);
    }
    return failed.empty() ? "passed" : fmt::format("failed: {}", fmt::join(failed, ", "));
}

} // namespace protocols
