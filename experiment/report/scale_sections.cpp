#include "experiment/report/scale_sections.h"

#include "analysis/scaling/scales_text.h"
#include "analysis/scaling/thurstone.h"
#include "experiment/report/html.h"
#include "experiment/report/numbers.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

namespace {

using analysis::scaling::ChiSquaredTest;
using analysis::scaling::Scales;

std::string interval(double lower, double upper) {
    return std::isfinite(lower + upper) ? decimal(lower, 2) + " to " + decimal(upper, 2)
                                        : no_number;
}

std::string
bca(const std::optional<analysis::scaling::Bootstrap>& found, std::size_t condition, double unit) {
    if (!found || found->bca.empty())
        return no_number;
    const auto& [lower, upper] =
        std::pair(found->bca[condition].lower, found->bca[condition].upper);
    return interval(unit * lower, unit * upper);
}

std::string scale_table(const ReportContents& contents) {
    const auto& scales = contents.findings.scales;
    const auto t = scales.bradley_terry.conditions();
    const auto level = percent(1 - scales.options.level);
    std::string rows;
    for (const auto i : analysis::scaling::by_score(scales.bradley_terry)) {
        const double robust = scales.robust_covariance_small[i * t + i];
        const bool first = scales.odds && !scales.odds->first.empty();
        rows += html_row({escaped(condition_label(contents, i)), decimal(scales.jod.theta[i], 2),
                          bca(scales.units, i, analysis::scaling::jod_sigma),
                          interval(scales.likelihood_jod[i].lower, scales.likelihood_jod[i].upper),
                          decimal(scales.bradley_terry.theta[i], 3),
                          decimal(standard_error(scales.bradley_terry, i), 3),
                          decimal(std::sqrt(robust), 3), bca(scales.odds, i, 1),
                          first ? percent(scales.odds->first[i]) : no_number});
    }
    return html_table(
        "numbers",
        html_head({"Condition", "JOD", level + " over observers", level + " likelihood", "Log-odds",
                   "SE, votes", "SE, observers", level + " over observers", "First"}),
        rows);
}

std::string test_row(const std::string& what, const ChiSquaredTest& test) {
    return html_row({escaped(what), significant(test.chi_squared, 4), degrees(test.df),
                     p_value(test.p.p, test.p.log10_p)});
}

std::string tests_table(const ReportContents& contents) {
    const auto& scales = contents.findings.scales;
    std::string rows = test_row("all conditions alike", scales.equality);
    rows += test_row("votes do not fit one scale (G\u00b2)", scales.fit.g2);
    for (const auto& part : scales.parts)
        rows += test_row(part.factor.empty() ? "scales differ between whole scenes"
                                             : "scales differ by " + part.factor,
                         part.heterogeneity);
    rows += test_row("the left side is chosen for itself", scales.side.test);
    return html_table("numbers", html_head({"Test", "\u03c7\u00b2", "df", "p"}), rows);
}

std::string check_row(const std::string& what, const analysis::anova::FTest& test) {
    return html_row({escaped(what), significant(test.f, 4), degrees(test.df1), degrees(test.df2),
                     p_value(test.p, test.log10_p)});
}

std::string checks_table(const analysis::OneWayFindings& found) {
    std::string rows = check_row("equal variances (Levene)", found.levene);
    rows += check_row("equal variances (Brown and Forsythe)", found.brown_forsythe);
    rows += check_row("equal means without equal variances (Welch)", found.welch);
    return html_table("numbers", html_head({"Check", "F", "df", "df", "p"}), rows);
}

std::string observers_table(const analysis::Findings& findings) {
    std::string rows;
    for (std::size_t o = 0; o < findings.screening.size(); ++o) {
        const auto& observer = findings.screening[o];
        const auto& within = findings.consistency.repeatability.within;
        rows += html_row(
            {escaped(observer.observer), fmt::format("{} in {}", observer.triads, observer.rounds),
             p_value(observer.triads_p),
             o < within.size() && !std::isnan(within[o].mean) ? percent(within[o].mean) : no_number,
             decimal(observer.pearson, 2), decimal(observer.left_out_z, 1),
             decimal(observer.largest_shift, 2),
             observer.answers > 0 ? percent(static_cast<double>(observer.left) /
                                            static_cast<double>(observer.answers))
                                  : no_number,
             observer.timed > 0 ? decimal(observer.median_ms / 1000, 1) : no_number,
             escaped(fmt::format("{}", fmt::join(observer.flags, "; ")))});
    }
    return html_table(
        "numbers",
        html_head({"Observer", "Circular triads", "p by guessing", "Same again", "r with others",
                   "z", "Shift, JOD", "Left", "Median s", "Worth a look"}),
        rows);
}

void add_figure(Body& body, const std::vector<Figure>& figures, const std::string& name) {
    const auto found = std::ranges::find(figures, name, &Figure::name);
    if (found != figures.end())
        body.figure(*found);
}

} // namespace

void add_scales(Body& body, const ReportContents& contents, const std::vector<Figure>& figures) {
    const auto& scales = contents.findings.scales;
    if (scales.bradley_terry.theta.empty())
        return;
    body.heading("How far apart they are");
    body.notes("scales");
    if (scales.bradley_terry.estimate == analysis::scaling::Estimate::None)
        return;
    add_figure(body, figures, "scale");
    body.table("Scales, centred, best first. JOD: just-objectionable differences, 1 JOD is chosen "
               "75 % of the time. Intervals over observers are bootstrap intervals (BCa); those of "
               "the likelihood, and the SE of votes, take every vote for independent. First: share "
               "of replicates in which the condition leads.",
               scale_table(contents));
    body.table("What the votes say about the scale: likelihood-ratio tests, conditional on these "
               "observers.",
               tests_table(contents));
}

void add_observers(Body& body, const ReportContents& contents, const std::vector<Figure>& figures) {
    const auto& findings = contents.findings;
    if (findings.screening.empty())
        return;
    body.heading("How consistent the answers are");
    if (findings.one_way_observers)
        body.table("What the analysis of variance assumes, checked on observers' mean votes.",
                   checks_table(*findings.one_way_observers));
    add_figure(body, figures, "residuals");
    body.table(
        "Observers. Circular triads: answers within a round that contradict each other, and "
        "the chance of so few by guessing. Same again: share of questions answered alike in "
        "another session. r: correlation of votes with the mean of the others. z: how likely "
        "the votes are under the scale of the others. Shift: largest change of a score when "
        "the observer is left out.",
        observers_table(findings));
    body.notes("screening");
}

} // namespace experiment::report
