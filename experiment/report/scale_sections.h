// The parts of the page about scales and about observers.
#pragma once

#include "experiment/report/body.h"

namespace experiment::report {

/// Scores in JOD and log-odds with their intervals, whether scenes share a scale, side and ties.
/// Nothing where the findings have no scales.
void add_scales(Body& body, const ReportContents& contents, const std::vector<Figure>& figures);

/// Residuals and variances, and each observer's consistency and screening.
void add_observers(Body& body, const ReportContents& contents, const std::vector<Figure>& figures);

} // namespace experiment::report
