// Frame buffers and their textures, by direct state access.
#include "renderer/gpu/target.h"

#include "renderer/gpu/context.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

namespace renderer::gpu {

namespace {

void delete_texture(unsigned name) {
    glDeleteTextures(1, &name);
}

void delete_framebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}

unsigned create_texture(GLenum format, int width, int height) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    glTextureStorage2D(name, 1, format, width, height);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTextureParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTextureParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return name;
}

unsigned create_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}

Expected<void> check_size(const char* what, int width, int height) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &largest);
    if (width >= 1 && height >= 1 && width <= largest && height <= largest)
        return {};
    return tl::make_unexpected(fmt::format("{} of {} x {} texels, expected 1 to {} along an edge",
                                           what, width, height, largest));
}

Expected<void> check_complete(unsigned framebuffer, const char* what) {
    const GLenum status = glCheckNamedFramebufferStatus(framebuffer, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        return tl::make_unexpected(
            fmt::format("{}: the frame buffer is incomplete, status 0x{:04x}", what, status));
    return check(what);
}

// Clearing obeys the masks and the scissor rectangle, whoever set them.
void clear_without_masks(unsigned framebuffer, bool with_colour) {
    constexpr std::array<float, 4> nothing{};
    constexpr float farthest = 1;
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    if (with_colour)
        glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, nothing.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
}

} // namespace

DrawingInto::DrawingInto(unsigned framebuffer, int width, int height) {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &previous_framebuffer_);
    glGetIntegerv(GL_VIEWPORT, previous_viewport_.data());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
}

DrawingInto::~DrawingInto() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(previous_framebuffer_));
    glViewport(previous_viewport_[0], previous_viewport_[1], previous_viewport_[2],
               previous_viewport_[3]);
}

Target::Target(int width, int height)
    : width_(width), height_(height),
      colour_(create_texture(GL_RGBA32F, width, height), delete_texture),
      depth_(create_texture(GL_DEPTH_COMPONENT32F, width, height), delete_texture),
      framebuffer_(create_framebuffer(), delete_framebuffer) {
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, colour_.name(), 0);
    glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
}

Expected<Target> Target::create(int width, int height) {
    if (const auto size = check_size("a picture", width, height); !size)
        return tl::make_unexpected(size.error());
    Target target(width, height);
    if (const auto complete = check_complete(target.framebuffer_.name(), "a picture"); !complete)
        return tl::make_unexpected(complete.error());
    return target;
}

void Target::clear() const {
    clear_without_masks(framebuffer_.name(), true);
}

void Target::bind_texture(unsigned unit) const {
    glBindTextureUnit(unit, colour_.name());
}

void Target::read(std::vector<float>& rgba) const {
    rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glGetTextureImage(colour_.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(rgba.size() * sizeof(float)), rgba.data());
}

DepthMap::DepthMap(int resolution)
    : resolution_(resolution),
      depth_(create_texture(GL_DEPTH_COMPONENT32F, resolution, resolution), delete_texture),
      framebuffer_(create_framebuffer(), delete_framebuffer) {
    glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
    glNamedFramebufferDrawBuffer(framebuffer_.name(), GL_NONE);
}

Expected<DepthMap> DepthMap::create(int resolution) {
    if (const auto size = check_size("a depth map", resolution, resolution); !size)
        return tl::make_unexpected(size.error());
    DepthMap map(resolution);
    if (const auto complete = check_complete(map.framebuffer_.name(), "a depth map"); !complete)
        return tl::make_unexpected(complete.error());
    return map;
}

void DepthMap::clear() const {
    clear_without_masks(framebuffer_.name(), false);
}

void DepthMap::bind_texture(unsigned unit) const {
    glBindTextureUnit(unit, depth_.name());
}

} // namespace renderer::gpu
