// Which buffers feed a vertex shader, and drawing them as triangles.
#pragma once

#include "renderer/gpu/buffer.h"
#include "renderer/gpu/object.h"

namespace renderer::gpu {

/// Refers to buffers that somebody else keeps alive.
class VertexArray {
  public:
    VertexArray();

    /// Feeds rows of `components` floats (any number) to the inputs from `location` on, four to an
    /// input; missing components of the last one read 0, 0, 1.  Returns the next free location.
    unsigned feed(unsigned location, const Buffer& rows, int components);

    /// Three 32-bit indices to a triangle.
    void set_triangles(const Buffer& indices);

    /// Draws all triangles, front and back, nearest wins, no blending, into the bound frame buffer
    /// with the program in use.
    void draw() const;

  private:
    Object array_;
    int index_count_ = 0;
};

} // namespace renderer::gpu
