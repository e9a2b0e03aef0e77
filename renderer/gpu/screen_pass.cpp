// One triangle that covers the viewport: two would meet along a diagonal.
#include "renderer/gpu/screen_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <utility>

namespace renderer::gpu {

namespace {

constexpr std::string_view corners = R"(
void main() {
    vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(corner, 0.0, 1.0);
})";

unsigned create_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
}

void delete_vertex_array(unsigned name) {
    glDeleteVertexArrays(1, &name);
}

} // namespace

ScreenPass::ScreenPass(Program program)
    : program_(std::move(program)), array_(create_vertex_array(), delete_vertex_array) {}

Expected<ScreenPass> ScreenPass::link(std::span<const ShaderPart> fragment) {
    const std::array vertex{ShaderPart{"screen pass", corners}};
    auto program = Program::link(vertex, fragment);
    if (!program)
        return tl::make_unexpected(program.error());
    return ScreenPass(std::move(*program));
}

void ScreenPass::run() const {
    program_.use();
    for (const GLenum meddler : {GL_FRAMEBUFFER_SRGB, GL_DITHER, GL_BLEND, GL_SCISSOR_TEST,
                                 GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE})
        glDisable(meddler); // without the depth test depth is not written either
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBindVertexArray(array_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

void ScreenPass::run(const PixelRectangle& rectangle) const {
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glViewport(rectangle.left, rectangle.bottom, rectangle.width, rectangle.height);
    run();
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

} // namespace renderer::gpu
