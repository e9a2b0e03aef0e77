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
    glDisable(GL_DEPTH_TEST); // nor is depth written then
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glBindVertexArray(array_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
}

} // namespace renderer::gpu
