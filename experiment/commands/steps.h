// The steps of a study that more than one command takes.
#pragma once

#include "experiment/commands/command.h"
#include "experiment/read_study.h"
#include "experiment/stimuli/render_study.h"

namespace experiment::commands {

/// Renders with a progress bar, and remarks on what was mended on the way.  Errors: CommandError.
stimuli::RenderSummary render_stimuli(const LoadedStudy& loaded,
                                      const stimuli::RenderOptions& options,
                                      const Voice& voice);

} // namespace experiment::commands
