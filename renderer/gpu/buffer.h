// Numbers in video memory: vertices, indices, uniform blocks.
#pragma once

#include "renderer/gpu/object.h"

#include <cstddef>
#include <span>

namespace renderer::gpu {

class Buffer {
  public:
    /// Errors: EXPECTS that there is something to hold.
    explicit Buffer(std::span<const std::byte> content);

    /// A buffer to be filled by `replace`.  Errors: EXPECTS more than 0 bytes.
    explicit Buffer(std::size_t bytes);

    /// A buffer holding a row of plain values.
    template <class T>
    static Buffer holding(std::span<const T> values) {
        return Buffer(std::as_bytes(values));
    }

    /// Puts other content of the same size in its place.
    void replace(std::span<const std::byte> content);

    /// The same for one plain value, as uniform blocks are.
    template <class T>
    void replace_by(const T& value) {
        replace(std::as_bytes(std::span<const T, 1>(&value, 1)));
    }

    /// Makes it the uniform block of that binding in every shader.
    void bind_uniform_block(unsigned binding) const;

    /// Makes it the storage block of that binding in every shader.
    void bind_storage_block(unsigned binding) const;

    unsigned name() const { return buffer_.name(); }

    std::size_t bytes() const { return bytes_; }

  private:
    Object buffer_;
    std::size_t bytes_;
};

} // namespace renderer::gpu
