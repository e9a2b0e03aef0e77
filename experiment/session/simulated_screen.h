// Somebody simulated in front of a screen: no waiting, virtual time.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/observers.h"
#include "experiment/session/screen.h"

namespace experiment::session {

/// Turns pages after fifteen seconds, presses the experimenter's key, and answers pairs in the way
/// the study asks, moving `clock` along.  With a window, everything is also shown there, as fast as
/// it can be.
class SimulatedScreen final : public Screen {
  public:
    SimulatedScreen(SimulatedObserver observer,
                    std::string study,
                    protocols::ObserverId name,
                    int session,
                    VirtualClock& clock,
                    protocols::Response response = {},
                    Screen* window = nullptr)
        : observer_(std::move(observer)), study_(std::move(study)), name_(std::move(name)),
          session_(session), clock_(clock), response_(response), window_(window) {}

    DisplayFacts facts() const override;
    void prepare(const PairView& pair) override;
    Expected<Input> show(const View& view) override;
    std::optional<Input> wait(std::optional<Monotonic> until) override;

  private:
    struct Intention {
        Monotonic at{};
        Key key{};
    };

    Intention intention(const PairView& pair) const;

    SimulatedObserver observer_;
    std::string study_;
    protocols::ObserverId name_;
    int session_;
    VirtualClock& clock_;
    protocols::Response response_;
    Screen* window_;
    View view_ = GreyView{};
    std::optional<PairView> pair_;       ///< looked at last
    std::optional<Intention> intention_; ///< what will be pressed next, if nothing comes between
};

} // namespace experiment::session
