// Dear ImGui, set up for the viewer: fonts, calm colours, and drawing.
#pragma once

#include <tl/expected.hpp>

#include <memory>
#include <string>

namespace experiment::viewer {

/// One at a time; needs the OpenGL context that was current when it was made.
class Gui {
  public:
    /// Errors: the font is not installed.
    static tl::expected<std::unique_ptr<Gui>, std::string> create();

    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

  private:
    Gui();
};

/// Ends the frame of controls and draws it into the bound frame buffer.
void draw_controls();

} // namespace experiment::viewer
