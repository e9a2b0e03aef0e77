// What `pairlight cost` found, for people: a page, a part of the study's report, and plain text.
#pragma once

#include "experiment/cost/cost_report.h"
#include "experiment/report/body.h"
#include "experiment/report/figures.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace experiment::cost {

/// Per scene and light: the choice with its reasons, the cheapest setting below each error, the
/// figure; per scene: all settings.
void add_cost(report::Body& body,
              const CostReport& report,
              const std::vector<report::Figure>& figures);

/// The same choices and ladders as Markdown, with the presets of every method.
std::string cost_text(const CostReport& report);

/// Writes cost.html, cost.csv, cost.json and figures/<name>.svg and .pdf into `folder`; the path of
/// the page.  Errors: those of `draw_cost_figures` and of writing.
tl::expected<std::filesystem::path, std::string> write_cost(const std::filesystem::path& folder,
                                                            const CostReport& report);

} // namespace experiment::cost
