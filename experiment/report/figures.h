// The figures of a report, drawn by gnuplot: each as SVG (text kept as text) and as PDF.
#pragma once

#include "experiment/report/contents.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::report {

struct Figure {
    std::string name;        ///< of its files, without extension: "mean-votes"
    std::string caption;     ///< what it shows, and what its intervals are
    std::string description; ///< for those who cannot see it: the numbers
    std::string svg, pdf;    ///< the files' bytes
};

enum class FigureForm { Svg, Pdf };

/// Bars of the mean votes per round, best first, with intervals and letters.
std::string mean_votes_script(const ReportContents& contents, FigureForm form);

/// The share of row over column, with vote counts, best first.
std::string vote_matrix_script(const ReportContents& contents, FigureForm form);

/// What the bars' intervals are: "95 % t intervals over 10 observers"; "" when there are none.
std::string interval_name(const ReportContents& contents);

/// Both figures, the scale and the residuals where there are any.  Errors: those of `run_gnuplot`.
tl::expected<std::vector<Figure>, std::string> draw_figures(const ReportContents& contents);

} // namespace experiment::report
