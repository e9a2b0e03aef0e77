// Which buffers feed a vertex shader, and drawing them as triangles.
#pragma once

#include "renderer/gpu/buffer.h"
#include "renderer/gpu/object.h"

#include <cstddef>

namespace renderer::gpu {

/// How a number lies in memory.  A shader reads floats whatever it is.
enum class Component {
    Float32,
    Float16,
    Fraction8 ///< signed byte, read as byte / 127
};

std::size_t bytes_of(Component component);

/// Rows of numbers, one row to a vertex, without gaps.
struct Rows {
    int components = 1;
    Component component = Component::Float32;
    int per_input = 4; ///< numbers that fill one shader input, 1..4
};

/// Refers to buffers that somebody else keeps alive.
class VertexArray {
  public:
    VertexArray();

    /// Feeds rows of any number of components to the inputs from `location` on; missing components
    /// of the last input read 0, 0, 1.  Returns the next free location.
    unsigned feed(unsigned location, const Buffer& buffer, const Rows& rows);

    /// Three 32-bit indices to a triangle.
    void set_triangles(const Buffer& indices);

    /// Draws all triangles, front and back, nearest wins, no blending, into the bound frame buffer
    /// with the program in use.
    void draw() const;

    /// Runs the vertex shader of the program in use once for each of `count` vertices, as points.
    void draw_points(std::size_t count) const;

  private:
    Object array_;
    int index_count_ = 0;
};

} // namespace renderer::gpu
