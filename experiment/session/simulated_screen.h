// A screen that a simulated observer sits in front of: no window, no waiting, virtual time.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/observers.h"
#include "experiment/session/screen.h"

namespace experiment::session {

/// Turns pages after fifteen seconds, presses the experimenter's key, and
/// answers pairs, moving `clock` along.
class SimulatedScreen final : public Screen {
  public:
    SimulatedScreen(SimulatedObserver observer,
                    std::string study,
                    protocols::ObserverId name,
                    int session,
                    VirtualClock& clock)
        : observer_(std::move(observer)), study_(std::move(study)), name_(std::move(name)),
          session_(session), clock_(clock) {}

    DisplayFacts facts() const override;

    void prepare(const PairView&) override {}

    Expected<Input> show(const View& view) override;
    std::optional<Input> wait(std::optional<Monotonic> until) override;

  private:
    SimulatedObserver observer_;
    std::string study_;
    protocols::ObserverId name_;
    int session_;
    VirtualClock& clock_;
    View view_ = GreyView{};
};

} // namespace experiment::session
