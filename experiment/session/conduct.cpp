// A sitting from its first page to its last.
#include "experiment/session/conduct.h"

#include "experiment/session/pages.h"
#include "experiment/session/sitting.h"
#include "protocols/digest.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <tuple>

namespace experiment::session {

namespace {

using protocols::Phase;

constexpr std::chrono::minutes training_lasts{30};

// The wall-clock time of a moment on the monotonic clock.
std::string utc_of(Monotonic at, const Clock& clock) {
    return utc_text(clock.wall() -
                    std::chrono::duration_cast<WallTime::duration>(clock.now() - at));
}

std::string kind_of(const std::optional<std::string>& simulation) {
    return simulation ? fmt::format("simulated ({})", *simulation) : "a person's";
}

// The same questions in the same order.  Their sides are those that were drawn then: whose sides an
// observer mirrors can change when somebody leaves the panel.
bool ask_the_same(const std::vector<protocols::PlannedTrial>& one,
                  const std::vector<protocols::PlannedTrial>& other) {
    const auto question = [](const protocols::PlannedTrial& planned) {
        const auto& [scene, variant, left, right] = planned.trial;
        return std::tuple(planned.number, planned.phase, scene, variant, std::min(left, right),
                          std::max(left, right));
    };
    return std::ranges::equal(one, other, {}, question, question);
}

Expected<void> check_resumption(const SittingRequest& request, const store::Sitting& begun) {
    const auto refuse = [&](const std::string& message) {
        return tl::unexpected(fmt::format("session {} of observer {} {}", request.key.session,
                                          request.key.observer.value, message));
    };
    if (begun.finished_utc)
        return refuse(fmt::format("is finished ({}); its votes stand, expected another session "
                                  "number",
                                  *begun.finished_utc));
    if (begun.start.simulation != request.simulation)
        return refuse(fmt::format("was begun as {}, expected to go on so, not as {}",
                                  kind_of(begun.start.simulation), kind_of(request.simulation)));
    if (!ask_the_same(begun.plan, request.schedule.trials))
        return refuse(fmt::format("was begun on {} with another plan; expected the study file as "
                                  "it was then",
                                  begun.start.local_date));
    return {};
}

Expected<void> check_dates(const SittingRequest& request,
                           const std::vector<store::SittingSummary>& sittings,
                           const std::string& today) {
    const auto least = request.study.plan.days_apart;
    if (request.simulation || request.override_reason)
        return {}; // nobody's eyes get tired; or somebody decided otherwise, and it is written down
    // A sitting that lies in the future says that the clock was set back: nobody knows the day.
    for (const auto& other : sittings)
        if (other.key.observer == request.key.observer && other.key != request.key &&
            days_between(other.local_date, today) < least)
            return tl::unexpected(fmt::format(
                "session {} of observer {} would be on {}, but session {} was on {}; expected at "
                "least {} day(s) between them, or a reason to override that",
                request.key.session, request.key.observer.value, today, other.key.session,
                other.local_date, least));
    return {};
}

store::SittingStart
start_of(const SittingRequest& request, const DisplayFacts& display, WallTime now) {
    const auto& schedule = request.schedule;
    return {request.key,         request.study_sha256,   local_date(now),
            utc_text(now),       schedule.generator,     schedule.order_seed,
            schedule.sides_seed, schedule.scene_rule,    store::plan_digest(schedule.trials),
            request.renderer,    display.description,    provisional_grade(display.timing),
            request.simulation,  request.override_reason};
}

// UTC texts of one form sort by time.
std::string last_sign_of_life(const store::Sitting& begun) {
    auto last = begun.start.started_utc;
    if (!begun.events.empty())
        last = std::max(last, begun.events.back().utc);
    if (!begun.shown.empty())
        last = std::max(last, begun.shown.back().onset_utc);
    return last;
}

// The trial that a deadline's event names, at the end of its detail.
int trial_of(const store::SittingEvent& event) {
    int number = 0;
    const auto digits = event.detail.find_last_not_of("0123456789") + 1; // 0 where all are digits
    std::from_chars(event.detail.data() + digits, event.detail.data() + event.detail.size(),
                    number);
    return number;
}

Progress progress_of(const store::Sitting& begun, WallTime now) {
    Progress progress;
    for (const auto& vote : begun.votes)
        progress.voted.insert(vote.trial);
    for (const auto& shown : begun.shown)
        progress.presentations[shown.trial] =
            std::max(progress.presentations[shown.trial], shown.presentation);
    for (const auto& event : begun.events) {
        const auto number = trial_of(event);
        if (event.kind == store::missing_vote)
            progress.missing.insert(number);
        else if (event.kind == "deadline")
            progress.expired.insert(number);
    }
    // What follows the training was reached: the training was done.
    const auto was_shown = [&](const protocols::PlannedTrial& planned) {
        return planned.phase != Phase::Training && progress.presentations.contains(planned.number);
    };
    progress.training_done = std::ranges::any_of(begun.plan, was_shown) &&
                             last_sign_of_life(begun) >= utc_text(now - training_lasts);
    return progress;
}

// Carries out what a sitting wants recorded, and counts its frames.
class Recorder {
  public:
    Recorder(const store::SittingKey& key,
             store::VoteStore& store,
             const Clock& clock,
             DisplayTiming timing)
        : key_(key), store_(store), clock_(clock), timing_(timing) {}

