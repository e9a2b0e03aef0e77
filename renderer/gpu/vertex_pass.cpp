// Transform feedback: nothing is rasterised.
#include "renderer/gpu/vertex_pass.h"

#include "renderer/gpu/target.h"

#include <epoxy/gl.h>

namespace renderer::gpu {

namespace {

unsigned create_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    glNamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_WIDTH, 1);
    glNamedFramebufferParameteri(name, GL_FRAMEBUFFER_DEFAULT_HEIGHT, 1);
    return name;
}

void delete_framebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}

} // namespace

VertexPass::VertexPass(Program program)
    : program_(std::move(program)), framebuffer_(create_framebuffer(), delete_framebuffer) {}

Expected<VertexPass> VertexPass::link(std::span<const ShaderPart> vertex,
                                      std::span<const char* const> captured) {
    auto program = Program::link_capturing(vertex, captured);
    if (!program)
        return tl::make_unexpected(program.error());
    return VertexPass(std::move(*program));
}

void VertexPass::run(const VertexArray& inputs, std::size_t count, const Buffer& rows) const {
    const DrawingInto nothing(framebuffer_.name(), 1, 1);
    program_.use();
    glEnable(GL_RASTERIZER_DISCARD);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, rows.name());
    glBeginTransformFeedback(GL_POINTS);
    inputs.draw_points(count);
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    glDisable(GL_RASTERIZER_DISCARD);
}

} // namespace renderer::gpu
