// One triangle that covers the rectangle: two of them would share a seam.
#include "renderer/gpu/pixel_pass.h"

#include <epoxy/gl.h>

#include <array>
#include <utility>

namespace renderer::gpu {

namespace {

constexpr const char* covering_triangle = R"(
void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
)";

void delete_vertex_array(unsigned name) {
    glDeleteVertexArrays(1, &name);
}

unsigned create_vertex_array() {
    GLuint name = 0;
    glCreateVertexArrays(1, &name);
    return name;
}

} // namespace

PixelPass::PixelPass(Program program)
    : program_(std::move(program)), no_inputs_(create_vertex_array(), delete_vertex_array) {}

Expected<PixelPass> PixelPass::link(std::span<const ShaderPart> fragment) {
    const std::array vertex{ShaderPart{"covering triangle", covering_triangle}};
    auto program = Program::link(vertex, fragment);
    if (!program)
        return tl::make_unexpected(program.error());
    return PixelPass(std::move(*program));
}

void PixelPass::run(const PixelRectangle& rectangle) const {
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glViewport(rectangle.left, rectangle.bottom, rectangle.width, rectangle.height);
    for (const GLenum meddler : {GL_FRAMEBUFFER_SRGB, GL_DITHER, GL_BLEND, GL_SCISSOR_TEST,
                                 GL_DEPTH_TEST, GL_STENCIL_TEST, GL_CULL_FACE})
        glDisable(meddler);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    program_.use();
    glBindVertexArray(no_inputs_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
}

} // namespace renderer::gpu
