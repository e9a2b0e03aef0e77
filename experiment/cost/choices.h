// The operating point of every scene and light, with its reasons in words.
#pragma once

#include "experiment/cost/cost_report.h"

#include <optional>
#include <string>
#include <vector>

namespace experiment::cost {

/// The setting that the wish asks for, or nothing when no error of that kind is known there.
/// `measured` is left absent.
std::optional<Choice> choose(const SceneCost& scene, std::size_t light, const Wish& wish);

/// A rung: the cheapest below an error.
struct Rung {
    double error = 0;               ///< at most
    std::optional<std::size_t> row; ///< nothing where no setting is that good
};

/// The cheapest setting below 1, 2, 5, 10, 20 and 50 %, by the same rule.
std::vector<Rung> ladder(const SceneCost& scene, std::size_t light, ErrorKind kind);

/// "3.1 %".
std::string as_percent(double share);

} // namespace experiment::cost
