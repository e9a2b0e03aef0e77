// The report as one HTML page that needs nothing else: no network, no script.
#pragma once

#include "experiment/report/contents.h"
#include "experiment/report/figures.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace experiment::report {

/// The page.  Figures are carried inside, by their SVG.
std::string report_page(const ReportContents& contents, const std::vector<Figure>& figures);

/// Draws the figures and writes report.html and figures/<name>.svg and .pdf into `folder`.
/// The path of the page.  Errors: those of `draw_figures` and of writing.
tl::expected<std::filesystem::path, std::string> write_report(const std::filesystem::path& folder,
                                                              const ReportContents& contents);

} // namespace experiment::report
