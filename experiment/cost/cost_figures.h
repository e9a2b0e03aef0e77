// Error against frame time, one figure to a scene and light.
#pragma once

#include "experiment/cost/cost_report.h"
#include "experiment/report/figures.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::cost {

/// A panel for each kind of error that is known there: settings as points, those that none beats
/// joined and numbered, the chosen one ringed.
std::string
front_script(const SceneCost& scene, std::size_t light, const Wish& wish, report::FigureForm form);

/// The numbered settings of a panel, by rising frame time.
std::vector<std::size_t> front_of(const SceneCost& scene, std::size_t light, ErrorKind kind);

/// All figures, in the order of scenes and lights.  Errors: those of `run_gnuplot`.
tl::expected<std::vector<report::Figure>, std::string> draw_cost_figures(const CostReport& report);

/// Of the figure of that scene and light, and of its files.
std::string figure_name(const SceneCost& scene, const LightCase& light);

} // namespace experiment::cost
