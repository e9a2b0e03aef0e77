// The screen that people sit in front of: a GLFW window.  GLFW ends here.
#pragma once

#include "experiment/session/clock.h"
#include "experiment/session/pages.h"
#include "experiment/session/pair_cache.h"
#include "experiment/session/screen.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace experiment::session {

struct WindowSize {
    int width = 0;
    int height = 0;
};

struct WindowOptions {
    std::optional<WindowSize> size; ///< of a window; without it, the whole monitor
    int monitor = 1;                ///< 1 is the primary one
    std::uint8_t surround = 128;    ///< code value of the grey
    std::map<protocols::SceneId, protocols::PictureSize> sizes{}; ///< of their pictures
    int gap = 32;                                                 ///< between the pictures
    protocols::Presentation presentation{};
    std::optional<protocols::ConditionId> reference{};
    protocols::KeyMap keys = protocols::standard_keys();
    protocols::Display display{};
    std::string without_display = "expected a desktop, or a virtual one such as xvfb-run brings";
    int test_swaps = 0;      ///< of the timing test at the start; 0: none
    bool setting_up = false; ///< the experimenter's pages come first
    PageStyle style{};       ///< theirs
};

/// A screen that can be photographed.
class WindowScreen : public Screen {
  public:
    /// The view, drawn once more and read back: what is on the screen.
    virtual renderer::gpu::Picture8 photograph() = 0;

    /// The times between `swaps` swaps of two greys, one after the other.
    virtual std::vector<Monotonic> time_swaps(int swaps) = 0;

    virtual double nominal_hz() const = 0;
};

/// Opens the window, OpenGL 4.5 core, and shows grey.  A click on a picture is its key.  `clock`
/// has to outlive the screen; one screen at a time. Errors: no display (names DISPLAY, and
/// what to do without one); no such monitor; an OpenGL below 4.5; pictures that do not fit; no
/// font.
Expected<std::unique_ptr<WindowScreen>>
open_window(const WindowOptions& options, LoadPicture load, const Clock& clock);

} // namespace experiment::session
