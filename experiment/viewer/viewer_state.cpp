// One function for each kind of input.
#include "experiment/viewer/viewer_state.h"

#include "experiment/viewer/dial_steps.h"
#include "experiment/viewer/viewpoint.h"
#include "renderer/methods/catalogue.h"

#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace experiment::viewer {

namespace methods = renderer::methods;

namespace {

std::size_t next_of(std::size_t now, int by, std::size_t count) {
    const auto n = static_cast<std::ptrdiff_t>(count);
    return static_cast<std::size_t>(((static_cast<std::ptrdiff_t>(now) + by) % n + n) % n);
}

const methods::Description& method_of(const Side& side) {
    return *methods::find_method(side.method);
}

/// The dials a key may turn: none where the method has none.
std::size_t dial_count(const Side& side) {
    return method_of(side).dials.size();
}

class Reducer {
  public:
    Reducer(ViewerState& state, const Exhibit& exhibit) : state_(state), exhibit_(exhibit) {}

    void operator()(const WalkEye& walk) {
        const double elevation = exhibit_.pieces[state_.scene].scene.elevation_degrees;
        auto& orbit = state_.orbit;
        orbit.right_degrees = std::remainder(orbit.right_degrees + walk.right_degrees, 360.0);
        orbit.up_degrees =
            std::clamp(elevation + orbit.up_degrees + walk.up_degrees, -90.0, 90.0) - elevation;
    }

    // Right and up as the eye sees them now.
    void operator()(const TurnLight& turn) {
        const auto axes = world_from_view(exhibit_.pieces[state_.scene].scene, state_.orbit);
        const auto right = glm::angleAxis(glm::radians(turn.right_degrees), axes[1]);
        const auto up = glm::angleAxis(glm::radians(-turn.up_degrees), axes[0]);
        state_.light_turn = glm::normalize(right * up * state_.light_turn);
    }

    void operator()(const Zoom& zoom) {
        state_.orbit.zoom = std::clamp(state_.orbit.zoom * zoom.factor, least_zoom, most_zoom);
    }

    void operator()(const Choose& wanted) {
        if (wanted.choice >= exhibit_.choices.size()) {
            state_.refusal = fmt::format("there is no method {}, only 1 to {}", wanted.choice + 1,
                                         exhibit_.choices.size());
            return;
        }
        const auto& choice = exhibit_.choices[wanted.choice];
        active() = {choice.method, choice.dials};
        state_.dial = 0;
    }

    void operator()(const ChooseNext& next) {
        const auto& choices = exhibit_.choices;
        const auto here = std::find_if(choices.begin(), choices.end(), [&](const Choice& choice) {
            return choice.method == active().method && choice.dials == active().dials;
        });
        const auto same_method =
            here != choices.end()
                ? here
                : std::find_if(choices.begin(), choices.end(), [&](const Choice& choice) {
                      return choice.method == active().method;
                  });
        (*this)(Choose{next_of(static_cast<std::size_t>(same_method - choices.begin()), next.by,
                               choices.size())});
    }

    void operator()(const PickDial& pick) {
        if (const auto count = dial_count(active()); count > 0)
            state_.dial = next_of(state_.dial, pick.by, count);
        else
            state_.refusal = method_of(active()).label + " has no dials";
    }

    void operator()(const TurnDial& turn) {
        const auto& dials = method_of(active()).dials;
        const auto dial =
            turn.dial.empty()
                ? dials.begin() + static_cast<std::ptrdiff_t>(std::min(state_.dial, dials.size()))
                : std::find_if(dials.begin(), dials.end(),
                               [&](const methods::Dial& one) { return one.name == turn.dial; });
        if (dial == dials.end()) {
            state_.refusal = fmt::format("{} has no dial{}{}", method_of(active()).label,
                                         turn.dial.empty() ? "s" : " ", turn.dial);
            return;
        }
        state_.dial = static_cast<std::size_t>(dial - dials.begin());
        const auto& now = active().dials.at(dial->name);
        (*this)(SetDial{state_.active, dial->name, stepped(*dial, now, turn.by)});
    }

    void operator()(const SetDial& set) {
        auto& side = state_.sides[set.side];
        auto dials = side.dials;
        dials.insert_or_assign(set.dial, set.value);
        const auto complete = methods::complete_for(side.method, dials);
        if (complete)
            side.dials = *complete;
        else
            state_.refusal = fmt::format("{}: '{}' {}", method_of(side).label,
                                         complete.error().dial, complete.error().what);
    }

    void operator()(const MoveSplit& move) {
        state_.split_at = std::clamp(state_.split_at + move.by, 0.0, 1.0);
    }

    void operator()(const NextVariant& next) {
        state_.variant = next_of(state_.variant, next.by, exhibit_.variants.size());
        state_.light_turn = {1, 0, 0, 0};
    }

    void operator()(const NextScene& next) {
        state_.scene = next_of(state_.scene, next.by, exhibit_.pieces.size());
        go_home();
    }

    void operator()(const LookAt& at) {
        state_.look = state_.look == at.look ? Look::Light : at.look;
    }

    void operator()(const Activate& activate) { turn_to(activate.side); }

    void operator()(const Command& command) {
        switch (command) {
        case Command::OtherSide:
            return turn_to(1 - state_.active);
        case Command::Split:
            state_.split = !state_.split;
            return;
        case Command::Home:
            return go_home();
        case Command::Help:
            state_.help = !state_.help;
            return;
        case Command::Panel:
            state_.panel = !state_.panel;
            return;
        case Command::TakePicture:
            ++state_.pictures;
            return;
        case Command::Quit:
            state_.done = true;
            return;
        }
    }

  private:
    Side& active() { return state_.sides[state_.active]; }

    void turn_to(std::size_t side) {
        state_.active = side;
        state_.dial = 0;
    }

    void go_home() {
        state_.orbit = {};
        state_.light_turn = {1, 0, 0, 0};
    }

    ViewerState& state_;
    const Exhibit& exhibit_;
};

} // namespace

ViewerState initial_state(const Exhibit& exhibit) {
    ViewerState state;
    for (std::size_t i = 0; i < state.sides.size(); ++i) {
        const auto& choice = exhibit.choices[std::min(i, exhibit.choices.size() - 1)];
        state.sides[i] = {choice.method, choice.dials};
    }
    return state;
}

ViewerState reduce(ViewerState state, const Input& input, const Exhibit& exhibit) {
    state.refusal.clear();
    std::visit(Reducer(state, exhibit), input);
    return state;
}

bool is_seen(const ViewerState& state, std::size_t side) {
    return state.split || state.look == Look::Error || side == state.active;
}

std::string title(const Side& side, const Exhibit& exhibit) {
    for (const auto& choice : exhibit.choices)
        if (choice.method == side.method && choice.dials == side.dials)
            return choice.label;
    std::string text = method_of(side).label;
    for (const auto& dial : method_of(side).dials)
        if (const auto& value = side.dials.at(dial.name); value != dial.preset)
            text += fmt::format(", {} {}", dial.name, methods::text_of(value));
    return text;
}

} // namespace experiment::viewer
