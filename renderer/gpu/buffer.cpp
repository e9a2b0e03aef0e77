// Buffers of fixed size, made and written without binding them.
#include "renderer/gpu/buffer.h"

#include "renderer/contract.h"

#include <epoxy/gl.h>

namespace renderer::gpu {

namespace {

unsigned create_buffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
}

void delete_buffer(unsigned name) {
    glDeleteBuffers(1, &name);
}

} // namespace

Buffer::Buffer(std::span<const std::byte> content)
    : buffer_(create_buffer(), delete_buffer), bytes_(content.size()) {
    EXPECTS(!content.empty());
    glNamedBufferStorage(buffer_.name(), static_cast<GLsizeiptr>(content.size()), content.data(),
                         GL_DYNAMIC_STORAGE_BIT);
}

Buffer::Buffer(std::size_t bytes) : buffer_(create_buffer(), delete_buffer), bytes_(bytes) {
    EXPECTS(bytes > 0);
    glNamedBufferStorage(buffer_.name(), static_cast<GLsizeiptr>(bytes), nullptr,
                         GL_DYNAMIC_STORAGE_BIT);
}

void Buffer::replace(std::span<const std::byte> content) {
    EXPECTS(content.size() == bytes_);
    glNamedBufferSubData(buffer_.name(), 0, static_cast<GLsizeiptr>(content.size()),
                         content.data());
}

void Buffer::bind_uniform_block(unsigned binding) const {
    glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffer_.name());
}

void Buffer::bind_storage_block(unsigned binding) const {
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_.name());
}

} // namespace renderer::gpu
