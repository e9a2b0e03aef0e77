// The viewer as a value: what is shown and how.  Inputs make a new state of the old one; nothing
// here knows windows or the GPU.
#pragma once

#include "experiment/viewer/exhibit.h"
#include "renderer/methods/dials.h"

#include <glm/ext/quaternion_double.hpp>

#include <array>
#include <cstddef>
#include <string>
#include <variant>

namespace experiment::viewer {

/// What the picture shows.
enum class Look {
    Light,     ///< what the methods draw
    Thickness, ///< how much material the methods take the light to have come through, mm
    Error      ///< how much the two sides differ, linear light
};

/// How far the eye has walked from where the scene puts it.
struct Orbit {
    double right_degrees = 0; ///< about the vertical
    double up_degrees = 0;    ///< the scene's elevation and this stay within -90..90
    double zoom = 1;          ///< magnification of the picture, `least_zoom`..`most_zoom`
};

inline constexpr double least_zoom = 0.25, most_zoom = 32;

/// A method with all its dials.
struct Side {
    std::string method;
    renderer::methods::Dials dials;
    bool operator==(const Side&) const = default;
};

struct ViewerState {
    std::size_t scene = 0;   ///< index into the exhibit's pieces
    std::size_t variant = 0; ///< index into its variants
    Orbit orbit;
    glm::dquat light_turn{1, 0, 0, 0}; ///< of the variant's lights, world axes
    std::array<Side, 2> sides;         ///< left and right
    std::size_t active = 0;            ///< the side that keys change, and that is shown alone
    bool split = false;                ///< both sides, left and right of a line
    double split_at = 0.5;             ///< where the line is, of the picture's width
    Look look = Look::Light;
    std::size_t dial = 0; ///< the active side's dial that keys turn
    bool help = false;
    bool panel = true;
    std::string refusal; ///< why the last input changed nothing; empty when it did
    int pictures = 0;    ///< how many have been asked for
    bool done = false;
};

/// The eye walks round the model.
struct WalkEye {
    double right_degrees = 0, up_degrees = 0;
};

/// All lights turn about the scene's centre, as seen from the eye.
struct TurnLight {
    double right_degrees = 0, up_degrees = 0;
};

struct Zoom {
    double factor = 1;
};

/// The active side gets a choice of the exhibit.
struct Choose {
    std::size_t choice = 0;
};

/// The same, the next in the list or the one before.
struct ChooseNext {
    int by = 1;
};

/// The next dial of the active side is the one that keys turn.
struct PickDial {
    int by = 1;
};

/// Turns a dial of the active side by a notch; without a name, the one that is picked.
struct TurnDial {
    std::string dial;
    int by = 1;
};

struct SetDial {
    std::size_t side = 0;
    std::string dial;
    renderer::methods::DialValue value;
};

struct MoveSplit {
    double by = 0; ///< of the picture's width
};

struct NextVariant {
    int by = 1;
};

struct NextScene {
    int by = 1;
};

/// Another look, or back to light when it is there already.
struct LookAt {
    Look look = Look::Light;
};

struct Activate {
    std::size_t side = 0;
};

enum class Command { OtherSide, Split, Home, Help, Panel, TakePicture, Quit };

using Input = std::variant<WalkEye,
                           TurnLight,
                           Zoom,
                           Choose,
                           ChooseNext,
                           PickDial,
                           TurnDial,
                           SetDial,
                           MoveSplit,
                           NextVariant,
                           NextScene,
                           LookAt,
                           Activate,
                           Command>;

/// The first choice on the left, the second on the right, the left one alone on the screen.
ViewerState initial_state(const Exhibit& exhibit);

/// What becomes of the state; what cannot be is refused in words and changes nothing else.
ViewerState reduce(ViewerState state, const Input& input, const Exhibit& exhibit);

/// Whether a side is on the screen.
bool is_seen(const ViewerState& state, std::size_t side);

/// How people know a side: the label of the choice it is, else its method's label and the dials
/// that are not at their presets.
std::string title(const Side& side, const Exhibit& exhibit);

} // namespace experiment::viewer
