// What a sitting consists of, step by step: which comes next, and what is asked again.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/views.h"
#include "protocols/schedule.h"

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace experiment::session {

struct PageStep {
    std::string name; ///< for the record
    PageView page;
    Monotonic least{}; ///< before it can be left
};

/// Grey, for the eyes to adapt.
struct AdaptationStep {};

/// All main trials are over.
struct FinishStep {};

using Step = std::variant<PageStep, AdaptationStep, protocols::PlannedTrial, FinishStep>;

class Agenda {
  public:
    void add(Step step) { steps_.push_back(std::move(step)); }

    /// The training, to be gone through again on demand; may be empty.
    void add_training(const std::vector<protocols::PlannedTrial>& trials);

    bool has_training() const { return training_.has_value(); }

    /// Forgets every step so far.
    void clear();

    std::size_t size() const { return steps_.size(); }

    const Step& current() const { return steps_[at_]; }

    /// EXPECTS the current step to be a trial.
    const protocols::PlannedTrial& trial() const;

    bool is_last() const { return at_ + 1 == steps_.size(); }

    void next() { ++at_; }

    /// Back to the beginning of the training, if that lies behind.
    bool repeat_training();

    /// Takes the current trial out, for later: behind the next trial at least, and where it stands
    /// between other scenes if there is such a place.
    void postpone_trial();

    /// The next trial, the current one included or not.
    const protocols::PlannedTrial* upcoming(bool with_current) const;

    /// Trials from the current step on.
    struct Remaining {
        int main = 0, others = 0;
    };

    Remaining remaining() const;

  private:
    std::vector<Step> steps_;
    std::size_t at_ = 0;
    std::optional<std::size_t> training_; ///< where it begins
};

} // namespace experiment::session
