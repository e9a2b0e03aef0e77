// The last step from linear light to the code values of a window.
#pragma once

#include "experiment/viewer/viewer_state.h"
#include "renderer/gpu/buffer.h"
#include "renderer/gpu/screen_pass.h"
#include "renderer/gpu/target.h"
#include "renderer/units.h"

#include <tl/expected.hpp>

#include <string>

namespace experiment::viewer {

/// How two pictures are brought together.
struct Composition {
    renderer::gpu::PixelRectangle place; ///< of the window; the pictures have its size
    Look look = Look::Light;
    double right_from =
        1;             ///< where the right picture begins, of the width: 0 all right, 1 all left
    bool line = false; ///< whether it is drawn
    double whole = 1;  ///< value of the last false colour: mm, or linear light
    renderer::Millimetres reach{1}; ///< of the probe the pictures were drawn with
    int surround = 128;             ///< code value behind the body
};

/// sRGB code values, encoded once, over what is in the bound frame buffer.
class PicturePass {
  public:
    /// Errors: the driver's log.
    static tl::expected<PicturePass, std::string> create();

    void draw(const renderer::gpu::Target& left,
              const renderer::gpu::Target& right,
              const Composition& composition);

  private:
    explicit PicturePass(renderer::gpu::ScreenPass pass);

    renderer::gpu::ScreenPass pass_;
    renderer::gpu::Buffer block_;
};

} // namespace experiment::viewer
