#include "analysis/findings_text.h"

#include "analysis/scaling/scales_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analysis {

namespace {

std::string value(double number, int digits = 4) {
    if (std::isnan(number))
        return "n/e";
    return fmt::format("{:.{}f}", number, digits);
}

std::size_t name_width(const Findings& findings) {
    std::size_t width = 8;
    for (const auto& name : findings.design.conditions)
        width = std::max(width, name.size());
    return width;
}

void design_table(std::string& text, const Findings& findings) {
    const auto& d = findings.design;
    text += fmt::format("{}{} votes of {} observers in {} sessions: {} scenes, {} conditions",
                        d.simulated ? "SIMULATED: " : "", d.votes, d.observers.size(),
                        d.sessions.size(), d.scenes, d.conditions.size());
    text +=
        fmt::format(", {} missing, {} ties.\n\n",
                    d.missing_known ? fmt::format("{}", d.missing) : "an unknown number", d.ties);
}

void ranking_table(std::string& text, const Findings& findings) {
    const auto width = name_width(findings);
    text +=
        fmt::format("{:>4}  {:<{}}  {:>8}  {:>11}  {:>7}  {:>18}  {}\n", "rank", "method", width,
                    "votes", "votes/round", "share",
                    fmt::format("{:g} % interval", 100 * (1 - findings.options.level)), "letters");
    for (const auto& place : findings.ranking)
        text += fmt::format("{:>4g}  {:<{}}  {:>8g}  {:>11}  {:>7}  {:>18}  {}\n", place.rank,
                            findings.design.conditions[place.condition], width, place.votes,
                            value(place.mean_votes), value(place.share),
                            fmt::format("{} to {}", value(place.lower), value(place.upper)),
                            place.letters);
    text += "\n";
}

void matrix_table(std::string& text, const Findings& findings) {
    const auto width = name_width(findings);
    const auto& matrix = findings.matrices[0].matrix;
    text += fmt::format("{:<{}}", "row over column", width + 8);
    for (const auto& column : findings.ranking)
        text += fmt::format("  {:>{}}", findings.design.conditions[column.condition], width);
    text += "\n";
    for (const auto& row : findings.ranking) {
        text += fmt::format("{:<{}}", findings.design.conditions[row.condition], width + 8);
        for (const auto& column : findings.ranking)
            text +=
                row.condition == column.condition
                    ? fmt::format("  {:>{}}", "-", width)
                    : fmt::format("  {:>{}}", matrix.wins(row.condition, column.condition), width);
        text += "\n";
    }
    text += "\n";
}

void within_table(std::string& text, const NamedWithin& named) {
    text += fmt::format("Within observers ({})\n{:<28} {:>10} {:>4} {:>10} {:>5} {:>9} {:>10} "
                        "{:>10} {:>10} {:>7}  interval\n",
                        named.name, "effect", "SS", "df", "SS error", "df", "F", "p", "p GG",
                        "p HF", "eta2 p");
    for (const auto& e : named.analysis.effects)
        text += fmt::format(
            "{:<28} {:>10} {:>4g} {:>10} {:>5g} {:>9} {:>10} {:>10} {:>10} {:>7}{}\n", e.name,
            value(e.effect.ss), e.effect.df, value(e.error.ss), e.error.df, value(e.test.f),
            p_text(e.test.p, e.test.log10_p), p_text(e.sphericity.p_greenhouse_geisser),
            p_text(e.sphericity.p_huynh_feldt), value(e.eta_squared_partial, 3),
            e.test.reason.empty() ? fmt::format("  {} to {}", value(e.eta_interval.lower, 3),
                                                value(e.eta_interval.upper, 3))
                                  : "  " + e.test.reason);
    text += "\n";
}

void pair_table(std::string& text, const Findings& findings) {
    const auto width = name_width(findings);
    const auto& test = findings.within_tukey;
    text += fmt::format("Pairs: Tukey within observers, level {}, {:g} error df, critical q {}\n",
                        test.level, test.df, value(test.q_critical));
    text += fmt::format("{:<{}}  {:<{}}  {:>9}  {:>20}  {:>10}  {:>10}\n", "", width, "", width,
                        "diff", "interval", "p Tukey", "p Holm t");
    for (std::size_t i = 0; i < test.pairs.size(); ++i) {
        const auto& pair = test.pairs[i];
        text += fmt::format("{:<{}}  {:<{}}  {:>9}  {:>20}  {:>10}  {:>10}{}\n",
                            findings.design.conditions[pair.first], width,
                            findings.design.conditions[pair.second], width, value(pair.difference),
                            fmt::format("{} to {}", value(pair.lower), value(pair.upper)),
                            p_text(pair.p, pair.log10_p), p_text(findings.paired_t[i].p_holm),
                            pair.significant ? "  *" : "");
    }
    text += "\n";
}

void paper_table(std::string& text, const OneWayFindings& found) {
    const auto& a = found.anova;
    text += fmt::format("As in the paper: one-way, unit {}: F({:g}, {:g}) = {}, {}, eta2 = {}\n",
                        found.unit, a.between.df, a.within.df, value(a.test.f),
                        p_phrase(a.test.p, a.test.log10_p), value(a.eta_squared));
}

} // namespace

std::string p_text(double p, double log10_p) {
    if (std::isnan(p))
        return "n/e";
    if (p == 0 && !(log10_p < 0 && std::isfinite(log10_p)))
        return "0";
    if (p < 1e-300)
        return fmt::format("< 1e-300 (log10 p = {:.1f})", log10_p);
    return fmt::format("{:.3g}", p);
}

std::string p_phrase(double p, double log10_p) {
    const auto text = p_text(p, log10_p);
    return text.starts_with("<") ? "p " + text : "p = " + text;
}

std::string findings_text(const Findings& findings) {
    std::string text;
    design_table(text, findings);
    ranking_table(text, findings);
    matrix_table(text, findings);
    for (const auto& named : findings.within)
        within_table(text, named);
    if (!findings.within.empty())
        pair_table(text, findings);
    if (findings.one_way_observers)
        paper_table(text, *findings.one_way_observers);
    if (findings.one_way_rounds)
        paper_table(text, *findings.one_way_rounds);
    text += "\n";
    text += scaling::scales_text(findings.scales, findings.design.conditions);
    for (const auto& note : findings.notes)
        text += "- " + note.text + "\n";
    return text;
}

} // namespace analysis
