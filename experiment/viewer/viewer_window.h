// The viewer in a window.
#pragma once

#include "experiment/viewer/display.h"

#include <tl/expected.hpp>

#include <memory>
#include <string>

namespace experiment::viewer {

/// Opens a window, OpenGL 4.5 core, that a person may resize.  Letters, digits and signs are what
/// the keyboard's layout makes of the keys.
/// Errors: no display (names DISPLAY and --screenshot); an OpenGL below 4.5; no font.
tl::expected<std::unique_ptr<Display>, std::string>
open_viewer_window(int width, int height, const std::string& title);

} // namespace experiment::viewer
