// Figures of the scale and of what the analysis of variance leaves over.
#pragma once

#include "experiment/report/figures.h"

#include <string>

namespace experiment::report {

/// Whether the findings put the conditions on one scale.
bool has_scale(const ReportContents& contents);

/// Scores in JOD, best first, with their intervals over observers.  EXPECTS a scale.
std::string scale_script(const ReportContents& contents, FigureForm form);
std::string scale_caption(const ReportContents& contents);
std::string scale_in_words(const ReportContents& contents);

/// Residuals against normal quantiles, and against what was fitted.  EXPECTS residuals.
std::string residuals_script(const ReportContents& contents, FigureForm form);
std::string residuals_caption();
std::string residuals_in_words(const ReportContents& contents);

} // namespace experiment::report
