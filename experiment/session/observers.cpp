// Simulated observers.
#include "experiment/session/observers.h"

#include "protocols/digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

namespace experiment::session {

namespace {

using protocols::ConditionId;

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const auto end = text.find(separator);
        parts.push_back(text.substr(0, end));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

template <class Number>
std::optional<Number> number_in(std::string_view text) {
    Number number{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size())
        return std::nullopt;
    return number;
}

// A finite number within bounds.
std::optional<double> real_in(std::string_view text, double least, double greatest) {
    const auto number = number_in<double>(text);
    return number && *number >= least && *number <= greatest ? number : std::nullopt;
}

constexpr double huge = 1e6; // of a score, a noise or a bias: no unit makes sense beyond

tl::unexpected<std::string> refusal(std::string_view part, const std::string& expected) {
    return tl::unexpected(fmt::format("simulated observer: \"{}\", expected {}", part, expected));
}

std::string names_of(const protocols::Study& study) {
    std::string names;
    for (const auto& condition : study.conditions)
        names += (names.empty() ? "" : ", ") + condition.id.value;
    return names;
}

std::map<ConditionId, double> even_scores(const protocols::Study& study) {
    std::map<ConditionId, double> scores;
    const auto count = study.conditions.size();
    for (std::size_t i = 0; i < count; ++i)
        scores[study.conditions[i].id] =
            count < 2 ? 1.0 : 1.0 - static_cast<double>(i) / static_cast<double>(count - 1);
    return scores;
}

Expected<std::map<ConditionId, double>> parse_scores(std::string_view text,
                                                     const protocols::Study& study) {
    std::map<ConditionId, double> scores;
    for (const auto part : split(text, ',')) {
        const auto colon = part.rfind(':');
        const ConditionId id{std::string(part.substr(0, colon))};
        if (std::ranges::find(study.conditions, id, &protocols::Condition::id) ==
            study.conditions.end())
            return refusal(part, "a condition of the study: " + names_of(study));
        const auto score = colon == std::string_view::npos
                               ? std::nullopt
                               : real_in(part.substr(colon + 1), -huge, huge);
        if (!score)
            return refusal(part, "a condition and its score, like shss-25:1.0");
        if (!scores.emplace(id, *score).second)
            return refusal(part, "every condition once");
    }
    for (const auto& condition : study.conditions)
        if (!scores.contains(condition.id))
            return refusal(text, "a score for " + condition.id.value + ", too");
    return scores;
}

// The next two draws, made a standard normal number: Box and Muller's cosine.
double draw_normal(protocols::Rng& rng) {
    const auto radius = std::sqrt(-2.0 * std::log(1.0 - protocols::draw_unit(rng)));
    return radius * std::cos(2.0 * std::numbers::pi * protocols::draw_unit(rng));
}

} // namespace

Expected<SimulatedObserver> parse_simulated_observer(std::string_view text,
                                                     const protocols::Study& study) {
    SimulatedObserver observer;
    observer.scores = even_scores(study);
    if (text.empty())
        return observer;
    std::set<std::string_view> named;
    for (const auto part : split(text, ';')) {
        const auto equals = part.find('=');
        const auto name = part.substr(0, equals);
        const auto value =
            equals == std::string_view::npos ? std::string_view() : part.substr(equals + 1);
        if (!named.insert(name).second)
            return refusal(part, fmt::format("{} once", name));
        const auto take = [&](double& place, double least, double greatest) {
            const auto number = real_in(value, least, greatest);
            place = number.value_or(place);
            return number.has_value();
        };
        if (name == "scores") {
            auto scores = parse_scores(value, study);
            if (!scores)
                return tl::unexpected(scores.error());
            observer.scores = std::move(*scores);
        } else if (name == "noise") {
            if (!take(observer.noise, 1e-6, huge))
                return refusal(part, "a standard deviation above 0");
        } else if (name == "bias") {
            if (!take(observer.side_bias, -huge, huge))
                return refusal(part, "a number");
        } else if (name == "lapse") {
            if (!take(observer.lapse, 0, 1))
                return refusal(part, "a share of answers, 0 to 1");
        } else if (name == "seed") {
            const auto seed = number_in<std::uint64_t>(value);
            if (!seed)
                return refusal(part, "a whole number, 0 or more");
            observer.seed = *seed;
        } else {
            return refusal(part, "scores=, noise=, bias=, lapse= or seed=, separated by ';'");
        }
    }
    return observer;
}

std::string text_of(const SimulatedObserver& observer) {
    std::string scores;
    for (const auto& [condition, score] : observer.scores)
        scores += fmt::format("{}{}:{}", scores.empty() ? "" : ",", condition.value, score);
    return fmt::format("scores={};noise={};bias={};lapse={};seed={}", scores, observer.noise,
                       observer.side_bias, observer.lapse, observer.seed);
}

Key key_of(const SimulatedAnswer& answer, protocols::Response response) {
    using protocols::Response;
    const bool alike = std::abs(answer.preference) < 0.25;
    if (response == Response::SevenGrades) {
        const auto strength = std::abs(answer.preference);
        const int grade = alike ? 0 : strength < 0.75 ? 1 : strength < 1.5 ? 2 : 3;
        const bool right = answer.side == protocols::Side::Right;
        return static_cast<Key>(static_cast<int>(Key::Same) + (right ? grade : -grade));
    }
    if (response == Response::WithNotSure && alike)
        return Key::NotSure;
    return answer.side == protocols::Side::Left ? Key::Left : Key::Right;
}

SimulatedAnswer answer(const SimulatedObserver& observer,
                       const std::string& study,
                       const protocols::ObserverId& name,
                       int session,
                       int trial_number,
                       const protocols::Trial& trial) {
    const auto digest = protocols::sha256(std::string_view(fmt::format(
        "{}|{}|{}|{}|{}|simulated", study, observer.seed, name.value, session, trial_number)));
    protocols::Seed seed{};
    std::copy_n(digest.begin(), seed.size(), seed.begin());
    protocols::Rng rng(seed);

    const auto left = observer.scores.at(trial.left) + observer.side_bias;
    const auto right = observer.scores.at(trial.right);
    const auto difference = left - right + observer.noise * (draw_normal(rng) - draw_normal(rng));
    const bool lapses = protocols::draw_unit(rng) < observer.lapse;
    const bool chooses_left = lapses ? protocols::draw_coin(rng) : difference > 0;
    // People are quick where they are sure; log-normal about 1.6 s at most, never below 0.4 s.
    const auto clarity = 1.0 + std::abs(difference) / observer.noise;
    const auto seconds = 0.4 + 1.2 / clarity * std::exp(0.4 * draw_normal(rng)) + 0.3;
    const double lapse_preference = chooses_left ? -0.5 : 0.5;
    return {chooses_left ? protocols::Side::Left : protocols::Side::Right,
            std::chrono::nanoseconds(std::llround(seconds * 1e9)),
            lapses ? lapse_preference : -difference / observer.noise};
}

} // namespace experiment::session
