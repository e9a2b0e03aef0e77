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

GLenum type_of(Component component) {
    switch (component) {
    case Component::Float16:
        return GL_HALF_FLOAT;
    case Component::Fraction8:
        return GL_BYTE;
    case Component::Float32:
        break;
    }
    return GL_FLOAT;
}

} // namespace

std::size_t bytes_of(Component component) {
    switch (component) {
    case Component::Float16:
        return 2;
    case Component::Fraction8:
        return 1;
    case Component::Float32:
        break;
    }
    return 4;
}

VertexArray::VertexArray() : array_(create_vertex_array(), delete_vertex_array) {}

unsigned VertexArray::feed(unsigned location, const Buffer& buffer, const Rows& rows) {
    EXPECTS(rows.components >= 1);
    EXPECTS(rows.per_input >= 1 && rows.per_input <= 4);
    const unsigned binding = location; // one buffer to a binding, numbered as its first input
    const auto bytes = static_cast<int>(bytes_of(rows.component));
    glVertexArrayVertexBuffer(array_.name(), binding, buffer.name(), 0, rows.components * bytes);
    for (int first = 0; first < rows.components; first += rows.per_input, ++location) {
        glEnableVertexArrayAttrib(array_.name(), location);
        glVertexArrayAttribFormat(
            array_.name(), location, std::min(rows.per_input, rows.components - first),
            type_of(rows.component), GL_TRUE, static_cast<GLuint>(first * bytes));
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

void VertexArray::draw_points(std::size_t count) const {
    glBindVertexArray(array_.name());
    glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(count));
    glBindVertexArray(0);
}

} // namespace renderer::gpu