    Expected<void> operator()(store::Shown shown) {
        shown.onset_utc = utc_of(Monotonic(shown.onset_ns), clock_);
        return store_.append_shown(key_, shown);
    }

    Expected<void> operator()(store::MainVote vote) {
        count(vote.frames);
        vote.onset_utc = utc_of(Monotonic(vote.onset_ns), clock_);
        return store_.append_vote(key_, vote);
    }

    Expected<void> operator()(const store::FramesSeen& seen) {
        count(seen.frames);
        return store_.append_frames(key_, seen);
    }

    Expected<void> operator()(store::SittingEvent event) {
        event.utc = utc_of(Monotonic(event.at_ns), clock_);
        return store_.append_event(key_, event);
    }

    Expected<void> operator()(const Finish&) {
        if (auto graded = grade(); !graded)
            return graded;
        return store_.finish_sitting(key_, utc_text(clock_.wall()));
    }

    /// Says on record how the display kept time.
    Expected<void> grade() {
        const auto text =
            fmt::format("grade={}; frames={}; late={}; refreshes_missed={}",
                        timing_grade(timing_, frames_, late_), frames_, late_, missed_);
        return store_.append_event(key_,
                                   {"timing", text, clock_.now().count(), utc_text(clock_.wall())});
    }

  private:
    void count(const std::vector<store::Frame>& frames) {
        for (const auto& frame : frames) {
            frames_ += frame.what == "stored" ? 0 : 1;
            late_ += frame.late > 0 ? 1 : 0;
            missed_ += frame.late;
        }
    }

