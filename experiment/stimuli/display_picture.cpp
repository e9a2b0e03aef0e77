// Stimuli are stored with 16 bits, and displays are sent 8.
#include "experiment/stimuli/display_picture.h"

#include "experiment/stimuli/own_images.h"
#include "experiment/stimuli/scene_renderer.h"
#include "renderer/imaging/image_files.h"

#include <fmt/core.h>

namespace experiment::stimuli {

namespace imaging = renderer::imaging;

namespace {

imaging::LinearImage linear(const imaging::EncodedImage& image) {
    imaging::LinearImage light{image.width, image.height, {}, {}};
    const auto pixels = image.codes.size() / 3;
    light.coverage.assign(pixels, 1.0F);
    light.pixels.reserve(pixels);
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        light.pixels.push_back(imaging::light_at(image, pixel));
    return light;
}

renderer::gpu::Picture8 bytes(const imaging::EncodedImage& image) {
    renderer::gpu::Picture8 picture{image.width, image.height, {}};
    picture.rgb.reserve(image.codes.size());
    for (const auto code : image.codes)
        picture.rgb.push_back(static_cast<std::uint8_t>(code));
    return picture;
}

} // namespace

tl::expected<renderer::gpu::Picture8, std::string>
picture_for_display(const LoadedStudy& loaded, const protocols::Picture& picture) {
    const auto file = png_file(loaded.folder, picture);
    if (auto fits = expect_size(loaded, picture, file); !fits)
        return tl::unexpected(fits.error());
    auto read = imaging::read_encoded(file);
    if (!read)
        return tl::unexpected(read.error());
    const auto& image = read->image;
    return bytes(image.bits == 8 ? image : imaging::encode_8bit(linear(image)));
}

} // namespace experiment::stimuli
