// Supersampling by whole pictures: it needs no multisampled buffers and treats all methods alike.
#include "renderer/pictures/picture.h"

#include "renderer/contract.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/target.h"

#include <glm/ext/matrix_transform.hpp>

#include <cstddef>

namespace renderer::pictures {

namespace {

double bit_reversed(unsigned index) {
    double value = 0;
    for (double digit = 0.5; index != 0; index >>= 1, digit /= 2)
        value += (index & 1U) != 0 ? digit : 0;
    return value;
}

Scene moved_by_pixels(Scene scene, glm::dvec2 offset, int width, int height) {
    const glm::dvec3 clip(2 * offset.x / width, 2 * offset.y / height, 0);
    scene.camera.clip_from_view = glm::translate(glm::dmat4(1), clip) * scene.camera.clip_from_view;
    return scene;
}

imaging::LinearImage
top_row_first(const std::vector<double>& sums, int width, int height, int samples) {
    const auto columns = static_cast<std::size_t>(width), rows = static_cast<std::size_t>(height);
    imaging::LinearImage image;
    image.width = width;
    image.height = height;
    image.pixels.reserve(columns * rows);
    image.coverage.reserve(columns * rows);
    for (std::size_t row = rows; row-- > 0;)
        for (std::size_t column = 0; column < columns; ++column) {
            const double* sum = &sums[4 * (row * columns + column)];
            const auto mean = [&](int i) { return static_cast<float>(sum[i] / samples); };
            image.pixels.push_back({mean(0), mean(1), mean(2)});
            image.coverage.push_back(mean(3));
        }
    return image;
}

} // namespace

std::vector<glm::dvec2> sample_offsets(int samples) {
    EXPECTS(samples >= 1);
    std::vector<glm::dvec2> offsets;
    for (int i = 0; i < samples; ++i)
        offsets.emplace_back((i + 0.5) / samples - 0.5,
                             bit_reversed(static_cast<unsigned>(i)) + 0.5 / samples - 0.5);
    return offsets;
}

Expected<imaging::LinearImage>
render_picture(methods::Method& method, const Scene& scene, int width, int height, int samples) {
    const auto target = gpu::Target::create(width, height);
    if (!target)
        return tl::make_unexpected(target.error());
    if (const auto ready = method.update(scene); !ready)
        return tl::make_unexpected(ready.error());

    std::vector<float> drawn;
    std::vector<double> sums(4 * static_cast<std::size_t>(width) *
                             static_cast<std::size_t>(height));
    const auto drawing = target->draw_into();
    for (const auto& offset : sample_offsets(samples)) {
        target->clear();
        method.draw(moved_by_pixels(scene, offset, width, height));
        target->read(drawn);
        for (std::size_t i = 0; i < sums.size(); ++i)
            sums[i] += static_cast<double>(drawn[i]);
    }
    if (const auto good = gpu::check("a picture"); !good)
        return tl::make_unexpected(good.error());
    return top_row_first(sums, width, height, samples);
}

} // namespace renderer::pictures
