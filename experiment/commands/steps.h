// The steps of a study that more than one command takes.
#pragma once

#include "analysis/findings.h"
#include "experiment/commands/command.h"
#include "experiment/read_study.h"
#include "experiment/stimuli/render_study.h"
#include "experiment/vote_source.h"

#include <filesystem>

namespace experiment::commands {

/// Renders with a progress bar, and remarks on what was mended on the way.  Errors: CommandError.
stimuli::RenderSummary render_stimuli(const LoadedStudy& loaded,
                                      const stimuli::RenderOptions& options,
                                      const Voice& voice);

/// What the votes mean, named with their source and this program.
analysis::Findings findings_of(const VoteSource& votes, analysis::AnalysisOptions options = {});

/// Writes report/report.html, its figures and findings.json; the page's path.  Errors:
/// CommandError.
std::filesystem::path write_study_report(const LoadedStudy& loaded, const Voice& voice);

} // namespace experiment::commands
