// Pages of text on the current frame buffer, drawn by Dear ImGui.
#pragma once

#include "experiment/session/views.h"
#include "protocols/expected.h"

#include <memory>
#include <string>

namespace experiment::session {

struct TextStyle {
    double scale = 1;           ///< of the letters
    bool high_contrast = false; ///< black on a white field
};

/// Draws in DejaVu Sans, dark on whatever lies there.  Letters without ascenders are 20 pixels high
/// on a screen of 1080 lines, and in proportion on others; smaller where a page would not fit.  One
/// at a time; needs the context that was current when it was made.
class PageDrawing {
  public:
    /// Errors: the font is not installed.
    static protocols::Expected<std::unique_ptr<PageDrawing>>
    create(int width, int height, TextStyle style = {});

    ~PageDrawing();
    PageDrawing(const PageDrawing&) = delete;
    PageDrawing& operator=(const PageDrawing&) = delete;

    /// Errors: text that is no UTF-8, or letters the font does not have.
    protocols::Expected<void> draw(const PageView& page);

    /// The screen has another size from now on.
    void resize(int width, int height);

    /// A short text such as a number, centred about `x` and below `y`, in pixels.
    protocols::Expected<void> draw_mark(const std::string& text, int x, int y);

  private:
    PageDrawing(int width, int height, TextStyle style);
    protocols::Expected<void> make_letters(const PageView& page, double scale);
    void begin_frame();
    void end_frame();

    int width_;
    int height_;
    TextStyle style_;
};

} // namespace experiment::session
