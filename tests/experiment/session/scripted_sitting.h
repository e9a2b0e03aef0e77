// A sitting without a world: inputs at stated milliseconds, and a diary of what came of them.
#pragma once

#include "experiment/session/sitting.h"

#include <string>
#include <vector>

namespace tests {

/// One training trial, one warm-up, three main trials; 500 ms grey, input closed for 300 ms, one
/// second of adaptation, a break after `break_every` main trials.
experiment::session::SittingScript short_script(int break_every = 0);

/// Plays the driver's part.  Onsets come `onset_delay` ms after the grey has ended, answers settle
/// and votes are stored at once.
class ScriptedSitting {
  public:
    explicit ScriptedSitting(experiment::session::SittingScript script,
                             experiment::session::Progress progress = {},
                             long long onset_delay_ms = 10);

    void press(long long ms,
               experiment::session::Key key,
               experiment::session::Device device = experiment::session::Device::Keyboard);
    /// Two keys, the second one `later_ms` on the clock.
    void press_both(long long ms,
                    experiment::session::Key first,
                    long long later_ms,
                    experiment::session::Key second);
    void press_then_lose_focus(long long ms, experiment::session::Key key, long long later_ms);
    void change_display(long long ms, const std::string& what);
    void repeat(long long ms, experiment::session::Key key);
    void let_go(long long ms, experiment::session::Key key);
    void lose_focus(long long ms);
    void close(long long ms);
    void wait_until(long long ms);

    /// Presses through everything before the first warm-up's grey and returns when that begins.
    long long pass_to_warm_up();

    /// "250 page Welcome", "500 grey", "510 pair 3", "510 shown 3 #1 late 10 ms",
    /// "900 vote 3 left 390 ms early 0", "900 event page ...", "finish", "900 end finished"
    const std::vector<std::string>& diary() const { return diary_; }

    /// What was written since the last call.
    std::vector<std::string> news();

    const experiment::session::Sitting& sitting() const { return sitting_; }

  private:
    void feed(long long ms, decltype(experiment::session::Input::what) what);
    void come_of(long long ms, const std::vector<experiment::session::Effect>& effects);
    void settle(long long ms);
    experiment::session::Monotonic true_time(long long ms) const;
    void write(long long ms, const std::vector<experiment::session::Effect>& effects);
    void look(long long ms);

    experiment::session::Sitting sitting_;
    long long onset_delay_ms_;
    long long settling_ms_ = 0; ///< of all answers so far, not on the diary's clock
    int seen_ = 0;
    std::vector<std::string> diary_;
    std::size_t told_ = 0;
};

} // namespace tests
