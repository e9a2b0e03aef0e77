// HTML tables of votes and tests.
#include "experiment/report/tables.h"

#include "experiment/report/html.h"
#include "experiment/report/numbers.h"
#include "experiment/report/shares.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <regex>
#include <utility>

namespace experiment::report {

namespace {

using analysis::anova::FTest;
using analysis::anova::Variation;

std::string interval(double lower, double upper, int decimals) {
    return std::isnan(lower) || std::isnan(upper)
               ? no_number
               : decimal(lower, decimals) + " to " + decimal(upper, decimals);
}

// "0.868 (0.747 to 0.907)"
std::string eta_cell(const analysis::anova::WithinEffect& effect) {
    const auto& [lower, upper] = effect.eta_interval;
    return decimal(effect.eta_squared_partial, 3) +
           (std::isnan(lower) ? "" : " (" + interval(lower, upper, 3) + ")");
}

// The analysis calls the factor under study "method" and joins names by ':' or "_x_"; people are
// told of conditions.
std::string effect_name(const std::string& name) {
    static const std::regex joint(":|_x_");
    std::string text;
    for (std::sregex_token_iterator factor(name.begin(), name.end(), joint, -1), end; factor != end;
         ++factor)
        text += (text.empty() ? "" : " \u00d7 ") +
                (factor->str() == "method" ? "condition" : factor->str());
    return escaped(text);
}

std::vector<std::string> variation_cells(const Variation& variation) {
    return {significant(variation.ss, 6), degrees(variation.df),
            variation.df > 0 ? significant(variation.ms(), 4) : no_number};
}

std::string error_row(const Variation& variation, std::size_t columns) {
    std::vector<std::string> cells{"error"};
    for (auto& cell : variation_cells(variation))
        cells.push_back(std::move(cell));
    cells.resize(columns);
    std::string html = html_row(cells);
    return html.replace(0, 4, "<tr class=\"error\">");
}

// One effect of an analysis of variance.
struct EffectRow {
    std::string name;
    Variation variation;
    FTest test;
    std::optional<Variation> error;
    std::vector<std::string> more; ///< cells after p
};

// Effects with their errors; those without a test last, together, with the reason.
std::string effect_rows(const std::vector<EffectRow>& effects) {
    std::string rows;
    std::map<std::string, std::vector<std::string>> untested;
    std::size_t columns = 0;
    for (const auto& effect : effects) {
        columns = 6 + effect.more.size();
        if (std::isnan(effect.test.f)) {
            untested[effect.test.reason].push_back(effect_name(effect.name));
            continue;
        }
        std::vector<std::string> cells{effect_name(effect.name)};
        for (auto& cell : variation_cells(effect.variation))
            cells.push_back(std::move(cell));
        cells.push_back(significant(effect.test.f, 4));
        cells.push_back(p_value(effect.test.p, effect.test.log10_p));
        cells.insert(cells.end(), effect.more.begin(), effect.more.end());
        rows += html_row(cells);
        if (effect.error)
            rows += error_row(*effect.error, columns);
    }
    for (const auto& [reason, names] : untested)
        rows += fmt::format("<tr class=\"why\"><td colspan=\"{}\">{}: {}</td></tr>\n", columns,
                            fmt::join(names, "; "), escaped(reason));
    return rows;
}

// "2 PRT" before a row, and its number or name above a column.
std::vector<std::string> matrix_heads(const ReportContents& contents, MatrixHeads heads) {
    std::vector<std::string> cells{"<span class=\"corner\">row over column</span>"};
    const auto& ranking = contents.findings.ranking;
    for (std::size_t i = 0; i < ranking.size(); ++i) {
        const auto label = escaped(condition_label(contents, ranking[i].condition));
        cells.push_back(heads == MatrixHeads::Names
                            ? label
                            : fmt::format("<abbr title=\"{}\">{}</abbr>", label, i + 1));
    }
    return cells;
}

} // namespace

std::string ranking_table(const ReportContents& contents) {
    const auto& findings = contents.findings;
    const auto level = percent(1 - findings.options.level);
    std::string rows;
    for (const auto& place : findings.ranking)
        rows += html_row({escaped(condition_label(contents, place.condition)),
                          decimal(place.rank, place.rank == std::floor(place.rank) ? 0 : 1),
                          votes(place.votes), decimal(place.mean_votes, 3),
                          interval(place.lower, place.upper, 3), percent(place.share),
                          place.letters.empty() ? no_number : escaped(place.letters)});
    return html_table("numbers",
                      html_head({"Condition", "Rank", "Votes", "Mean votes per round",
                                 level + " interval", "Share", "Letters"}),
                      rows);
}

std::string vote_matrix_table(const ReportContents& contents,
                              const analysis::VoteMatrix& matrix,
                              MatrixHeads heads) {
    const auto& ranking = contents.findings.ranking;
    std::string rows;
    for (std::size_t i = 0; i < ranking.size(); ++i) {
        const auto a = ranking[i].condition;
        rows += fmt::format("<tr><th scope=\"row\">{}{}</th>",
                            heads == MatrixHeads::Names ? "" : fmt::format("{}\u2002", i + 1),
                            escaped(condition_label(contents, a)));
        for (const auto& other : ranking) {
            const auto b = other.condition;
            rows += a == b ? "<td class=\"self\"></td>"
                           : fmt::format("<td style=\"background:{}\">{}<small>{}</small></td>",
                                         share_colour(share_over(matrix, a, b)),
                                         votes(votes_over(matrix, a, b)),
                                         percent(share_over(matrix, a, b)));
        }
        rows += "</tr>\n";
    }
    return html_table(heads == MatrixHeads::Names ? "matrix" : "matrix small",
                      html_head(matrix_heads(contents, heads)), rows);
}

std::string within_table(const analysis::anova::WithinAnalysis& analysis) {
    std::vector<EffectRow> effects;
    for (const auto& effect : analysis.effects)
        effects.push_back({effect.name,
                           effect.effect,
                           effect.test,
                           effect.error,
                           {p_value(effect.sphericity.p_greenhouse_geisser),
                            p_value(effect.sphericity.p_huynh_feldt), eta_cell(effect),
                            decimal(effect.eta_squared_generalized, 3)}});
    return html_table("numbers anova",
                      html_head({"Source", "SS", "df", "MS", "F", "p", "p GG", "p HF",
                                 "\u03b7\u00b2\u00a0part.", "\u03b7\u00b2\u00a0gen."}),
                      effect_rows(effects));
}

std::string one_way_table(const analysis::anova::OneWay& analysis) {
    return html_table(
        "numbers anova",
        html_head({"Source", "SS", "df", "MS", "F", "p", "\u03b7\u00b2", "\u03c9\u00b2"}),
        effect_rows({{"condition",
                      analysis.between,
                      analysis.test,
                      analysis.within,
                      {decimal(analysis.eta_squared, 3), decimal(analysis.omega_squared, 3)}}}));
}

std::string two_way_table(const analysis::TwoWayFixed& analysis) {
    std::vector<EffectRow> effects;
    for (const auto& row : analysis.rows) {
        auto test = row.test;
        if (row.variation.ss == 0) { // 0 over the pooled residual is no finding: it cannot be else
            test = {};
            test.reason = "not estimable: scores are ipsative";
        }
        effects.push_back(
            {row.name,
             row.variation,
             test,
             {},
             {decimal(row.eta_squared_partial, 3), decimal(row.omega_squared_partial, 3)}});
    }
    return html_table("numbers anova",
                      html_head({"Source", "SS", "df", "MS", "F", "p", "\u03b7\u00b2\u00a0part.",
                                 "\u03c9\u00b2\u00a0part."}),
                      effect_rows(effects) + error_row(analysis.residual, 8));
}

std::string pair_table(const ReportContents& contents) {
    const auto& findings = contents.findings;
    const auto holm_of = [&](const analysis::anova::RangePair& pair) {
        const auto same = std::ranges::find_if(findings.paired_t, [&](const auto& t) {
            return t.first == pair.first && t.second == pair.second;
        });
        return same == findings.paired_t.end() ? std::string(no_number) : p_value(same->p_holm);
    };
    std::string rows;
    for (const auto& pair : findings.within_tukey.pairs) {
        auto better = escaped(condition_label(contents, pair.first));
        auto worse = escaped(condition_label(contents, pair.second));
        const bool turned = pair.difference < 0;
        if (turned)
            std::swap(better, worse);
        rows += html_row(
            {better + " \u2212 " + worse, decimal(std::abs(pair.difference), 3),
             turned ? interval(-pair.upper, -pair.lower, 3) : interval(pair.lower, pair.upper, 3),
             decimal(pair.q, 2), p_value(pair.p), holm_of(pair),
             pair.significant ? "<strong>yes</strong>" : "no"});
    }
    return html_table(
        "numbers pairs",
        html_head({"Pair", "Difference",
                   "Simultaneous " + percent(1 - findings.within_tukey.level) + " interval", "q",
                   "p Tukey", "p Holm", "Differs"}),
        rows);
}

} // namespace experiment::report
