#include "analysis/findings.h"

#include "analysis/anova/checks.h"
#include "analysis/anova/letters.h"
#include "analysis/findings_notes.h"
#include "analysis/numerics/distributions.h"
#include "analysis/score_cells.h"
#include "protocols/contract.h"

#include <algorithm>
#include <cmath>

namespace analysis {

namespace {

std::vector<std::string> letters_of(const std::vector<anova::RangePair>& pairs,
                                    const std::vector<std::size_t>& ranked) {
    return anova::compact_letters(ranked, anova::differing(pairs))
        .value_or(std::vector<std::string>{});
}

// Effects without the method cannot vary in complete rounds: the integers say so.
void name_the_ipsative(anova::WithinAnalysis& analysis) {
    const auto method = analysis.factors.size() - 1;
    for (auto& effect : analysis.effects)
        if (effect.factors.back() != method && effect.effect.ss == 0 && effect.error.ss == 0) {
            effect.test.outcome = anova::Outcome::Ipsative;
            effect.test.reason = "not estimable: scores are ipsative";
            effect.sphericity = {};
            effect.sphericity.reason = effect.test.reason;
        }
}

anova::EtaInterval eta_interval(const anova::FTest& test, double level) {
    return anova::eta_squared_interval(test.f, test.df1, test.df2, 1 - level);
}

std::string within_name(const std::vector<anova::Factor>& factors) {
    if (factors.size() == 1)
        return "rm_method";
    std::string name = "rm";
    for (std::size_t f = 0; f + 1 < factors.size(); ++f)
        name += "_" + factors[f].name;
    return factors.size() == 2 ? "rm_method_" + factors[0].name : name + "_method";
}

void add_within(Findings& findings, const ScoreCells& cells) {
    NamedWithin named{within_name(cells.factors),
                      anova::within_observers_of_counts(cells.observers.size(), cells.factors,
                                                        cells.half_votes, cells.divisor)};
    name_the_ipsative(named.analysis);
    for (auto& effect : named.analysis.effects)
        effect.eta_interval = eta_interval(effect.test, findings.options.level);
    findings.within.push_back(std::move(named));
}

std::vector<std::vector<std::int64_t>> by_condition(const ScoreCells& cells) {
    const auto t = cells.factors.back().levels;
    std::vector<std::vector<std::int64_t>> groups(t);
    for (std::size_t i = 0; i < cells.half_votes.size(); ++i)
        groups[i % t].push_back(cells.half_votes[i]);
    return groups;
}

OneWayFindings one_way_findings(const ScoreCells& cells,
                                const std::string& unit,
                                const std::vector<std::size_t>& ranked,
                                double level) {
    OneWayFindings found;
    found.unit = unit;
    const auto groups = by_condition(cells);
    found.anova = anova::one_way_of_counts(groups, cells.divisor);
    found.eta_interval = eta_interval(found.anova.test, level);
    found.levene = anova::levene(groups);
    found.brown_forsythe = anova::brown_forsythe(groups);
    found.welch = anova::welch(found.anova);
    found.tukey = anova::tukey(found.anova.mean, found.anova.n, found.anova.within, level);
    found.pooled_t = anova::pooled_t(found.anova, level);
    found.games_howell = anova::games_howell(found.anova, level);
    found.letters = letters_of(found.tukey.pairs, ranked);
    return found;
}

// The method x factor table of one value per observer and cell: everything that involves the
// observer is residual.
TwoWayFixed two_way_fixed(const anova::WithinAnalysis& within) {
    TwoWayFixed table;
    table.factor = within.factors[0].name;
    table.total = within.total;
    table.residual = within.subject;
    for (const auto& effect : within.effects) {
        table.residual.ss += effect.error.ss;
        table.residual.df += effect.error.df;
    }
    const auto row = [&](std::string name, const anova::WithinEffect& effect) {
        FixedRow fixed{
            std::move(name),  effect.effect,    anova::f_test(effect.effect, table.residual),
            anova::undefined, anova::undefined, anova::undefined};
        const double ss = effect.effect.ss, df = effect.effect.df;
        const double error = table.residual.ms(), n = table.total.df + 1;
        if (table.total.ss > 0) {
            fixed.eta_squared = ss / table.total.ss;
            fixed.eta_squared_partial = ss / (ss + table.residual.ss);
            fixed.omega_squared_partial = (ss - df * error) / (ss + (n - df) * error);
        }
        table.rows.push_back(std::move(fixed));
    };
    row("method", within.effects[1]);
    row(table.factor, within.effects[0]);
    row("method_x_" + table.factor, within.effects[2]);
    return table;
}

Scope with_factors(const VoteTable& table, bool session, std::size_t factors) {
    Scope scope{true, session && table.sessions.size() > 1, {}};
    for (std::size_t f = 0; f < table.factors.size(); ++f)
        scope.factors.push_back(f < factors && table.factors[f].size() > 1);
    return scope;
}

NamedWithin
transformed(const ScoreCells& means, const std::string& name, double (*by)(double, double)) {
    const auto t = means.factors.back().levels;
    // m comparisons of each pair: every condition has m (t - 1), which is divisor (t - 1) / 2
    const double most = static_cast<double>(means.divisor) / 2 * static_cast<double>(t - 1);
    std::vector<double> values;
    for (const auto half : means.half_votes)
        values.push_back(by(static_cast<double>(half) / 2, most));
    return {name, anova::within_observers(means.observers.size(), means.factors, values)};
}

double arcsine(double votes, double most) {
    return std::asin(std::sqrt(votes / most));
}

double empirical_logit(double votes, double most) {
    return std::log((votes + 0.5) / (most - votes + 0.5));
}

// Nothing unless the options give every observer a group and there are at least two.
std::optional<anova::MixedAnalysis>
mixed_analysis(const VoteTable& table, const AnalysisOptions& options, const ScoreCells& means) {
    Dictionary names;
    std::vector<int> groups;
    for (const auto observer : means.observers) {
        const auto found = options.groups.find(table.observers.name(observer));
        if (found == options.groups.end())
            return std::nullopt;
        groups.push_back(static_cast<int>(names.code(found->second)));
    }
    if (names.size() < 2 || groups.size() <= names.size())
        return std::nullopt;
    return anova::mixed_of_counts(means.half_votes, groups, means.factors.back().levels,
                                  means.divisor);
}

void default_analysis(Findings& findings, const ScoreCells& means) {
    const double level = findings.options.level;
    const auto ranked = ranking(findings.scores);
    add_within(findings, means);
    const auto* method = findings.method_effect();
    const auto one_way = anova::one_way_of_counts(by_condition(means), means.divisor);
    findings.within_tukey = anova::tukey(one_way.mean, one_way.n, method->error, level);
    findings.within_letters = letters_of(findings.within_tukey.pairs, ranked);
    findings.paired_t =
        anova::paired_t(means.half_votes, means.factors.back().levels, means.divisor, level);
    findings.residuals =
        anova::within_residuals(means.half_votes, means.factors.back().levels, means.divisor);
    findings.one_way_observers = one_way_findings(means, "observer mean", ranked, level);
    findings.transformed = {transformed(means, "rm_method_arcsine_sqrt_share", arcsine),
                            transformed(means, "rm_method_logit_plus_half", empirical_logit)};
    findings.permutation = anova::permute_labels(means.half_votes, means.factors.back().levels,
                                                 findings.options.permutation_seed);
    findings.friedman = consistency::friedman(means.half_votes, means.factors.back().levels);
    findings.nemenyi = consistency::nemenyi(*findings.friedman, level);
}

void factorial_analyses(Findings& findings,
                        const VoteTable& table,
                        const std::vector<std::uint32_t>& observers) {
    const auto one = score_cells(table, observers, with_factors(table, false, 1));
    if (one && one->factors.size() == 2) {
        add_within(findings, *one);
        findings.two_way = two_way_fixed(findings.within.back().analysis);
    }
    const auto every =
        score_cells(table, observers, with_factors(table, true, table.factors.size()));
    if (every && every->factors.size() > 2 && every->factors.size() <= 6)
        add_within(findings, *every);
    if (const auto sittings = score_cells(table, observers, with_factors(table, true, 0));
        sittings && sittings->factors.size() == 2)
        findings.components = anova::variance_components(
            sittings->half_votes, observers.size(), sittings->factors[0].levels,
            sittings->factors[1].levels, sittings->divisor);
    const Scope rounds{true, true, std::vector<bool>(table.factors.size(), true)};
    if (const auto cells = score_cells(table, observers, rounds))
        findings.one_way_rounds =
            one_way_findings(*cells, "round", ranking(findings.scores), findings.options.level);
}

void analyses_of_variance(Findings& findings, const VoteTable& table) {
    const auto observers = complete_observers(table, findings.design);
    if (table.conditions.size() < 2)
        findings.why_no_anova = "there is only one condition";
    else if (observers.size() < 2)
        findings.why_no_anova = "fewer than two observers compared every pair equally often";
    if (!findings.why_no_anova.empty())
        return;
    const auto means = score_cells(table, observers, {});
    EXPECTS(means.has_value()); // complete observers are complete when everything else is pooled
    default_analysis(findings, *means);
    findings.mixed = mixed_analysis(table, findings.options, *means);
    factorial_analyses(findings, table, observers);
}

void rank_conditions(Findings& findings) {
    const auto n = static_cast<double>(findings.design.observers.size());
    const double t =
        n > 1 ? numerics::t_quantile_two_sided(findings.options.level, n - 1) : anova::undefined;
    for (const auto a : ranking(findings.scores)) {
        const auto& score = findings.scores[a];
        RankedCondition place;
        place.condition = a;
        place.rank = score.rank;
        place.votes = score.total_votes;
        place.mean_votes = score.mean_votes_per_round;
        place.share = score.share;
        place.lower = place.mean_votes - t * score.se_over_observers;
        place.upper = place.mean_votes + t * score.se_over_observers;
        if (!findings.within_letters.empty())
            place.letters = findings.within_letters[a];
        findings.ranking.push_back(place);
    }
}

} // namespace

const anova::WithinEffect* Findings::method_effect() const {
    return within.empty() ? nullptr : &within[0].analysis.effects.back();
}

Findings analyze(const VoteTable& table, const AnalysisOptions& options) {
    EXPECTS(table.size() > 0);
    EXPECTS(options.level > 0 && options.level < 1);
    Findings findings;
    findings.options = options;
    findings.design = design_facts(table);
    for (const auto& scope : usual_scopes(table))
        if (!(scope.session && !scope.factors.empty())) // single rounds are for the CSV
            for (auto& matrix : count_votes(table, scope))
                findings.matrices.push_back(std::move(matrix));
    findings.coverage = pair_coverage(findings.matrices[0].matrix);
    findings.scores = paper_scores(table);
    analyses_of_variance(findings, table);
    rank_conditions(findings);
    findings.consistency = consistency::summarize(table);
    findings.screening = consistency::screen_observers(table);
    findings.scales = scaling::fit_scales(
        table, {options.level, options.bootstrap_replicates, options.bootstrap_seed});
    append_notes(findings, table);
    return findings;
}

} // namespace analysis