    const store::SittingKey& key_;
    store::VoteStore& store_;
    const Clock& clock_;
    DisplayTiming timing_;
    int frames_ = 0;
    int late_ = 0;
    int missed_ = 0;
};

// Advances the sitting and records what follows from it, until nothing more does.
Expected<void>
step(Sitting& sitting, Recorder& record, const Clock& clock, std::vector<Effect> effects) {
    while (!effects.empty()) {
        bool vote_stored = false;
        for (const auto& effect : effects) {
            if (auto done = std::visit(record, effect); !done)
                return done;
            vote_stored = vote_stored || std::holds_alternative<store::MainVote>(effect);
        }
        effects =
            vote_stored ? sitting.advance({clock.now(), VoteStored{}}) : std::vector<Effect>{};
    }
    return {};
}

// Shows and waits until the sitting is over.  True: it was finished.
Expected<bool> run(Sitting& sitting,
                   Recorder& record,
                   Screen& screen,
                   const Clock& clock,
                   const std::function<void(const Standing&)>& watch) {
    const auto advance = [&](const Input& input) {
        return step(sitting, record, clock, sitting.advance(input));
    };
    auto done = step(sitting, record, clock, sitting.begin(clock.now()));
    for (int seen = 0; done;) {
        if (const auto* end = std::get_if<EndView>(&sitting.view()))
            return end->finished;
        if (sitting.view_number() != seen) {
            seen = sitting.view_number();
            const auto onset = screen.show(sitting.view());
            if (!onset)
                return tl::unexpected(onset.error());
            if (done = advance(*onset); !done)
                break;
            if (watch)
                watch(sitting.standing(clock.now()));
        }
        if (const auto pair = sitting.upcoming())
            screen.prepare(*pair);
        const auto input = screen.wait(sitting.wake_at());
        done = advance(input.value_or(Input{clock.now(), Waited{}}));
    }
    return tl::unexpected(done.error());
}

Expected<void> open_sitting(const SittingRequest& request,
                            store::VoteStore& store,
                            const Screen& screen,
                            const Clock& clock,
                            bool resumed) {
    const auto now = clock.wall();
    const auto display = screen.facts();
    const auto note = [&](std::string kind, std::string detail) {
        return store.append_event(request.key, {std::move(kind), std::move(detail),
                                                clock.now().count(), utc_text(clock.wall())});
    };
    if (resumed)
        return note("resumed", display.description);
    auto done = store.add_observer(request.key.observer, utc_text(now));
    if (done)
        done = store.take_place(request.key.observer,
                                request.simulation ? store::ObserverKind::Simulated
                                                   : store::ObserverKind::Person,
                                utc_text(now));
    if (done)
        done = store.begin_sitting(start_of(request, display, now), request.schedule.trials);
    if (done && !request.stimuli_sha256.empty())
        done = note("stimuli", "sha256=" + request.stimuli_sha256);
    if (const auto room = protocols::text_of(request.study.room); done && !room.empty())
        done = note("room", room);
    if (done)
        done = note("instructions",
                    fmt::format("language={}; sha256={}", request.study.instructions.language,
                                protocols::hexadecimal(
                                    protocols::sha256(std::string_view(request.instructions)))));
    return done;
}

Expected<void> check_registration(const SittingRequest& request, const store::VoteStore& store) {
    const auto& panel = request.study.panel;
    if (request.simulation || (panel.questions.empty() && !panel.consent))
        return {};
    const auto answers = store.answers(request.key.observer);
    if (!answers)
        return tl::unexpected(answers.error());
    const auto has = [&](const std::string& question) {
        return std::ranges::find(*answers, question, &store::Answer::question) != answers->end();
    };
    const auto refuse = [&](const std::string& what) {
        return tl::unexpected(fmt::format("observer {} {}; expected `pairlight register` first",
                                          request.key.observer.value, what));
    };
    if (panel.consent && !has("consent"))
        return refuse("has no consent on record");
    for (const auto& question : panel.questions)
        if (!has(question.id))
            return refuse(fmt::format("has no answer to '{}' on record", question.id));
    return {};
}

SittingScript script_of(const SittingRequest& request,
                        const std::optional<store::Sitting>& begun,
                        const DisplayFacts& facts) {
    const bool synced = facts.timing.verdict == SwapVerdict::Synced;
    return {split_pages(request.instructions),
            request.study.question,
            request.study.plan,
            begun ? begun->plan : request.schedule.trials,
            page_style(request.study),
            request.simulation ? std::vector<PageView>{} : facts.setting_up,
            facts.refresh,
            synced ? facts.refresh / 2 : Monotonic{}};
}

} // namespace

PageStyle page_style(const protocols::Study& study) {
    return {&words_in(study.instructions.language), study.keys, study.plan.response,
            study.plan.presentation};
}

Expected<void>
check_sitting(const SittingRequest& request, const store::VoteStore& store, const Clock& clock) {
    if (split_pages(request.instructions).empty())
        return tl::unexpected(fmt::format("{}: is empty, expected at least one page of "
                                          "instructions",
                                          request.study.instructions.file));
    if (auto registered = check_registration(request, store); !registered)
        return registered;
    const auto begun = store.sitting(request.key);
    if (!begun)
        return tl::unexpected(begun.error());
    if (*begun)
        return check_resumption(request, **begun);
    const auto sittings = store.sittings();
    if (!sittings)
        return tl::unexpected(sittings.error());
    return check_dates(request, *sittings, local_date(clock.wall()));
}

Expected<SittingOutcome> conduct(const SittingRequest& request,
                                 store::VoteStore& store,
                                 Screen& screen,
                                 const Clock& clock) {
    if (auto allowed = check_sitting(request, store, clock); !allowed)
        return tl::unexpected(allowed.error());
    const auto begun = store.sitting(request.key);
    if (!begun)
        return tl::unexpected(begun.error());
    SittingOutcome outcome;
    outcome.resumed = begun->has_value();
    if (auto opened = open_sitting(request, store, screen, clock, outcome.resumed); !opened)
        return tl::unexpected(opened.error());

    const auto facts = screen.facts();
    Sitting sitting(script_of(request, *begun, facts),
                    *begun ? progress_of(**begun, clock.wall()) : Progress{});
    Recorder record(request.key, store, clock, facts.timing);
    const auto finished = run(sitting, record, screen, clock, request.watch);
    if (!finished)
        return tl::unexpected(finished.error());
    outcome.finished = *finished;
    if (!outcome.finished)
        if (auto graded = record.grade(); !graded)
            return tl::unexpected(graded.error());
    const auto now = store.sitting(request.key);
    if (!now)
        return tl::unexpected(now.error());
    outcome.votes = static_cast<int>((*now)->votes.size());
    return outcome;
}

} // namespace experiment::session
