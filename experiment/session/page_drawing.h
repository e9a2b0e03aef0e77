// Pages of text on the current frame buffer, drawn by Dear ImGui.
#pragma once

#include "experiment/session/views.h"
#include "protocols/expected.h"

#include <memory>

namespace experiment::session {

/// Draws in DejaVu Sans, dark on whatever lies there.  Letters without ascenders are 20 pixels high
/// on a screen of 1080 lines, and in proportion on others.  One at a time; needs the context that
/// was current when it was made.
class PageDrawing {
  public:
    /// Errors: the font is not installed.
    static protocols::Expected<std::unique_ptr<PageDrawing>> create(int width, int height);

    ~PageDrawing();
    PageDrawing(const PageDrawing&) = delete;
    PageDrawing& operator=(const PageDrawing&) = delete;

    /// Errors: text that is no UTF-8, or letters the font does not have.
    protocols::Expected<void> draw(const PageView& page);

  private:
    PageDrawing(int width, int height);
    protocols::Expected<void> make_letters(const PageView& page);

    int width_;
    int height_;
};

} // namespace experiment::session
