// What a command does in a line or two stays in the command; what two commands do is here.
#include "experiment/commands/steps.h"

#include "analysis/findings_json.h"
#include "experiment/cost/read_cost.h"
#include "experiment/progress.h"
#include "experiment/report/facts.h"
#include "experiment/report/page.h"
#include "experiment/session/clock.h"
#include "experiment/stimuli/thumbnails.h"
#include "experiment/store/screened.h"
#include "experiment/text_files.h"

namespace experiment::commands {

namespace {

std::vector<store::Sitting> all_sittings(const LoadedStudy& loaded) {
    const auto store = value_or_stop(open_whole_votes(loaded.folder));
    std::vector<store::Sitting> sittings;
    for (const auto& summary : value_or_stop(store->sittings()))
        if (auto sitting = value_or_stop(store->sitting(summary.key)))
            sittings.push_back(std::move(*sitting));
    return sittings;
}

} // namespace

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

analysis::Findings findings_of(const VoteSource& votes, analysis::AnalysisOptions options) {
    options.source = votes.name;
    options.source_digest = votes.sha256;
    options.program = PAIRLIGHT_PROGRAM_VERSION;
    return analysis::analyze(votes.table, options);
}

std::filesystem::path write_study_report(const LoadedStudy& loaded, const Voice& voice) {
    auto findings = findings_of(value_or_stop(read_votes(loaded.folder.root)));
    const auto findings_text = analysis::findings_json(findings);
    report::Records records{.study = loaded.study,
                            .study_sha256 = loaded.sha256,
                            .instructions = read_instructions(loaded).value_or(""),
                            .manifest = value_or_stop(stimuli::read_manifest(loaded.folder)),
                            .sittings = all_sittings(loaded)};
    const auto store = value_or_stop(open_whole_votes(loaded.folder));
    for (const auto& observer : value_or_stop(store->observers()))
        records.answers[observer] = value_or_stop(store->answers(observer));
    records.screened = value_or_stop(store::screened_observers(*store));
    auto contents = report::report_contents(records, std::move(findings),
                                            session::local_date(session::SystemClock().wall()));
    if (const auto file = loaded.folder.cost() / "cost.json"; std::filesystem::exists(file))
        contents.cost = value_or_stop(read_text_file(file).and_then(
            [&](const auto& text) { return cost::parse_cost(text, file.string()); }));
    ProgressBar bar("report", !voice.quiet);
    contents.thumbnails =
        value_or_stop(stimuli::thumbnails(loaded, [&](double fraction) { bar.update(fraction); }));
    // Only now that nothing of the study stands in the way is anything written.
    value_or_stop(write_text_file(loaded.folder.report() / "findings.json", findings_text));
    return value_or_stop(report::write_report(loaded.folder.report(), contents));
}

} // namespace experiment::commands
