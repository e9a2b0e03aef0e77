// HTML tables of votes and tests.
#include "experiment/report/tables.h"

#include "experiment/report/html.h"
#include "experiment/report/numbers.h"
#include "experiment/report/shares.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

namespace {

using analysis::anova::FTest;
using analysis::anova::Variation;

std::string interval(double lower, double upper, int decimals) {
    return std::isnan(lower) || std::isnan(upper)
               ? no_number
               : decimal(lower, decimals) + " to " + decimal(upper, decimals);
}

// The analysis calls the factor under study "method"; people are told of conditions.
std::string effect_name(const std::string& name) {
    std::string text;
    for (std::size_t from = 0; from <= name.size();) {
        const auto end = std::min(name.find(':', from), name.size());
        const auto factor = name.substr(from, end - from);
        text += (from == 0 ? "" : " \u00d7 ") + (factor == "method" ? "condition" : factor);
        from = end + 1;
    }
    return escaped(text);
}

std::vector<std::string> variation_cells(const Variation& variation) {
    return {significant(variation.ss, 6), significant(variation.df, 4),
            variation.df > 0 ? significant(variation.ms(), 4) : no_number};
}

// A row of an analysis of variance: its test, or why there is none.
std::string tested_row(const std::string& name,
                       const Variation& variation,
                       const FTest& test,
                       const std::vector<std::string>& more) {
    std::vector<std::string> cells{effect_name(name)};
    for (auto& cell : variation_cells(variation))
        cells.push_back(std::move(cell));
    if (std::isnan(test.f)) {
        std::string html = html_row(cells);
        html.resize(html.rfind("</tr>"));
        return html + fmt::format("<td class=\"why\" colspan=\"{}\">{}</td></tr>\n",
                                  2 + more.size(), escaped(test.reason));
    }
    cells.push_back(significant(test.f, 4));
    cells.push_back(p_value(test.p, test.log10_p));
    cells.insert(cells.end(), more.begin(), more.end());
    return html_row(cells);
}

std::string error_row(const std::string& name, const Variation& variation, std::size_t columns) {
    std::vector<std::string> cells{effect_name(name)};
    for (auto& cell : variation_cells(variation))
        cells.push_back(std::move(cell));
    cells.resize(columns);
    std::string html = html_row(cells);
    return html.replace(0, 4, "<tr class=\"error\">");
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
                 html_head({"Condition", "Rank", "Votes", "Mean votes per round", level + " interval",
                       "Share", "Letters"}),
                 rows);
}

std::string vote_matrix_table(const ReportContents& contents, const analysis::VoteMatrix& matrix) {
    const auto& ranking = contents.findings.ranking;
    std::vector<std::string> names{"<span class=\"corner\">row over column</span>"};
    for (const auto& place : ranking)
        names.push_back(escaped(condition_label(contents, place.condition)));
    std::string rows;
    for (std::size_t i = 0; i < ranking.size(); ++i) {
        rows += fmt::format("<tr><th scope=\"row\">{}</th>", names[i + 1]);
        for (const auto& other : ranking) {
            const auto a = ranking[i].condition;
            if (a == other.condition) {
                rows += "<td class=\"self\"></td>";
                continue;
            }
            const double share = share_over(matrix, a, other.condition);
            rows += fmt::format("<td style=\"background:{}\">{}<small>{}</small></td>",
                                share_colour(share), votes(votes_over(matrix, a, other.condition)),
                                percent(share));
        }
        rows += "</tr>\n";
    }
    return html_table("matrix", html_head(names), rows);
}

std::string within_table(const analysis::anova::WithinAnalysis& analysis) {
    std::string rows;
    for (const auto& effect : analysis.effects) {
        rows += tested_row(effect.name, effect.effect, effect.test,
                           {p_value(effect.sphericity.p_greenhouse_geisser),
                            p_value(effect.sphericity.p_huynh_feldt),
                            decimal(effect.eta_squared_partial, 3),
                            decimal(effect.eta_squared_generalized, 3)});
        rows += error_row(effect.name + ":observer", effect.error, 10);
    }
    return html_table("numbers anova",
                 html_head({"Source", "SS", "df", "MS", "F", "p", "p GG", "p HF",
                       "\u03b7\u00b2 partial", "\u03b7\u00b2 gen."}),
                 rows);
}

std::string one_way_table(const analysis::anova::OneWay& analysis) {
    return html_table("numbers anova",
                 html_head({"Source", "SS", "df", "MS", "F", "p", "\u03b7\u00b2", "\u03c9\u00b2"}),
                 tested_row("condition", analysis.between, analysis.test,
                            {decimal(analysis.eta_squared, 3), decimal(analysis.omega_squared, 3)}) +
                     error_row("within", analysis.within, 8));
}

std::string two_way_table(const analysis::TwoWayFixed& analysis) {
    std::string rows;
    for (const auto& effect : analysis.rows)
        rows += tested_row(effect.name, effect.variation, effect.test,
                           {decimal(effect.eta_squared_partial, 3),
                            decimal(effect.omega_squared_partial, 3)});
    rows += error_row("residual", analysis.residual, 8);
    return html_table("numbers anova",
                 html_head({"Source", "SS", "df", "MS", "F", "p", "\u03b7\u00b2 partial",
                       "\u03c9\u00b2 partial"}),
                 rows);
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
    for (const auto& pair : findings.within_tukey.pairs)
        rows += html_row({escaped(condition_label(contents, pair.first)) + " \u2212 " +
                         escaped(condition_label(contents, pair.second)),
                     decimal(pair.difference, 3), interval(pair.lower, pair.upper, 3),
                     decimal(pair.q, 2), p_value(pair.p), holm_of(pair),
                     pair.significant ? "<strong>yes</strong>" : "no"});
    return html_table("numbers",
                 html_head({"Pair", "Difference",
                       "Simultaneous " + percent(1 - findings.within_tukey.level) + " interval",
                       "q", "p Tukey", "p Holm", "Differs"}),
                 rows);
}

} // namespace experiment::report
