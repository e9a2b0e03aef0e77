// What an observer sees, drawn on the current frame buffer: grey, pages, pairs of pictures.
#pragma once

#include "experiment/session/page_drawing.h"
#include "experiment/session/pair_cache.h"
#include "experiment/session/pair_layout.h"
#include "experiment/session/views.h"
#include "renderer/gpu/pixel_canvas.h"

#include <cstdint>
#include <map>
#include <memory>
#include <optional>

namespace experiment::session {

struct DrawingStyle {
    std::uint8_t surround = 128;                                ///< code value of the grey
    std::map<protocols::SceneId, protocols::PictureSize> sizes; ///< of their pictures
    int gap = 32;                                               ///< between the pictures
    Places places{};
    std::optional<protocols::ConditionId> reference; ///< what lies in its place
    int photodiode_px = 0;                           ///< edge of its patch; 0: none
    TextStyle text{};
};

/// Whether codes come back as they were sent.
struct PixelCheck {
    bool surround_exact = false;
    bool picture_exact = false;
};

/// Needs the context that was current when it was made; one at a time.
class ViewDrawing {
  public:
    /// Errors: pictures that do not fit; no font.
    static Expected<ViewDrawing>
    create(int width, int height, DrawingStyle style, LoadPicture load);

    const renderer::gpu::PixelCanvas& canvas() const { return canvas_; }

    /// Errors: pictures that cannot be read or do not fit, text that cannot be drawn.
    Expected<void> draw(const View& view);

    /// Draws what a sitting draws, once, and looks at what came of it.
    PixelCheck check_pixels() const;

    /// The screen has another size from now on.  Where the pictures no longer fit, the next pair
    /// says so.
    void resize(int width, int height);

    /// The key that stands for the picture at a place, pixels from the upper left; none beside the
    /// pictures, and where both have one place.
    std::optional<Key> picture_at(const PairView& pair, double x, double y) const;

    PairCache& pictures() { return cache_; }

  private:
    /// By scene: where its pictures lie, or why they do not fit.
    using Layouts = std::map<protocols::SceneId, Expected<PairLayout>>;

    ViewDrawing(int width,
                int height,
                DrawingStyle style,
                std::unique_ptr<PageDrawing> pages,
                LoadPicture load);
    Layouts lay_out() const;
    bool is_exact(const PairLayout& layout) const;
    Expected<void> draw_pair(const PairView& pair);
    void draw_patch(const Patch& patch) const;
    void draw_photodiode_patch(bool lit) const;

    DrawingStyle style_;
    renderer::gpu::PixelCanvas canvas_;
    Layouts layouts_;
    std::unique_ptr<PageDrawing> pages_;
    PairCache cache_;
};

} // namespace experiment::session
