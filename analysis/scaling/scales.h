// Every scale that a table of votes is put on, and how sure each is.
#pragma once

#include "analysis/scaling/bootstrap.h"
#include "analysis/scaling/choice_fit.h"
#include "analysis/scaling/choice_tests.h"
#include "analysis/scaling/leave_one_out.h"
#include "analysis/scaling/likelihood_interval.h"
#include "analysis/vote_table.h"

#include <optional>
#include <string>
#include <vector>

namespace analysis::scaling {

struct ScaleOptions {
    double level = 0.05; ///< of tests; intervals hold at one minus it
    int replicates = 2000;
    std::uint64_t seed = 20120924; ///< of the bootstrap
};

/// Does the side matter?  The scale with one more parameter in favour of the left.
struct SideEffect {
    ChoiceFit fit;
    ChiSquaredTest test; ///< likelihood ratio against the scale without it
};

/// A scale of its own for every level of a scene factor, or for every scene.
struct PartScales {
    std::string factor;              ///< a scene factor's name; "" for whole scenes
    std::vector<std::string> levels; ///< in natural order
    std::vector<ChoiceFit> fits;     ///< Bradley-Terry, one per level
    ChiSquaredTest heterogeneity;    ///< one scale for all against one each
};

/// Scores are indexed by condition.  A tie counts for nobody, except in Davidson's model.
struct Scales {
    ScaleOptions options;
    ChoiceFit bradley_terry; ///< log-odds; penalised when there is no finite maximum
    ChoiceFit firth;         ///< always penalised
    ChoiceFit ridge;         ///< lambda 1
    ChoiceFit thurstone;     ///< in deviations of a difference
    ChoiceFit jod;           ///< the same in JOD
    ChiSquaredTest equality;
    GoodnessOfFit fit;
    std::vector<WaldPair> wald;                  ///< votes independent
    std::vector<WaldPair> wald_robust;           ///< observers independent
    std::vector<double> robust_covariance;       ///< of log-odds, as it is
    std::vector<double> robust_covariance_small; ///< times N / (N - 1)
    std::vector<LikelihoodInterval> likelihood;  ///< of log-odds
    std::vector<LikelihoodInterval> likelihood_jod;
    SideEffect side;
    std::optional<ChoiceFit> davidson;      ///< when there are ties
    std::vector<std::int64_t> first_chosen; ///< t x t: row shown left and chosen, column right
    std::vector<std::int64_t> second_chosen;
    std::vector<PartScales> parts;      ///< by scene factor, then by scene if that is finer
    std::vector<std::string> observers; ///< in natural order
    std::vector<LeftOut> left_out;      ///< by observer; empty for fewer than two
    std::optional<Bootstrap> odds;  ///< observers drawn again, log-odds; nothing for one observer
    std::optional<Bootstrap> units; ///< the same, in deviations of a difference
};

/// EXPECTS a table with at least one vote and one condition.
Scales fit_scales(const VoteTable& table, const ScaleOptions& options = {});

/// What keeps these conditions from one finite scale, in their names; "" when nothing does.
std::string existence_in_words(const Existence& found, const std::vector<std::string>& names);

} // namespace analysis::scaling
