// Analysis of variance of any table of measurements: one-way, factorial, within observers, mixed.
#pragma once

#include "analysis/anova/comparisons.h"
#include "analysis/anova/effect_size.h"
#include "analysis/anova/marginal_means.h"
#include "analysis/anova/measurements.h"
#include "analysis/anova/model_comparison.h"
#include "analysis/anova/shapiro_wilk.h"
#include "analysis/anova/sphericity.h"

#include <optional>
#include <string>
#include <vector>

namespace analysis::anova {

struct TableOptions {
    SumsOfSquares type = SumsOfSquares::Hierarchical;
    double level = 0.05;
    std::string control; ///< the level the others are compared with (one factor); "" for none
};

struct TableTerm {
    std::string name;
    Variation effect;
    std::optional<Variation> error; ///< its own, in designs with repeated measures
    FTest test;
    double eta_squared = undefined; ///< of the total
    double eta_squared_partial = undefined;
    double eta_squared_generalized = undefined; ///< in designs with repeated measures
    double omega_squared_partial = undefined;   ///< in the others; as computed, also negative
    double epsilon_squared = undefined;         ///< one-way
    EtaInterval eta_interval;                   ///< of the partial one, at 1 - level
    Sphericity sphericity;
};

/// What the levels of a single factor have beside the table.
struct LevelComparisons {
    std::vector<std::string> levels;
    std::vector<std::int64_t> n;
    std::vector<double> mean;
    std::vector<double> sd;
    RangeTest tukey;
    std::vector<TPair> t; ///< pooled t, or paired t within observers
    std::vector<std::string> letters;
    std::optional<DunnettTest> dunnett;
    // Independent values only:
    std::vector<RangePair> games_howell;
    std::optional<FTest> welch, levene, brown_forsythe;
};

/// The same for one of several factors, over the levels of the others.
struct FactorComparisons {
    std::string factor;
    std::vector<std::string> levels;
    bool within = false; ///< varies within subjects
    MarginalMeans means; ///< `factor` there is the table's
};

struct TableAnalysis {
    MeasurementColumns columns;
    TableOptions options;
    std::string design;    ///< "one-way", "factorial", "within", "mixed"
    int unit_exponent = 0; ///< all numbers are of the response over this power of ten
    std::int64_t values = 0;
    std::int64_t subjects = 0; ///< 0 without repeated measures
    double grand_mean = undefined;
    std::vector<TableTerm> terms;
    Variation residual;
    double residual_sd = undefined;
    Variation total;
    double r_squared = undefined;
    ShapiroWilk normality;                  ///< of the residuals
    std::optional<LevelComparisons> levels; ///< of a single factor
    std::vector<FactorComparisons> factors; ///< of several
    std::vector<std::string> notes;
};

/// Factors that do not vary within any subject are between subjects.  Values of one subject in one
/// cell are averaged first; subjects with an empty cell are left out, and a note says so.
/// Errors: a sentence that names what the design lacks: fewer than two levels, type III with a cell
/// that has no values, no factor within subjects, fewer than two complete subjects, an unknown
/// control.
Expected<TableAnalysis> analyze_table(const Measurements& table, const TableOptions& options);

} // namespace analysis::anova
