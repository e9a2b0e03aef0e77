// gnuplot scripts from findings.
#include "experiment/report/figures.h"

#include "experiment/report/figure_parts.h"
#include "experiment/report/gnuplot.h"
#include "experiment/report/numbers.h"
#include "experiment/report/plain_words.h"
#include "experiment/report/scale_figures.h"
#include "experiment/report/shares.h"
#include "experiment/report/simulated.h"
#include "experiment/report/tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

namespace {

// Conditions down the side, each with its place where columns are known by it.
std::string name_tics(const ReportContents& contents, MatrixHeads heads) {
    std::string tics;
    const auto& ranking = contents.findings.ranking;
    for (std::size_t i = 0; i < ranking.size(); ++i) {
        const auto label = condition_label(contents, ranking[i].condition);
        tics += fmt::format("{}{} {}", i == 0 ? "" : ", ",
                            gnuplot_string(heads == MatrixHeads::Names
                                               ? label
                                               : fmt::format("{}  {}", i + 1, label)),
                            i + 1);
    }
    return fmt::format("set ytics ({})\n", tics);
}

double name_margin(const ReportContents& contents, int width) {
    std::size_t longest = 0;
    for (const auto& place : contents.findings.ranking)
        longest = std::max(longest, characters(condition_label(contents, place.condition)));
    return margin_of(longest, width);
}

int matrix_width(const ReportContents& contents) {
    return 400 + 90 * static_cast<int>(contents.findings.ranking.size());
}

std::string bar_text(const analysis::RankedCondition& bar) {
    std::string text = decimal(bar.mean_votes, 2);
    if (!std::isnan(bar.lower))
        text += fmt::format("  [{}, {}]", decimal(bar.lower, 2), decimal(bar.upper, 2));
    return bar.letters.empty() ? text : text + "  " + bar.letters;
}

double greatest_score(const ReportContents& contents) {
    return static_cast<double>(contents.findings.design.conditions.size()) - 1;
}

std::string bars_in_words(const ReportContents& contents) {
    std::string text;
    for (const auto& bar : contents.findings.ranking)
        text += fmt::format("{}{} {}", text.empty() ? "" : "; ",
                            condition_label(contents, bar.condition), bar_text(bar));
    return text;
}

std::string matrix_in_words(const ReportContents& contents) {
    std::string text;
    const auto& ranking = contents.findings.ranking;
    const auto& matrix = pooled_matrix(contents.findings);
    for (std::size_t i = 0; i < ranking.size(); ++i)
        for (std::size_t j = i + 1; j < ranking.size(); ++j) {
            const auto a = ranking[i].condition;
            const auto b = ranking[j].condition;
            text += fmt::format("{}{} over {}: {} of {}", text.empty() ? "" : "; ",
                                condition_label(contents, a), condition_label(contents, b),
                                votes(votes_over(matrix, a, b)), matrix.comparisons(a, b));
        }
    return text;
}

} // namespace

std::string interval_name(const ReportContents& contents) {
    const auto& findings = contents.findings;
    const bool any = std::ranges::any_of(findings.ranking,
                                         [](const auto& bar) { return !std::isnan(bar.lower); });
    if (!any)
        return "";
    return fmt::format("{} t intervals over {} observers", percent(1 - findings.options.level),
                       findings.design.observers.size() -
                           findings.design.incomplete_observers.size());
}

std::string mean_votes_script(const ReportContents& contents, FigureForm form) {
    const auto& ranking = contents.findings.ranking;
    const std::string intervals = interval_name(contents);
    const std::string title = "Mean votes per round" + (intervals.empty() ? "" : ", " + intervals);
    const double greatest = greatest_score(contents);
    std::string script = terminal(form, bar_width, 110 + 44 * static_cast<int>(ranking.size()));
    script += fmt::format("set title {}\n", gnuplot_string(marked_if_simulated(contents, title)));
    script += fmt::format("set xlabel 'votes per round (0 to {}); the dashed line is chance'\n",
                          greatest);
    script += fmt::format("set xrange [0:{}]\nset yrange [{}.5:0.5]\n", greatest, ranking.size());
    script += name_tics(contents, MatrixHeads::Names);
    script += fmt::format("set lmargin at screen {:.3f}\nset rmargin at screen 0.745\n",
                          name_margin(contents, bar_width));
    script += "set border 3\nset xtics out\nset ytics scale 0\nset style fill solid 1.0 noborder\n"
              "set grid xtics lc rgb '#e3e6e8' lt 1 lw 0.5 back\n";
    script += fmt::format("set arrow from {0},graph 0 to {0},graph 1 nohead lc rgb '#6b7178' dt 2 "
                          "front\n",
                          greatest / 2);
    std::string data = "$bars << END\n";
    for (std::size_t i = 0; i < ranking.size(); ++i) {
        const auto& bar = ranking[i];
        data += fmt::format("{} {} {} {}\n", i + 1, number_or_nan(bar.mean_votes),
                            number_or_nan(bar.lower), number_or_nan(bar.upper));
        script += fmt::format("set label {} at graph 1.02, first {} textcolor rgb '{}'\n",
                              gnuplot_string(bar_text(bar)), i + 1, ink);
    }
    return script + data + "END\n" +
           fmt::format("plot $bars using ($2/2):1:(0):2:($1-0.31):($1+0.31) with boxxyerror lc rgb "
                       "'{}', $bars using 2:1:3:4 with xerrorbars pt 0 lw 1.6 lc rgb '{}'\n",
                       bar_blue, ink);
}

