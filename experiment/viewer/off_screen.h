// The viewer without a display: for pictures taken by scripts.
#pragma once

#include "experiment/viewer/display.h"
#include "experiment/viewer/gui.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/target.h"

#include <tl/expected.hpp>

#include <memory>
#include <string>

namespace experiment::viewer {

class OffScreen : public Display {
  public:
    /// Errors: no OpenGL without a display; sizes the device cannot hold; no font.
    static tl::expected<std::unique_ptr<OffScreen>, std::string> create(int width, int height);

    int width() const override { return target_.width(); }

    int height() const override { return target_.height(); }

    std::vector<Event> events(double) override { return {}; }

    renderer::gpu::DrawingInto draw_into() override { return target_.draw_into(); }

    void begin_controls() override;

    void present() override {}

  private:
    OffScreen(renderer::gpu::Context context,
              renderer::gpu::Target target,
              std::unique_ptr<Gui> gui)
        : context_(std::move(context)), target_(std::move(target)), gui_(std::move(gui)) {}

    renderer::gpu::Context context_;
    renderer::gpu::Target target_;
    std::unique_ptr<Gui> gui_;
};

} // namespace experiment::viewer
