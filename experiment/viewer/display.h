// Where the viewer is seen, and what a person does there.
#pragma once

#include "renderer/gpu/target.h"

#include <string>
#include <variant>
#include <vector>

namespace experiment::viewer {

/// A key with the keys held beside it, by its name in the key table: "Shift+Left", "S", "+".
struct Stroke {
    std::string key;
};

/// The pointer went so many pixels with a button down.
struct Drag {
    double right = 0, up = 0;
    bool light = false; ///< with Shift, or the other button
};

struct Scroll {
    double notches = 0; ///< away from the person
};

struct Closed {};

using Event = std::variant<Stroke, Drag, Scroll, Closed>;

class Display {
  public:
    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    virtual ~Display() = default;

    virtual int width() const = 0; ///< pixels
    virtual int height() const = 0;

    /// What has happened since the last call; waits up to `seconds` for something to happen.
    virtual std::vector<Event> events(double seconds) = 0;

    /// What is drawn while the result lives goes to the next picture.
    virtual renderer::gpu::DrawingInto draw_into() = 0;

    /// Begins a frame of controls.
    virtual void begin_controls() = 0;

    /// Shows what was drawn.
    virtual void present() = 0;
};

} // namespace experiment::viewer
