// People and simulated observers go through the same `conduct`; only their screens and clocks
// differ.
#include "experiment/commands/sittings.h"

#include "experiment/progress.h"
#include "experiment/session/simulated_screen.h"
#include "experiment/session/window.h"
#include "experiment/stimuli/display_picture.h"
#include "experiment/stimuli/freshness.h"
#include "experiment/stimuli/render_study.h"
#include "experiment/store/sqlite_store.h"
#include "experiment/vote_source.h"
#include "protocols/schedule.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace experiment::commands {

namespace {

using protocols::ObserverId;

std::unique_ptr<store::VoteStore> writable_store(const LoadedStudy& loaded) {
    return value_or_stop(
        store::open_or_create_votes(loaded.folder.votes(), {loaded.study.id, loaded.sha256}));
}

/// What drew the pictures: one line, or several where they differ.
std::string renderers(const stimuli::Manifest& manifest) {
    std::set<std::string> named;
    for (const auto& [picture, record] : manifest.pictures)
        named.insert(record.renderer);
    std::string all;
    for (const auto& name : named)
        all += (all.empty() ? "" : "; ") + name;
    return all;
}

/// An empty file is left to the store, which says what to do about it.
bool has_votes(const LoadedStudy& loaded) {
    std::error_code none;
    const auto size = std::filesystem::file_size(loaded.folder.votes(), none);
    return !none && size > 0;
}

bool is_finished(const LoadedStudy& loaded, const store::SittingKey& key) {
    if (!has_votes(loaded))
        return false;
    const auto store = value_or_stop(open_whole_votes(loaded.folder));
    const auto sitting = value_or_stop(store->sitting(key));
    return sitting && sitting->finished_utc;
}

/// Asks before anything is opened for writing, so that a refusal leaves every byte as it was.
void check_against_votes(const session::SittingRequest& request,
                         const LoadedStudy& loaded,
                         const session::Clock& clock) {
    if (!has_votes(loaded))
        return;
    const auto store = value_or_stop(open_whole_votes(loaded.folder));
    value_or_stop(session::check_sitting(request, *store, clock));
}

session::SittingOutcome conducted(const session::SittingRequest& request,
                                  const LoadedStudy& loaded,
                                  session::Screen& screen,
                                  const session::Clock& clock) {
    const auto store = writable_store(loaded);
    return value_or_stop(session::conduct(request, *store, screen, clock));
}

} // namespace

session::SittingRequest sitting_request(const LoadedStudy& loaded,
                                        const ObserverId& observer,
                                        int session,
                                        std::optional<std::string> simulation,
                                        std::optional<std::string> override_reason) {
    if (!store::is_pseudonym(observer.value))
        throw CommandError(fmt::format(
            "observer \"{}\": expected a pseudonym of 1 to 32 letters, digits, '-' and '_'",
            observer.value));
    return {.study = loaded.study,
            .study_sha256 = loaded.sha256,
            .key = {observer, session},
            .schedule = value_or_stop(protocols::make_schedule(loaded.study, observer, session)),
            .instructions = value_or_stop(read_instructions(loaded)),
            .renderer = renderers(value_or_stop(stimuli::read_manifest(loaded.folder))),
            .simulation = std::move(simulation),
            .override_reason = std::move(override_reason)};
}

int next_session(const LoadedStudy& loaded, const ObserverId& observer) {
    for (int session = 1; session <= loaded.study.plan.sessions; ++session)
        if (!is_finished(loaded, {observer, session}))
            return session;
    throw CommandError(
        fmt::format("{}: observer {} has finished all {} sittings; nothing was changed",
                    loaded.folder.votes().string(), observer.value, loaded.study.plan.sessions));
}

session::SittingOutcome sit(const LoadedStudy& loaded,
                            const ObserverId& observer,
                            int session,
                            const SeatOptions& options,
                            const Voice& voice) {
    const auto request = sitting_request(loaded, observer, session, {}, options.override_reason);
    value_or_stop(stimuli::check_stimuli(loaded));
    const session::SystemClock clock;
    check_against_votes(request, loaded, clock);
    const auto screen = value_or_stop(session::open_window(
        {.size = options.size,
         .monitor = options.monitor,
         .surround = static_cast<std::uint8_t>(loaded.study.surround.code),
         .picture_width = loaded.study.width,
         .picture_height = loaded.study.height,
         .gap = loaded.study.plan.gap_px},
        [&](const protocols::Picture& picture) {
            return stimuli::picture_for_display(loaded, picture);
        },
        clock));
    const auto outcome = conducted(request, loaded, *screen, clock);
    voice.remark(fmt::format("{}: {} votes; {}", observer.value, outcome.votes,
                             outcome.finished ? "the sitting is finished"
                                              : "stopped; run it again to go on"));
    return outcome;
}

session::SittingOutcome simulate_sitting(const LoadedStudy& loaded,
                                         const ObserverId& observer,
                                         int session,
                                         const std::string& specification,
                                         int days_later) {
    const auto simulated =
        value_or_stop(session::parse_simulated_observer(specification, loaded.study));
    const auto request =
        sitting_request(loaded, observer, session, session::text_of(simulated), {});
    session::VirtualClock clock(std::chrono::system_clock::now() +
                                std::chrono::hours(24 * days_later));
    check_against_votes(request, loaded, clock);
    session::SimulatedScreen screen(simulated, loaded.study.id, observer, session, clock);
    return conducted(request, loaded, screen, clock);
}

void simulate_observers(const LoadedStudy& loaded,
                        int observers,
                        const std::string& specification,
                        const Voice& voice) {
    ProgressBar bar("simulating", !voice.quiet);
    for (int i = 0; i < observers; ++i) {
        const ObserverId observer{fmt::format("sim-{:02}", i + 1)};
        for (int session = 1; session <= loaded.study.plan.sessions; ++session)
            if (!is_finished(loaded, {observer, session}))
                simulate_sitting(loaded, observer, session, specification,
                                 (session - 1) * std::max(1, loaded.study.plan.days_apart));
        bar.update(static_cast<double>(i + 1) / observers);
    }
}

} // namespace experiment::commands
