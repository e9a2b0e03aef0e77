// Pictures on a frame buffer, pixel for pixel.
#include "renderer/gpu/pixel_canvas.h"

#include "renderer/contract.h"

#include <epoxy/gl.h>

#include <array>

namespace renderer::gpu {

namespace {

void delete_texture(unsigned name) {
    glDeleteTextures(1, &name);
}

void delete_framebuffer(unsigned name) {
    glDeleteFramebuffers(1, &name);
}

unsigned create_texture() {
    GLuint name = 0;
    glCreateTextures(GL_TEXTURE_2D, 1, &name);
    return name;
}

unsigned create_framebuffer() {
    GLuint name = 0;
    glCreateFramebuffers(1, &name);
    return name;
}

// With these, a code value arrives as it was sent.
void leave_values_alone() {
    for (const GLenum meddler :
         {GL_FRAMEBUFFER_SRGB, GL_DITHER, GL_BLEND, GL_SCISSOR_TEST, GL_MULTISAMPLE})
        glDisable(meddler);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

GLuint drawn_framebuffer() {
    GLint name = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &name);
    return static_cast<GLuint>(name);
}

} // namespace

UploadedPicture::UploadedPicture(const Picture8& picture)
    : width_(picture.width), height_(picture.height), texture_(create_texture(), delete_texture),
      framebuffer_(create_framebuffer(), delete_framebuffer) {
    EXPECTS(width_ >= 1 && height_ >= 1);
    EXPECTS(picture.rgb.size() ==
            3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    glTextureStorage2D(texture_.name(), 1, GL_RGBA8, width_, height_);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture_.name(), 0, 0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE,
                        picture.rgb.data());
    glNamedFramebufferTexture(framebuffer_.name(), GL_COLOR_ATTACHMENT0, texture_.name(), 0);
}

void PixelCanvas::clear(std::uint8_t code) const {
    leave_values_alone();
    const float grey = static_cast<float>(code) / 255.0f; // 0.5 would be 127 or 128, by driver
    const std::array<float, 4> colour{grey, grey, grey, 1.0f};
    glClearNamedFramebufferfv(drawn_framebuffer(), GL_COLOR, 0, colour.data());
}

void PixelCanvas::draw(const UploadedPicture& picture, int left, int top) const {
    const int right = left + picture.width();
    const int bottom = top + picture.height();
    EXPECTS(left >= 0 && top >= 0 && right <= width_ && bottom <= height_);
    leave_values_alone();
    // OpenGL counts rows upward; the picture's first row is the top one.
    glBlitNamedFramebuffer(picture.framebuffer(), drawn_framebuffer(), 0, 0, picture.width(),
                           picture.height(), left, height_ - top, right, height_ - bottom,
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

Picture8 PixelCanvas::read(int left, int top, int width, int height) const {
    EXPECTS(left >= 0 && top >= 0 && width >= 1 && height >= 1);
    EXPECTS(left + width <= width_ && top + height <= height_);
    const auto row = 3 * static_cast<std::size_t>(width);
    std::vector<std::uint8_t> upward(row * static_cast<std::size_t>(height));
    GLint previous = 0;
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &previous);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_framebuffer());
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(left, height_ - top - height, width, height, GL_RGB, GL_UNSIGNED_BYTE,
                 upward.data());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(previous));
    Picture8 picture{width, height, {}};
    picture.rgb.reserve(upward.size());
    for (auto end = upward.end(); end != upward.begin(); end -= static_cast<std::ptrdiff_t>(row))
        picture.rgb.insert(picture.rgb.end(), end - static_cast<std::ptrdiff_t>(row), end);
    return picture;
}

void PixelCanvas::finish() const {
    glFinish();
}

} // namespace renderer::gpu
