#include "analysis/anova/table_text.h"

#include "analysis/findings_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace analysis::anova {

namespace {

std::string value(double number) {
    return std::isnan(number) ? "n/e" : fmt::format("{:.6g}", number);
}

std::string interval(double lower, double upper) {
    return std::isnan(lower) ? "" : fmt::format("{} to {}", value(lower), value(upper));
}

const char* type_word(SumsOfSquares type) {
    switch (type) {
    case SumsOfSquares::Sequential:
        return "I";
    case SumsOfSquares::Hierarchical:
        return "II";
    case SumsOfSquares::Partial:
        return "III";
    }
    return "";
}

void terms_table(std::string& text, const TableAnalysis& analysis) {
    std::size_t width = 8;
    for (const auto& term : analysis.terms)
        width = std::max(width, term.name.size());
    const bool repeated = analysis.subjects > 0;
    text += fmt::format("{:<{}}  {:>12} {:>6} {:>12} {:>12} {:>12}  {:>8}  {:<22}", "", width, "SS",
                        "df", "MS", "F", "p", "eta2 p",
                        fmt::format("{:g} % interval", 100 * (1 - analysis.options.level)));
    text += repeated
                ? fmt::format("  {:>12} {:>6} {:>12} {:>12}\n", "SS error", "df", "p GG", "p HF")
                : "\n";
    for (const auto& term : analysis.terms) {
        text += fmt::format("{:<{}}  {:>12} {:>6g} {:>12} {:>12} {:>12}  {:>8}  {:<22}", term.name,
                            width, value(term.effect.ss), term.effect.df, value(term.effect.ms()),
                            value(term.test.f), p_text(term.test.p, term.test.log10_p),
                            std::isnan(term.eta_squared_partial)
                                ? "n/e"
                                : fmt::format("{:.3g}", term.eta_squared_partial),
                            interval(term.eta_interval.lower, term.eta_interval.upper));
        if (term.error)
            text += fmt::format("  {:>12} {:>6g} {:>12} {:>12}", value(term.error->ss),
                                term.error->df, p_text(term.sphericity.p_greenhouse_geisser),
                                p_text(term.sphericity.p_huynh_feldt));
        text += term.test.reason.empty() ? "\n" : "  " + term.test.reason + "\n";
    }
    text += fmt::format("{:<{}}  {:>12} {:>6g} {:>12}\n", "residual", width,
                        value(analysis.residual.ss), analysis.residual.df,
                        value(analysis.residual.ss / analysis.residual.df));
    text += fmt::format("R2 {}, residual SD {}\n\n", value(analysis.r_squared),
                        value(analysis.residual_sd));
}

std::size_t widest(const std::vector<std::string>& names, std::size_t least) {
    for (const auto& name : names)
        least = std::max(least, name.size());
    return least;
}

void levels_table(std::string& text, const LevelComparisons& found) {
    const auto width = widest(found.levels, 5);
    text +=
        fmt::format("{:<{}}  {:>6} {:>12} {:>12}  letters\n", "level", width, "n", "mean", "SD");
    for (std::size_t i = 0; i < found.levels.size(); ++i)
        text += fmt::format("{:<{}}  {:>6} {:>12} {:>12}  {}\n", found.levels[i], width, found.n[i],
                            value(found.mean[i]), value(found.sd[i]),
                            found.letters.empty() ? "(too many)" : found.letters[i]);
    text += fmt::format("\nPairs: Tukey, simultaneous level {}, critical q {}\n", found.tukey.level,
                        value(found.tukey.q_critical));
    for (std::size_t i = 0; i < found.tukey.pairs.size(); ++i) {
        const auto& pair = found.tukey.pairs[i];
        text += fmt::format("{:<{}}  {:<{}}  {:>12}  {:<28}  p Tukey {:>9}  p Holm t {:>9}",
                            found.levels[pair.first], width, found.levels[pair.second], width,
                            value(pair.difference), interval(pair.lower, pair.upper),
                            p_text(pair.p, pair.log10_p), p_text(found.t[i].p_holm));
        if (found.welch)
            text += fmt::format("  p Games-Howell {:>9}",
                                p_text(found.games_howell[i].p, found.games_howell[i].log10_p));
        text += pair.significant ? "  *\n" : "\n";
    }
    if (!found.dunnett)
        return;
    text += fmt::format("\nAgainst {}: Dunnett, two-sided, critical t {}\n",
                        found.levels[found.dunnett->control], value(found.dunnett->t_critical));
    for (const auto& pair : found.dunnett->pairs)
        text += fmt::format("{:<{}}  {:>12}  {:<28}  p {:>9}{}\n", found.levels[pair.level], width,
                            value(pair.difference), interval(pair.lower, pair.upper),
                            p_text(pair.p), pair.significant ? "  *" : "");
}

// Between: by the studentized range.  Within: each pair by its own spread over subjects.
void factor_table(std::string& text, const FactorComparisons& found) {
    const auto& means = found.means;
    text += fmt::format("{}, means over the other factors:", found.factor);
    if (!means.reason.empty()) {
        text += fmt::format(" n/e ({})\n\n", means.reason);
        return;
    }
    const auto width = widest(found.levels, 5);
    text += fmt::format("\n{:<{}}  {:>12}  letters\n", "level", width, "mean");
    for (std::size_t i = 0; i < found.levels.size(); ++i)
        text += fmt::format("{:<{}}  {:>12}  {}\n", found.levels[i], width, value(means.mean[i]),
                            means.letters.empty() ? "(too many)" : means.letters[i]);
    text += means.tukey
                ? fmt::format("Pairs: Tukey-Kramer, simultaneous level {}, critical q {}\n",
                              means.tukey->level, value(means.tukey->q_critical))
                : "Pairs: paired t, each with its own error, Holm over the pairs of this factor\n";
    for (std::size_t i = 0; i < means.t.size(); ++i) {
        const auto& pair = means.t[i];
        text += fmt::format("{:<{}}  {:<{}}  {:>12}", found.levels[pair.first], width,
                            found.levels[pair.second], width, value(pair.difference));
        if (means.tukey) {
            const auto& range = means.tukey->pairs[i];
            text += fmt::format("  {:<28}  p Tukey {:>9}", interval(range.lower, range.upper),
                                p_text(range.p, range.log10_p));
        } else {
            text += fmt::format("  t({:g}) {:>10}  p {:>9}", pair.df, value(pair.t),
                                p_text(pair.p, pair.log10_p));
        }
        const bool significant =
            means.tukey ? means.tukey->pairs[i].significant : pair.significant_holm;
        text += fmt::format("  p Holm {:>9}  p Bonferroni {:>9}{}\n", p_text(pair.p_holm),
                            p_text(pair.p_bonferroni), significant ? "  *" : "");
    }
    text += "\n";
}

void check_line(std::string& text, const char* name, const FTest& test) {
    text += fmt::format("{}: F({}, {}) = {}, {}{}\n", name, value(test.df1), value(test.df2),
                        value(test.f), p_phrase(test.p, test.log10_p),
                        test.reason.empty() ? "" : " (" + test.reason + ")");
}

std::string heading(const TableAnalysis& analysis) {
    const auto unit =
        analysis.unit_exponent == 0 ? "" : fmt::format(" / 1e{}", analysis.unit_exponent);
    std::string text = fmt::format("{}{} by {}: ", analysis.columns.response, unit,
                                   fmt::join(analysis.columns.factors, ", "));
    text += analysis.subjects > 0
                ? fmt::format("{} design, {} values of {} {}", analysis.design, analysis.values,
                              analysis.subjects, analysis.columns.subject)
                : fmt::format("{}, {} values", analysis.design, analysis.values);
    return text + fmt::format(", sums of squares of type {}\n\n", type_word(analysis.options.type));
}

} // namespace

std::string table_text(const TableAnalysis& analysis) {
    std::string text = heading(analysis);
    terms_table(text, analysis);
    if (analysis.levels) {
        levels_table(text, *analysis.levels);
        text += "\n";
        if (analysis.levels->welch) {
            check_line(text, "Welch", *analysis.levels->welch);
            check_line(text, "Levene", *analysis.levels->levene);
            check_line(text, "Brown-Forsythe", *analysis.levels->brown_forsythe);
        }
    }
    for (const auto& factor : analysis.factors)
        factor_table(text, factor);
    text += fmt::format("Shapiro-Wilk of the residuals: W = {}, {}{}\n",
                        value(analysis.normality.w), p_phrase(analysis.normality.p),
                        analysis.normality.reason.empty() ? ""
                                                          : " (" + analysis.normality.reason + ")");
    for (const auto& note : analysis.notes)
        text += "- " + note + "\n";
    return text;
}

} // namespace analysis::anova
