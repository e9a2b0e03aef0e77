// Frame buffers of our own: float32 colour with depth, or depth alone.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/object.h"

#include <array>
#include <vector>

namespace renderer::gpu {

/// What is drawn while this lives goes into one frame buffer; afterwards into what was bound
/// before, with the viewport it had.
class DrawingInto {
  public:
    DrawingInto(unsigned framebuffer, int width, int height);
    ~DrawingInto();
    DrawingInto(const DrawingInto&) = delete;
    DrawingInto& operator=(const DrawingInto&) = delete;

  private:
    int previous_framebuffer_ = 0;
    std::array<int, 4> previous_viewport_{};
};

/// Colour RGBA float32 and depth float32.
class Target {
  public:
    /// Errors: sizes below 1 or beyond what the device can hold.
    static Expected<Target> create(int width, int height);

    /// Colour and alpha to 0, depth to the farthest.
    void clear() const;

    DrawingInto draw_into() const { return {framebuffer_.name(), width_, height_}; }

    /// Makes its colour the texture of that unit.
    void bind_texture(unsigned unit) const;

    /// RGBA, four floats to a pixel, rows from the bottom up.
    void read(std::vector<float>& rgba) const;

    int width() const { return width_; }

    int height() const { return height_; }

  private:
    Target(int width, int height);

    int width_;
    int height_;
    Object colour_;
    Object depth_;
    Object framebuffer_;
};

/// A square of float32 depths that can be drawn into and then read in a shader.
class DepthMap {
  public:
    /// Errors: sizes below 1 or beyond what the device can hold.
    static Expected<DepthMap> create(int resolution);

    /// Every texel to 1, the farthest depth: nothing there.
    void clear() const;

    DrawingInto draw_into() const { return {framebuffer_.name(), resolution_, resolution_}; }

    /// Makes it the texture of that unit.
    void bind_texture(unsigned unit) const;

    int resolution() const { return resolution_; }

  private:
    explicit DepthMap(int resolution);

    int resolution_;
    Object depth_;
    Object framebuffer_;
};

} // namespace renderer::gpu
