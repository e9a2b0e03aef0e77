// Pictures on a frame buffer, pixel for pixel and code value for code value.
#pragma once

#include "renderer/gpu/object.h"

#include <cstdint>
#include <vector>

namespace renderer::gpu {

/// 8-bit code values as a display is sent them: RGB, rows from the top down.
struct Picture8 {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb; ///< 3 * width * height
    bool operator==(const Picture8&) const = default;
};

/// A picture in the memory of the graphics card.
class UploadedPicture {
  public:
    /// EXPECTS as many bytes as the size says.
    explicit UploadedPicture(const Picture8& picture);

    int width() const { return width_; }

    int height() const { return height_; }

    unsigned framebuffer() const { return framebuffer_.name(); }

  private:
    int width_;
    int height_;
    Object texture_;
    Object framebuffer_;
};

/// The frame buffer that is bound for drawing, as a sheet of pixels; (0, 0) is its upper left one.
/// Nothing is scaled, blended, dithered or encoded on the way.
class PixelCanvas {
  public:
    PixelCanvas(int width, int height) : width_(width), height_(height) {}

    int width() const { return width_; }

    int height() const { return height_; }

    /// All pixels to one grey.
    void clear(std::uint8_t code) const;

    /// EXPECTS the picture to lie on the canvas.
    void draw(const UploadedPicture& picture, int left, int top) const;

    /// EXPECTS the rectangle to lie on the canvas.
    Picture8 read(int left, int top, int width, int height) const;

    /// Returns when everything that was drawn is done.
    void finish() const;

  private:
    int width_;
    int height_;
};

} // namespace renderer::gpu
