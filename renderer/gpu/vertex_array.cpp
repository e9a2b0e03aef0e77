// Vertex arrays by direct state access.
#include "renderer/gpu/vertex_array.h"

#include "renderer/contract.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cstdint>

namespace renderer::gpu {

namespace {

unsigned create_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
}

void delete_vertex_array(unsigned name) {
    glDeleteVertexArrays(1, &name);
}

} // namespace

VertexArray::VertexArray() : array_(create_vertex_array(), delete_vertex_array) {}

unsigned VertexArray::feed(unsigned location, const Buffer& rows, int components) {
    EXPECTS(components >= 1);
    const unsigned binding = location; // one buffer to a binding, numbered as its first input
    const auto stride = components * static_cast<int>(sizeof(float));
    glVertexArrayVertexBuffer(array_.name(), binding, rows.name(), 0, stride);
    for (int first = 0; first < components; first += 4, ++location) {
        const auto offset = static_cast<GLuint>(first) * static_cast<GLuint>(sizeof(float));
        glEnableVertexArrayAttrib(array_.name(), location);
        glVertexArrayAttribFormat(array_.name(), location, std::min(4, components - first),
                                  GL_FLOAT, GL_FALSE, offset);
        glVertexArrayAttribBinding(array_.name(), location, binding);
    }
    return location;
}

void VertexArray::set_triangles(const Buffer& indices) {
    glVertexArrayElementBuffer(array_.name(), indices.name());
    index_count_ = static_cast<int>(indices.bytes() / sizeof(std::uint32_t));
}

// All state that decides about our pixels is set here: a window's other drawing may have left
// anything behind.
void VertexArray::draw() const {
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBindVertexArray(array_.name());
    glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    glBindVertexArray(0);
}

} // namespace renderer::gpu
