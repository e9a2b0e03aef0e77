// People and simulated observers go through the same `conduct`; only their screens and clocks
// differ.
#include "experiment/commands/sittings.h"

#include "experiment/commands/standing_line.h"
#include "experiment/commands/stimulus_files.h"
#include "experiment/progress.h"
#include "experiment/session/simulated_screen.h"
#include "experiment/session/sitting_lock.h"
#include "experiment/session/window.h"
#include "experiment/stimuli/freshness.h"
#include "experiment/stimuli/render_study.h"
#include "experiment/store/sqlite_store.h"
#include "experiment/vote_source.h"
#include "protocols/schedule.h"
#include "protocols/session_length.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>

namespace experiment::commands {

namespace {

using protocols::ObserverId;

// Two seconds at 60 Hz, before every sitting; `pairlight timing-check` takes more.
constexpr int swaps_before_a_sitting = 120;

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

/// BT.500: at most half an hour, unless somebody wants it otherwise.
void refuse_long_plan(const protocols::Study& study, const SeatOptions& options) {
    const auto limit = std::chrono::minutes(study.plan.longest_minutes);
    const auto length = protocols::estimated_length(study);
    if (limit.count() > 0 && length > limit && !options.allow_long)
        throw CommandError(fmt::format(
            "study \"{}\": a sitting takes about {} minutes, the study allows {}; expected fewer "
            "pairs, another longest_minutes, or --allow-long",
            study.id, std::chrono::ceil<std::chrono::minutes>(length).count(), limit.count()));
}

} // namespace

std::unique_ptr<store::VoteStore> writable_store(const LoadedStudy& loaded) {
    return value_or_stop(
        store::open_or_create_votes(loaded.folder.votes(), {loaded.study.id, loaded.sha256}));
}

std::optional<session::WindowSize> window_size(const std::string& text) {
    if (text.empty())
        return std::nullopt;
    session::WindowSize size;
    int read = 0;
    if (std::sscanf(text.c_str(), "%5dx%5d%n", &size.width, &size.height, &read) != 2 ||
        static_cast<std::size_t>(read) != text.size() || size.width < 1 || size.height < 1)
        throw CommandError(fmt::format("--window {}: expected a size such as 1280x720", text));
    return size;
}

session::WindowOptions window_options(const LoadedStudy& loaded, const SeatOptions& seat) {
    const auto& study = loaded.study;
    return {.size = seat.size,
            .monitor = seat.monitor,
            .surround = static_cast<std::uint8_t>(study.surround.code),
            .sizes = protocols::picture_sizes(study),
            .gap = study.plan.gap_px,
            .presentation = study.plan.presentation,
            .reference = study.plan.reference,
            .keys = study.keys,
            .display = study.display,
            .test_swaps = 0,
            .setting_up = seat.setting_up,
            .style = session::page_style(study)};
}

session::SittingRequest sitting_request(const LoadedStudy& loaded,
                                        const ObserverId& observer,
                                        int session,
                                        std::optional<std::string> simulation,
                                        std::optional<std::string> override_reason) {
    if (!store::is_pseudonym(observer.value))
        throw CommandError(fmt::format(
            "observer \"{}\": expected a pseudonym of 1 to 32 letters, digits, '-' and '_'",
            observer.value));
    const auto partner =
        partner_of(loaded, observer,
                   simulation ? store::ObserverKind::Simulated : store::ObserverKind::Person);
    return {.study = loaded.study,
            .study_sha256 = loaded.sha256,
            .key = {observer, session},
            .schedule =
                value_or_stop(protocols::make_schedule(loaded.study, observer, session, partner)),
            .instructions = value_or_stop(read_instructions(loaded)),
            .renderer = renderers(value_or_stop(stimuli::read_manifest(loaded.folder))),
            .simulation = std::move(simulation),
            .override_reason = std::move(override_reason)};
}

std::optional<ObserverId>
partner_of(const LoadedStudy& loaded, const ObserverId& observer, store::ObserverKind kind) {
    if (!has_votes(loaded))
        return std::nullopt;
    const auto store = value_or_stop(store::open_votes(loaded.folder.votes()));
    return value_or_stop(store->partner(observer, kind));
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
    auto request = sitting_request(loaded, observer, session, {}, options.override_reason);
    refuse_long_plan(loaded.study, options);
    value_or_stop(stimuli::check_stimuli(loaded));
    const session::SystemClock clock;
    check_against_votes(request, loaded, clock);
    const auto lock =
        value_or_stop(session::SittingLock::take(loaded.folder.root, observer.value, session));
    auto digests = value_or_stop(stimulus_digests(loaded));
    request.stimuli_sha256 = digest_of(digests);
    auto window = window_options(loaded, options);
    window.test_swaps = swaps_before_a_sitting;
    window.without_display =
        "expected a desktop, or --simulate for a simulated observer, who needs none";
    const auto screen = value_or_stop(
        session::open_window(window, load_unchanged(loaded, std::move(digests)), clock));
    StandingLine line(observer.value, voice.quiet);
    request.watch = [&](const session::Standing& standing) { line.update(standing); };
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
                                         int days_later,
                                         session::Screen* window) {
    const auto simulated =
        value_or_stop(session::parse_simulated_observer(specification, loaded.study));
    const auto request =
        sitting_request(loaded, observer, session, session::text_of(simulated), {});
    session::VirtualClock clock(std::chrono::system_clock::now() +
                                std::chrono::hours(24 * days_later));
    check_against_votes(request, loaded, clock);
    session::SimulatedScreen screen(simulated, loaded.study.id, observer, session, clock,
                                    loaded.study.plan.response, window);
    return conducted(request, loaded, screen, clock);
}

void simulate_observers(const LoadedStudy& loaded,
                        int observers,
                        const std::string& specification,
                        const Voice& voice,
                        std::optional<session::WindowSize> window) {
    const session::SystemClock clock;
    std::unique_ptr<session::WindowScreen> screen;
    if (window) {
        value_or_stop(stimuli::check_stimuli(loaded));
        auto seat = window_options(loaded, {.size = window});
        seat.without_display += ", or no --window: simulated observers need none";
        screen = value_or_stop(session::open_window(
            seat, load_unchanged(loaded, value_or_stop(stimulus_digests(loaded))), clock));
    }
    ProgressBar bar("simulating", !voice.quiet);
    for (int i = 0; i < observers; ++i) {
        const ObserverId observer{fmt::format("sim-{:02}", i + 1)};
        for (int session = 1; session <= loaded.study.plan.sessions; ++session)
            if (!is_finished(loaded, {observer, session}))
                simulate_sitting(loaded, observer, session, specification,
                                 (session - 1) * std::max(1, loaded.study.plan.days_apart),
                                 screen.get());
        bar.update(static_cast<double>(i + 1) / observers);
    }
}

} // namespace experiment::commands
