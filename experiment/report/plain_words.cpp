// Sentences from findings.  Nothing is called significant without test, level and units.
#include "experiment/report/plain_words.h"

#include "experiment/report/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

namespace {

using analysis::Findings;
using analysis::anova::WithinEffect;

// More pairs than this are left to the table.
constexpr std::size_t pairs_in_a_sentence = 6;

std::string plural(std::size_t count, const std::string& one) {
    return fmt::format("{} {}{}", count, one, count == 1 ? "" : "s");
}

std::string in_votes(const ReportContents& contents, const analysis::RankedCondition& place) {
    return fmt::format("{} ({}, {})", condition_label(contents, place.condition),
                       decimal(place.mean_votes, 2), percent(place.share));
}

std::string order_in_words(const ReportContents& contents) {
    const auto& ranking = contents.findings.ranking;
    const std::size_t best = static_cast<std::size_t>(
        std::ranges::count(ranking, ranking.front().rank, &analysis::RankedCondition::rank));
    std::vector<std::string> leaders;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < ranking.size(); ++i)
        (i < best ? leaders : others).push_back(in_votes(contents, ranking[i]));
    const std::string unit = fmt::format(
        " The first number is the mean of votes per round, of {} possible; the second is the share "
        "of comparisons won.",
        ranking.size() - 1);
    if (others.empty())
        return fmt::format("All conditions were chosen equally often: {}.", listed(leaders)) + unit;
    if (best > 1)
        return fmt::format("Chosen most often, and equally often, were {}, before {}.",
                           listed(leaders), listed(others)) +
               unit;
    return fmt::format("{} was chosen most often, before {}.", leaders.front(), listed(others)) +
           unit;
}

std::size_t analysed_observers(const Findings& findings) {
    return findings.within.empty() ? 0 : findings.within.front().analysis.observers;
}

// p corrected for unequal variances of differences: Greenhouse and Geisser's when these are very
// unequal, else Huynh and Feldt's, the usual rule.
struct Quoted {
    double p = 0;
    std::string how; ///< of the correction; "" where there is none
};

Quoted quoted_p(const WithinEffect& effect) {
    const auto& sphericity = effect.sphericity;
    if (std::isnan(sphericity.greenhouse_geisser))
        return {effect.test.p, ""};
    if (sphericity.greenhouse_geisser < 0.75)
        return {sphericity.p_greenhouse_geisser, "Greenhouse and Geisser's correction"};
    return {sphericity.p_huynh_feldt, "Huynh and Feldt's correction"};
}

std::string f_in_words(const WithinEffect& effect) {
    std::string text =
        fmt::format("F({}, {}) = {}, {}", degrees(effect.test.df1), degrees(effect.test.df2),
                    significant(effect.test.f, 4), p_equals(effect.test.p, effect.test.log10_p));
    if (const auto quoted = quoted_p(effect); !quoted.how.empty())
        text += fmt::format(" ({} with {})", p_equals(quoted.p), quoted.how);
    return text + fmt::format(", partial eta squared {}", decimal(effect.eta_squared_partial, 3));
}

std::string effect_in_words(const ReportContents& contents) {
    const auto& findings = contents.findings;
    const auto* effect = findings.method_effect();
    if (effect == nullptr)
        return fmt::format("No analysis of variance: {}.", findings.why_no_anova.empty()
                                                               ? "it was not computed"
                                                               : findings.why_no_anova);
    if (std::isnan(effect->test.p))
        return fmt::format("The analysis of variance has no answer: {}.", effect->test.reason);
    const bool differ = quoted_p(*effect).p < findings.options.level;
    return fmt::format(
        "{}: repeated-measures analysis of variance of the {} observers' mean votes, {}, at the {} "
        "level. {}{}",
        differ ? "The conditions differ by more than observers do among themselves"
               : "A difference between the conditions was not found",
        analysed_observers(findings), f_in_words(*effect), percent(findings.options.level),
        findings.design.simulated
            ? "The units are observers, and here at least one of them is simulated."
            : "The units are observers: this is about people like them, and these scenes.",
        differ ? "" : " That does not show them to be equal.");
}

std::string pairs_in_words(const ReportContents& contents) {
    const auto& test = contents.findings.within_tukey;
    std::vector<std::string> alike;
    std::size_t different = 0;
    for (const auto& pair : test.pairs) {
        if (pair.significant)
            ++different;
        else
            alike.push_back(fmt::format("{} and {}", condition_label(contents, pair.first),
                                        condition_label(contents, pair.second)));
    }
    const std::string by =
        fmt::format("By Tukey's test at the {} level for all {} together ({} error degrees of "
                    "freedom), ",
                    percent(test.level), plural(test.pairs.size(), "pair"), degrees(test.df));
    if (alike.empty())
        return by + "every condition differs from every other.";
    if (different == 0)
        return by + "no two conditions differ.";
    if (alike.size() > pairs_in_a_sentence)
        return by +
               fmt::format("{} differ; the table of pairs says which.", plural(different, "pair"));
    return by + fmt::format("all pairs differ except {}.", listed(alike));
}

} // namespace

std::string listed(const std::vector<std::string>& items) {
    std::string text;
    for (std::size_t i = 0; i < items.size(); ++i)
        text += (i == 0 ? "" : i + 1 == items.size() ? " and " : ", ") + items[i];
    return text;
}

std::string letters_in_words(const ReportContents& contents) {
    const auto& findings = contents.findings;
    if (std::ranges::all_of(findings.ranking,
                            [](const auto& place) { return place.letters.empty(); }))
        return "";
    return fmt::format(" Conditions that share a letter are not told apart by Tukey's test at the "
                       "{} level.",
                       percent(findings.within_tukey.level));
}

std::vector<std::string> result_in_words(const ReportContents& contents) {
    const auto& findings = contents.findings;
    std::vector<std::string> paragraphs{order_in_words(contents), effect_in_words(contents)};
    if (!findings.within_tukey.pairs.empty())
        paragraphs.push_back(pairs_in_words(contents));
    return paragraphs;
}

std::vector<std::string> methods_in_words(const ReportContents& contents) {
    const auto& findings = contents.findings;
    const auto& design = findings.design;
    std::vector<std::string> paragraphs{fmt::format(
        "A round is one observer, one session, one scene shown in one way; in a complete round "
        "every pair of the {} is compared. A condition's score in a round is its number of votes, "
        "0 to {}{}. Scores are averaged over rounds for each observer, then over observers.",
        plural(design.conditions.size(), "condition"), design.conditions.size() - 1,
        design.ties > 0 ? "; a tie is half a vote for each" : "")};
    if (!findings.within.empty())
        paragraphs.push_back(fmt::format(
            "Within a round the scores always add up to the same sum, so only the condition and "
            "its interactions can have an effect. The default test is the analysis of variance "
            "within observers: condition is fixed, observers ({}) are random, and the error is how "
            "differently they judge the conditions. Pairs are compared by Tukey's studentized "
            "range with the same error; letters follow from it. The level is {} throughout.",
            analysed_observers(findings), percent(findings.options.level)));
    return paragraphs;
}

} // namespace experiment::report
