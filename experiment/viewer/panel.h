// What stands beside and on the picture: what is shown, what it costs, what went wrong, which keys
// there are.  Drawn by Dear ImGui, within a frame of controls.
#pragma once

#include "experiment/viewer/viewer_state.h"
#include "renderer/gpu/screen_pass.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace experiment::viewer {

/// Pixels at the window's left edge that the panel takes.
inline constexpr int panel_width = 320;

/// What is known of a side that is on the screen.
struct SideFacts {
    std::optional<double> milliseconds; ///< to update and draw, median of the last second
    std::size_t bytes_per_vertex = 0;
    std::string decision; ///< what the method chose by itself
    std::string problem;  ///< why there is no picture; empty where there is one
};

/// The scale beside false colours.
struct Legend {
    double whole = 1;
    std::string unit;    ///< of its numbers
    std::string meaning; ///< a line above
    std::string reading; ///< a line below: what was measured in the picture
};

struct Facts {
    std::array<SideFacts, 2> sides;
    std::optional<double> milliseconds; ///< a whole picture, controls included
    std::size_t vertices = 0, triangles = 0;
    double diameter_mm = 0;                ///< of the model's bounding sphere in the world
    std::string renderer;                  ///< who draws
    std::optional<Legend> legend;          ///< in false colours
    std::vector<std::string> remarks;      ///< of the model and the study
    std::string notice;                    ///< what was done last
    renderer::gpu::PixelRectangle picture; ///< of the window; the panel, if any, stands left of it
    int window_height = 0;
};

/// Draws all of it; what a person did with it on the way.
std::vector<Input> draw_panel(const ViewerState& state, const Exhibit& exhibit, const Facts& facts);

/// A box in the middle of the window: what is being done, and how far it is, 0..1.
void draw_progress(const std::string& what, double fraction, double seconds_left);

} // namespace experiment::viewer
