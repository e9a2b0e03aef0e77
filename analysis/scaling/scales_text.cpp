#include "analysis/scaling/scales_text.h"

#include "analysis/scaling/thurstone.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace analysis::scaling {

namespace {

using Names = std::vector<std::string>;

std::string value(double number, int digits = 3) {
    return std::isfinite(number) ? fmt::format("{:.{}f}", number, digits) : "n/e";
}

std::string p_of(const ChiSquaredTest& test) {
    if (std::isnan(test.p.p))
        return "n/e";
    return test.p.p < 1e-300 ? fmt::format("10^{:.1f}", test.p.log10_p)
                             : fmt::format("{:.3g}", test.p.p);
}

std::string range(double lower, double upper) {
    return std::isfinite(lower + upper) ? value(lower) + " to " + value(upper) : "n/e";
}

std::string test_line(const std::string& what, const ChiSquaredTest& test) {
    return fmt::format("{}: chi2({:g}) = {}, p = {}\n", what, test.df, value(test.chi_squared),
                       p_of(test));
}

void score_row(std::string& text, const Scales& scales, const Names& names, std::size_t i) {
    const auto t = names.size();
    const auto& units = scales.units;
    const auto& odds = scales.odds;
    text += fmt::format(
        "{:<12}  {:>7}  {:>16}  {:>9}  {:>7}  {:>7}  {:>16}  {:>7}\n", names[i],
        value(scales.jod.theta[i]),
        units && !units->bca.empty()
            ? range(jod_sigma * units->bca[i].lower, jod_sigma * units->bca[i].upper)
            : range(scales.likelihood_jod[i].lower, scales.likelihood_jod[i].upper),
        value(scales.bradley_terry.theta[i]), value(standard_error(scales.bradley_terry, i)),
        value(std::sqrt(scales.robust_covariance_small[i * t + i])),
        odds && !odds->bca.empty() ? range(odds->bca[i].lower, odds->bca[i].upper)
                                   : range(scales.likelihood[i].lower, scales.likelihood[i].upper),
        odds && !odds->first.empty() ? value(odds->first[i]) : "n/e");
}

} // namespace

std::vector<std::size_t> by_score(const ChoiceFit& fit) {
    std::vector<std::size_t> order(fit.conditions());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return fit.theta[a] > fit.theta[b]; });
    return order;
}

std::string scales_text(const Scales& scales, const Names& conditions) {
    if (scales.bradley_terry.estimate == Estimate::None)
        return "Scales: none, because " +
               existence_in_words(scales.bradley_terry.existence, conditions) + ".\n\n";
    const auto percent = fmt::format("{:g} %", 100 * (1 - scales.options.level));
    const auto interval = percent + (scales.odds ? " BCa" : " likelihood");
    std::string text =
        fmt::format("Scales, centred\n{:<12}  {:>7}  {:>16}  {:>9}  {:>7}  {:>7}  {:>16}  {:>7}\n",
                    "method", "JOD", interval, "log-odds", "SE", "robust", interval, "P(1st)");
    for (const auto i : by_score(scales.bradley_terry))
        score_row(text, scales, conditions, i);
    text += test_line("All alike (Bradley-Terry)", scales.equality);
    text += test_line("Fit of Bradley-Terry, G2", scales.fit.g2);
    for (const auto& part : scales.parts)
        text += test_line(part.factor.empty() ? "Scales differ between whole scenes"
                                              : "Scales differ between levels of " + part.factor,
                          part.heterogeneity);
    if (scales.side.fit.side)
        text += fmt::format("Left side: {} log-odds (SE {}), chi2(1) = {}, p = {}\n",
                            value(scales.side.fit.side->value),
                            value(scales.side.fit.side->standard_error),
                            value(scales.side.test.chi_squared), p_of(scales.side.test));
    else
        text += "Left side: not estimated: " + scales.side.fit.reason + "\n";
    if (scales.davidson && scales.davidson->log_nu)
        text += fmt::format("Ties (Davidson): nu = {}\n",
                            value(std::exp(scales.davidson->log_nu->value)));
    return text + "\n";
}

std::vector<std::string> scale_notes(const Scales& scales, const Names& conditions) {
    std::vector<std::string> notes;
    const auto& fit = scales.bradley_terry;
    if (const auto words = existence_in_words(fit.existence, conditions); !words.empty())
        notes.push_back(fit.estimate == Estimate::None
                            ? "There is no common scale: " + words + "."
                            : "There is no finite scale of maximum likelihood: " + words +
                                  ". Log-odds are Firth's penalised estimates, JOD those under a "
                                  "Gaussian prior of one deviation; tests that need the maximum "
                                  "are not estimable.");
    if (fit.estimate == Estimate::None)
        return notes;
    notes.push_back("JOD: Thurstone's Case V, 1 JOD is chosen 75 % of the time. Log-odds: Bradley "
                    "and Terry. SE takes every vote for independent; robust lets the votes of one "
                    "observer hang together, and is the one to use for observers in general. "
                    "Likelihood-ratio tests take votes for independent: conditional on these "
                    "observers.");
    if (scales.davidson)
        notes.push_back("Ties count for neither side in the scales; Davidson's model, which has "
                        "them as an answer of their own, is beside them in the findings.");
    if (scales.odds)
        notes.push_back(fmt::format(
            "Intervals of the scales: observers drawn again {} times with seed {}, bias-corrected "
            "and accelerated; {} replicates had no finite maximum and were penalised, {} had no "
            "common scale and were left out. With {} observers such intervals are about {:.0f} % "
            "too short.",
            scales.odds->options.replicates, scales.odds->options.seed, scales.odds->penalised,
            scales.odds->disconnected, scales.left_out.size(),
            100 * (1 - std::sqrt(1 - 1 / static_cast<double>(scales.left_out.size())))));
    return notes;
}

} // namespace analysis::scaling
