// Frame buffers and their textures, by direct state access.
#include "renderer/gpu/target.h"

#include "renderer/contract.h"
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

unsigned create_layers(int resolution, int layers, GLenum filter) {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D_ARRAY, 1, &name);
    glTextureStorage3D(name, 1, GL_R32F, resolution, resolution, layers);
    glTextureParameteri(name, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(filter));
    glTextureParameteri(name, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(filter));
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
void clear_without_masks(unsigned framebuffer) {
    constexpr std::array<float, 4> nothing{};
    constexpr float farthest = 1;
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearNamedFramebufferfv(framebuffer, GL_COLOR, 0, nothing.data());
    glClearNamedFramebufferfv(framebuffer, GL_DEPTH, 0, &farthest);
}

} // namespace

Viewport bound_viewport() {
    std::array<int, 4> box{};
    glGetIntegerv(GL_VIEWPORT, box.data());
    return {box[0], box[1], box[2], box[3]};
}

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

DrawingWithin::DrawingWithin(const Viewport& part) : previous_(bound_viewport()) {
    glViewport(part.left, part.bottom, part.width, part.height);
}

DrawingWithin::~DrawingWithin() {
    glViewport(previous_.left, previous_.bottom, previous_.width, previous_.height);
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
    clear_without_masks(framebuffer_.name());
}

void Target::bind_texture(unsigned unit) const {
    glBindTextureUnit(unit, colour_.name());
}

void Target::read(std::vector<float>& rgba) const {
    rgba.resize(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glGetTextureImage(colour_.name(), 0, GL_RGBA, GL_FLOAT,
                      static_cast<GLsizei>(rgba.size() * sizeof(float)), rgba.data());
}

LayeredMap::LayeredMap(int resolution, int layers, Reading reading)
    : resolution_(resolution), layers_(layers),
      values_(
          create_layers(resolution, layers, reading == Reading::Linear ? GL_LINEAR : GL_NEAREST),
          delete_texture),
      depth_(create_texture(GL_DEPTH_COMPONENT32F, resolution, resolution), delete_texture),
      framebuffer_(create_framebuffer(), delete_framebuffer) {
    glNamedFramebufferTextureLayer(framebuffer_.name(), GL_COLOR_ATTACHMENT0, values_.name(), 0, 0);
    glNamedFramebufferTexture(framebuffer_.name(), GL_DEPTH_ATTACHMENT, depth_.name(), 0);
}

Expected<LayeredMap> LayeredMap::create(int resolution, int layers, Reading reading) {
    EXPECTS(layers >= 1);
    if (const auto size = check_size("a depth map", resolution, resolution); !size)
        return tl::make_unexpected(size.error());
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    if (layers > most)
        return tl::make_unexpected(
            fmt::format("a depth map of {} layers, expected 1 to {}", layers, most));
    LayeredMap map(resolution, layers, reading);
    if (const auto complete = check_complete(map.framebuffer_.name(), "a depth map"); !complete)
        return tl::make_unexpected(complete.error());
    return map;
}

DrawingInto LayeredMap::draw_into(int layer) const {
    EXPECTS(layer >= 0 && layer < layers_);
    glNamedFramebufferTextureLayer(framebuffer_.name(), GL_COLOR_ATTACHMENT0, values_.name(), 0,
                                   layer);
    clear_without_masks(framebuffer_.name());
    glTextureBarrier(); // what was drawn into other layers can be read from now on
    return {framebuffer_.name(), resolution_, resolution_};
}

void LayeredMap::bind_texture(unsigned unit) const {
    glBindTextureUnit(unit, values_.name());
}

std::vector<float> LayeredMap::read() const {
    std::vector<float> values(bytes() / sizeof(float));
    glGetTextureImage(values_.name(), 0, GL_RED, GL_FLOAT, static_cast<GLsizei>(bytes()),
                      values.data());
    return values;
}

std::size_t LayeredMap::bytes() const {
    const auto edge = static_cast<std::size_t>(resolution_);
    return edge * edge * static_cast<std::size_t>(layers_) * sizeof(float);
}

} // namespace renderer::gpu
