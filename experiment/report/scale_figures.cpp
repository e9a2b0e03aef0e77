#include "experiment/report/scale_figures.h"

#include "analysis/numerics/distributions.h"
#include "analysis/scaling/scales_text.h"
#include "analysis/scaling/thurstone.h"
#include "experiment/report/figure_parts.h"
#include "experiment/report/gnuplot.h"
#include "experiment/report/numbers.h"
#include "experiment/report/simulated.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace experiment::report {

namespace {

struct ScorePoint {
    std::size_t condition = 0;
    double score = 0;
    double lower = 0, upper = 0; ///< NaN when not computed
};

// In JOD, best first; bootstrap intervals where there are observers to draw from.
std::vector<ScorePoint> score_points(const ReportContents& contents) {
    const auto& scales = contents.findings.scales;
    std::vector<ScorePoint> points;
    for (const auto i : analysis::scaling::by_score(scales.jod)) {
        ScorePoint point{i, scales.jod.theta[i], scales.likelihood_jod[i].lower,
                         scales.likelihood_jod[i].upper};
        if (scales.units && !scales.units->bca.empty()) {
            point.lower = analysis::scaling::jod_sigma * scales.units->bca[i].lower;
            point.upper = analysis::scaling::jod_sigma * scales.units->bca[i].upper;
        }
        points.push_back(point);
    }
    return points;
}

// Residuals in rising order.
std::vector<double> sorted_residuals(const ReportContents& contents) {
    auto sorted = contents.findings.residuals.residual;
    std::ranges::sort(sorted);
    return sorted;
}

double standard_deviation(const std::vector<double>& values) {
    double squares = 0;
    for (const double value : values)
        squares += value * value;
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

// The smallest 1, 2 or 5 times a power of ten that gives at most `most` tics over `length`; 1 when
// there is no length.
double tic_step(double length, int most) {
    if (!(length > 0) || !std::isfinite(length))
        return 1;
    const double least = length / most;
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= least)
            return step * power;
    return 10 * power;
}

double spread(const std::vector<double>& values) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values)
        if (!std::isnan(value)) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    return most - least;
}

} // namespace

bool has_scale(const ReportContents& contents) {
    const auto& scales = contents.findings.scales;
    return !scales.jod.theta.empty() &&
           std::ranges::all_of(scales.jod.theta, [](double theta) { return std::isfinite(theta); });
}

std::string scale_caption(const ReportContents& contents) {
    const auto& scales = contents.findings.scales;
    const auto level = percent(1 - scales.options.level);
    return "The scale in just-objectionable differences (JOD): 1 JOD is chosen 75 % of the time. "
           "Whiskers are " +
           level +
           (scales.units ? " bootstrap intervals over observers (BCa)."
                         : " likelihood intervals, votes taken for independent.");
}

std::string scale_in_words(const ReportContents& contents) {
    std::string text;
    for (const auto& point : score_points(contents))
        text += fmt::format("{}{} {} [{}, {}]", text.empty() ? "" : "; ",
                            condition_label(contents, point.condition), decimal(point.score, 2),
                            decimal(point.lower, 2), decimal(point.upper, 2));
    return text;
}

std::string scale_script(const ReportContents& contents, FigureForm form) {
    const auto points = score_points(contents);
    std::string script = terminal(form, bar_width, 110 + 40 * static_cast<int>(points.size()));
    script += fmt::format("set title {}\n", gnuplot_string(marked_if_simulated(
                                                contents, "Scale, with intervals over observers")));
    script += "set xlabel 'JOD, centred'\n";
    script += fmt::format("set yrange [{}.5:0.5]\n", points.size());
    std::string tics, data = "$points << END\n";
    std::size_t longest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto label = condition_label(contents, points[i].condition);
        longest = std::max(longest, characters(label));
        tics += fmt::format("{}{} {}", i == 0 ? "" : ", ", gnuplot_string(label), i + 1);
        data += fmt::format("{} {} {} {}\n", i + 1, number_or_nan(points[i].score),
                            number_or_nan(points[i].lower), number_or_nan(points[i].upper));
    }
    script += fmt::format("set ytics ({})\nset lmargin at screen {:.3f}\nset rmargin at screen "
                          "0.96\n",
                          tics, margin_of(longest, bar_width));
    script +=
        "set border 1\nset xtics out\nset ytics scale 0\nset grid xtics lc rgb '#e3e6e8' lt 1 "
        "lw 0.5 back\nset offsets graph 0.05, graph 0.05, 0, 0\n";
    return script + data + "END\n" +
           fmt::format(
               "plot $points using 2:1:3:4 with xerrorbars pt 7 ps 0.9 lw 1.6 lc rgb '{}'\n", ink);
}

std::string residuals_caption() {
    return "What the analysis within observers leaves over, one point per observer and condition. "
           "Left: against normal quantiles; on the line where residuals are normal. Right: against "
           "the fitted score; a fan would mean unequal variances.";
}

std::string residuals_in_words(const ReportContents& contents) {
    const auto sorted = sorted_residuals(contents);
    return fmt::format("{} residuals from {} to {}, standard deviation {}; Shapiro-Wilk W {}, p {}",
                       sorted.size(), decimal(sorted.front(), 2), decimal(sorted.back(), 2),
                       decimal(standard_deviation(sorted), 3),
                       decimal(contents.findings.residuals.normality.w, 3),
                       p_value(contents.findings.residuals.normality.p));
}

std::string residuals_script(const ReportContents& contents, FigureForm form) {
    const auto sorted = sorted_residuals(contents);
    const auto& residuals = contents.findings.residuals;
    std::string script = terminal(form, bar_width, 340);
    std::string quantiles = "$quantiles << END\n", fitted = "$fitted << END\n";
    const auto n = static_cast<double>(sorted.size());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        // Blom's places, as in Shapiro and Wilk's test.
        const double p = (static_cast<double>(i) + 1 - 0.375) / (n + 0.25);
        quantiles += fmt::format("{} {}\n", number_or_nan(analysis::numerics::normal_quantile(p)),
                                 number_or_nan(sorted[i]));
        fitted += fmt::format("{} {}\n", number_or_nan(residuals.fitted[i]),
                              number_or_nan(residuals.residual[i]));
    }
    script += quantiles + "END\n" + fitted + "END\n";
    script += fmt::format("set multiplot layout 1,2 title {}\n",
                          gnuplot_string(marked_if_simulated(contents, "Residuals")));
    script += "set border 3\nset grid lc rgb '#e3e6e8' lt 1 lw 0.5 back\nset ylabel 'residual'\n";
    script += fmt::format(
        "set xlabel 'normal quantile'\nset xtics 1\nplot {}*x with lines lc rgb '#6b7178' dt 2, "
        "$quantiles using 1:2 with points pt 7 ps 0.5 lc rgb '{}'\n",
        number_or_nan(standard_deviation(sorted)), ink);
    // The half page has room for about five numbers: gnuplot's own choice runs them together.
    script += fmt::format("set xlabel 'fitted votes per round'\nset xtics {}\nplot 0 with "
                          "lines lc rgb '#6b7178' dt "
                          "2, $fitted using 1:2 with points pt 7 ps 0.5 lc rgb '{}'\nunset "
                          "multiplot\n",
                          tic_step(spread(residuals.fitted), 5), ink);
    return script;
}

} // namespace experiment::report
