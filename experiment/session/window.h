// The screen that people sit in front of: a GLFW window.  GLFW ends here.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/pair_cache.h"
#include "experiment/session/screen.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace experiment::session {

struct WindowSize {
    int width = 0;
    int height = 0;
};

struct WindowOptions {
    std::optional<WindowSize> size; ///< of a window; without it, the whole monitor
    int monitor = 1;                ///< 1 is the primary one
    std::uint8_t surround = 128;    ///< code value of the grey
    int picture_width = 0;          ///< of each picture
    int picture_height = 0;
    int gap = 32; ///< between the pictures
};

/// Opens the window, OpenGL 4.5 core, and shows grey.  Keys: left and right arrow, a click on a
/// picture, Space or Enter, F9, Escape.  `clock` has to outlive the screen; one screen at a time.
/// Errors: no display (names DISPLAY and --simulate); no such monitor; an OpenGL below 4.5;
/// pictures that do not fit; no font.
Expected<std::unique_ptr<Screen>>
open_window(const WindowOptions& options, LoadPicture load, const Clock& clock);

} // namespace experiment::session
