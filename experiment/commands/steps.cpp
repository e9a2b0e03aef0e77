// What a command does in a line or two stays in the command; what two commands do is here.
#include "experiment/commands/steps.h"

#include "experiment/progress.h"

namespace experiment::commands {

stimuli::RenderSummary render_stimuli(const LoadedStudy& loaded,
                                      const stimuli::RenderOptions& options,
                                      const Voice& voice) {
    const auto summary = [&] {
        ProgressBar bar("rendering", !voice.quiet);
        return value_or_stop(stimuli::render_study(
            loaded, options, [&](const std::string&, double fraction) { bar.update(fraction); }));
    }();
    for (const auto& remark : summary.remarks)
        voice.remark(remark);
    return summary;
}

} // namespace experiment::commands
