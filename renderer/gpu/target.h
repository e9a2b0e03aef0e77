// Frame buffers of our own: float32 colour with depth, and stacks of maps.
#pragma once

#include "renderer/expected.h"
#include "renderer/gpu/object.h"

#include <array>
#include <cstddef>
#include <vector>

namespace renderer::gpu {

/// The rectangle of the bound frame buffer that is drawn into, in pixels from its lower left.
struct Viewport {
    int left = 0;
    int bottom = 0;
    int width = 0;
    int height = 0;
};

Viewport bound_viewport();

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

/// What is drawn while this lives goes into a part of the bound frame buffer.
class DrawingWithin {
  public:
    explicit DrawingWithin(const Viewport& part);
    ~DrawingWithin();
    DrawingWithin(const DrawingWithin&) = delete;
    DrawingWithin& operator=(const DrawingWithin&) = delete;

  private:
    Viewport previous_;
};

/// Colour RGBA float32 and depth float32.
class Target {
  public:
    /// Errors: sizes below 1 or beyond what the device can hold.
    static Expected<Target> create(int width, int height);

    /// Colour and alpha to 0, depth to the farthest.
    void clear() const;

    DrawingInto draw_into() const { return {framebuffer_.name(), width_, height_}; }

    /// Makes its colours the texture (a sampler2D) of that unit.
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

/// A stack of square float32 pictures of one number a texel, drawn one layer after the other and
/// then read together in a shader.  0 is nothing: what a layer holds before it is drawn.
class LayeredMap {
  public:
    /// How a shader reads between texels.
    enum class Reading { Nearest, Linear };

    /// Errors: sizes below 1 or beyond what the device can hold.
    static Expected<LayeredMap> create(int resolution, int layers, Reading reading);

    /// Empties a layer and makes it what is drawn into, nearest wins.  The shader that draws may
    /// read the other layers of the same map.
    DrawingInto draw_into(int layer) const;

    /// Makes it the texture (a sampler2DArray) of that unit.
    void bind_texture(unsigned unit) const;

    /// One float to a texel, rows from the bottom up, layer after layer.
    std::vector<float> read() const;

    int resolution() const { return resolution_; }

    int layers() const { return layers_; }

    std::size_t bytes() const; ///< of the layers, without the depths that drawing needs

  private:
    LayeredMap(int resolution, int layers, Reading reading);

    int resolution_;
    int layers_;
    Object values_;
    Object depth_;
    Object framebuffer_;
};

} // namespace renderer::gpu