std::string vote_matrix_script(const ReportContents& contents, FigureForm form) {
    const auto& ranking = contents.findings.ranking;
    const auto& matrix = pooled_matrix(contents.findings);
    const auto count = static_cast<int>(ranking.size());
    std::string script = terminal(form, matrix_width(contents), 150 + 62 * count);
    script += fmt::format("set title {}\n", gnuplot_string(marked_if_simulated(
                                                contents, "Votes for the row over the column")));
    script += fmt::format("set palette defined (0 '{}', 0.5 '{}', 1 '{}')\nset cbrange [0:1]\n",
                          share_colour(0), share_colour(0.5), share_colour(1));
    script += fmt::format("set cblabel 'share of the row' textcolor rgb '{}'\n", ink);
    script += fmt::format("set xrange [0.5:{0}.5]\nset yrange [{0}.5:0.5]\n", count);
    script += name_tics(contents, MatrixHeads::Places);
    script += "set border 0\nset tics scale 0\nset xtics 1,1 offset 0,0.3\n";
    script += fmt::format("set lmargin at screen {:.3f}\nset rmargin at screen 0.86\n",
                          name_margin(contents, matrix_width(contents)));
    std::string data = "$cells << END\n";
    for (int row = 0; row < count; ++row)
        for (int column = 0; column < count; ++column) {
            if (row == column)
                continue;
            const auto a = ranking[static_cast<std::size_t>(row)].condition;
            const auto b = ranking[static_cast<std::size_t>(column)].condition;
            data += fmt::format("{} {} {}\n", column + 1, row + 1,
                                number_or_nan(share_over(matrix, a, b)));
            script += fmt::format("set label {} at {},{} center front textcolor rgb '{}'\n",
                                  gnuplot_string(votes(votes_over(matrix, a, b))), column + 1,
                                  row + 1, ink);
        }
    return script + data + "END\n" +
           "plot $cells using 1:2:($1-0.48):($1+0.48):($2-0.48):($2+0.48):3 with boxxyerror fs "
           "solid 1.0 noborder lc palette\n";
}

tl::expected<std::vector<Figure>, std::string> draw_figures(const ReportContents& contents) {
    const std::string intervals = interval_name(contents);
    std::vector<Figure> figures{
        {"mean-votes",
         "Mean votes per round, best first" +
             (intervals.empty() ? std::string(".")
                                : "; whiskers are " + intervals + ", each condition by itself.") +
             letters_in_words(contents),
         bars_in_words(contents), "", ""},
        {"vote-matrix",
         "Votes for the row over the column; blue: the row was chosen more often than not.",
         matrix_in_words(contents), "", ""}};
    using Script = std::string (*)(const ReportContents&, FigureForm);
    std::vector<Script> scripts{mean_votes_script, vote_matrix_script};
    if (has_scale(contents)) {
        scripts.push_back(scale_script);
        figures.push_back({"scale", scale_caption(contents), scale_in_words(contents), "", ""});
    }
    if (!contents.findings.residuals.residual.empty()) {
        scripts.push_back(residuals_script);
        figures.push_back({"residuals", residuals_caption(), residuals_in_words(contents), "", ""});
    }
    for (std::size_t i = 0; i < figures.size(); ++i)
        for (const auto form : {FigureForm::Svg, FigureForm::Pdf}) {
            auto drawn = run_gnuplot(scripts[i](contents, form));
            if (!drawn)
                return tl::unexpected(drawn.error());
            (form == FigureForm::Svg ? figures[i].svg : figures[i].pdf) = std::move(*drawn);
        }
    return figures;
}

} // namespace experiment::report
