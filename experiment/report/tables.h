// The tables of votes and tests as HTML.  Captions and sections are the page's business.
#pragma once

#include "experiment/report/contents.h"

#include <string>

namespace experiment::report {

/// Rank, votes, means, shares, intervals and letters; best first.
std::string ranking_table(const ReportContents& contents);

/// What stands above a matrix's columns: conditions' names, or their places in the rows.
enum class MatrixHeads { Names, Places };

/// Share of row over column as colour, counts as text; best first.
std::string vote_matrix_table(const ReportContents& contents,
                              const analysis::VoteMatrix& matrix,
                              MatrixHeads heads);

/// Every effect with its error, the effect x observer; what cannot be tested says why.
std::string within_table(const analysis::anova::WithinAnalysis& analysis);

std::string one_way_table(const analysis::anova::OneWay& analysis);

/// Method and a scene factor with one pooled error.
std::string two_way_table(const analysis::TwoWayFixed& analysis);

/// Tukey's simultaneous intervals, with paired t by Holm beside them; each pair with the greater
/// mean first.
std::string pair_table(const ReportContents& contents);

} // namespace experiment::report
