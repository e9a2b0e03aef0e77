#include "analysis/findings_notes.h"

#include "analysis/findings_text.h"
#include "analysis/scaling/scales_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace analysis {

namespace {

void design_notes(Findings& findings) {
    const auto& design = findings.design;
    const auto say = [&](std::string text) {
        findings.notes.push_back({"design", std::move(text)});
    };
    if (design.simulated)
        say("These votes are simulated, wholly or in part: they say nothing about people.");
    if (design.skipped_not_main > 0)
        say(fmt::format("{} training and warm-up rows were passed over.", design.skipped_not_main));
    if (!design.missing_known)
        say("Nobody compared every pair equally often in a scene, so how many votes are missing is "
            "not known.");
    for (auto& text : coverage_notes(findings.coverage, design.conditions))
        say(std::move(text));
    if (design.missing > 0)
        say(fmt::format("{} votes are missing; shares of an incomplete design depend on which "
                        "opponents were met.",
                        design.missing));
    if (!design.incomplete_observers.empty())
        say(fmt::format("Left out of the analyses of variance, because they did not answer "
                        "everything: {}.",
                        fmt::join(design.incomplete_observers, ", ")));
    if (design.ties > 0)
        say(fmt::format("{} ties count as half a vote to each side.", design.ties));
    if (design.observers.size() < 5)
        say(fmt::format("Only {} observers: intervals and tests are rough.",
                        design.observers.size()));
}

void within_notes(Findings& findings) {
    const auto say = [&](const char* about, std::string text) {
        findings.notes.push_back({about, std::move(text)});
    };
    if (findings.within.empty()) {
        say("within", "No analysis of variance: " + findings.why_no_anova + ".");
        return;
    }
    say("within",
        fmt::format("Default test: analysis of variance within observers on {} observer means, "
                    "method fixed, observer random, level {}. The unit of analysis is the "
                    "observer, so the conclusion is about observers in general.",
                    findings.within[0].analysis.observers, findings.options.level));
    say("within", "Scores are ipsative: the votes of every complete round sum to a constant, so "
                  "effects without the method (observer, scene, session and their interactions) "
                  "are exactly zero and not estimable.");
    const auto* method = findings.method_effect();
    if (const double e = method->sphericity.greenhouse_geisser; e == e)
        say("within",
            fmt::format("Sphericity: Greenhouse-Geisser epsilon is {:.3f}, so p with the {} "
                        "correction is the one to quote (rule: below 0.75 Greenhouse-Geisser, "
                        "else Huynh-Feldt).",
                        e, e < 0.75 ? "Greenhouse-Geisser" : "Huynh-Feldt"));
    if (const auto& normality = findings.residuals.normality; normality.w == normality.w)
        say("within",
            fmt::format("Residuals: Shapiro-Wilk W = {:.4f}, p = {:.3g}. Votes are counts, "
                        "so with many values the test rejects whatever they do: look at "
                        "the figure.",
                        normality.w, normality.p));
    say("within",
        fmt::format("Without any assumption: labels permuted within observers, {} arrangements "
                    "({}), p = {:.3g}; Friedman on observer means, {}.",
                    findings.permutation.arrangements,
                    findings.permutation.complete ? "all" : "drawn", findings.permutation.p,
                    p_phrase(findings.friedman->p)));
    if (const auto& parts = findings.components; parts.reliability == parts.reliability)
        say("within",
            fmt::format("Over sessions: standard deviation between observers {:.3f}, of "
                        "one observer between sessions {:.3f} votes per round; "
                        "reliability of the conditions' means {:.3f}.",
                        parts.inter_observer_sd, parts.intra_observer_sd, parts.reliability));
    say("pairs",
        fmt::format("Pairs: Tukey's test with the method x observer mean square, simultaneous "
                    "level {}. Conditions that share a letter do not differ significantly, which "
                    "does not mean that they are equal.",
                    findings.options.level));
}

void one_way_notes(Findings& findings) {
    if (findings.one_way_observers)
        findings.notes.push_back(
            {"one_way", "One-way analysis of observer means, as in the paper: its F is t/(t-1) "
                        "times the within-observer F, with more error degrees of freedom. With 4 "
                        "conditions and 10 observers of equal taste it is significant at 5 % in "
                        "11.7 % of experiments (4,000 simulated)."});
    if (findings.one_way_rounds)
        findings.notes.push_back(
            {"one_way",
             "One-way analysis of rounds treats the rounds of one observer as if they came from "
             "different people. Its true level at nominal 5 % grows from 12 % to 86 % as "
             "observers differ more in taste (simulated); it holds for these observers only."});
    if (findings.two_way)
        findings.notes.push_back(
            {"two_way", "The method x " + findings.two_way->factor +
                            " table pools all variation between observers into one residual, as "
                            "graphics papers print it; its F for method carries the caveat of the "
                            "one-way analysis."});
}

void screening_notes(Findings& findings) {
    std::string flagged;
    for (const auto& observer : findings.screening)
        if (!observer.flags.empty())
            flagged += fmt::format("{}{} ({})", flagged.empty() ? "" : "; ", observer.observer,
                                   fmt::join(observer.flags, "; "));
    findings.notes.push_back(
        {"screening", flagged.empty()
                          ? "Screening of observers raised no flag; nobody was left out."
                          : "Worth a look, but nobody was left out: " + flagged + "."});
}

} // namespace

void append_notes(Findings& findings, const VoteTable& table) {
    for (const auto& note : table.notes)
        findings.notes.push_back({"design", note});
    design_notes(findings);
    findings.notes.push_back(
        {"scores", "Scores are votes per round, from 0 to t - 1, averaged over observers and "
                   "scenes; intervals are t intervals between observers."});
    if (findings.design.missing > 0)
        findings.notes.push_back(
            {"scores", "Mean votes and share are means over observers of each observer's share; "
                       "the ranking follows the pooled share, given beside it."});
    within_notes(findings);
    one_way_notes(findings);
    screening_notes(findings);
    for (auto& text : scaling::scale_notes(findings.scales, findings.design.conditions))
        findings.notes.push_back({"scales", std::move(text)});
}

} // namespace analysis
