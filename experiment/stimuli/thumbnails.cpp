// Box filter over whole blocks of pixels; what is left over at the right and lower edge is cut off.
#include "experiment/stimuli/thumbnails.h"

#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "renderer/imaging/image_files.h"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>

namespace experiment::stimuli {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;

namespace {

constexpr int longest_edge = 160;

imaging::LinearImage shrunk(const imaging::EncodedImage& image, int factor) {
    imaging::LinearImage small{image.width / factor, image.height / factor, {}, {}};
    const auto area = static_cast<float>(factor * factor);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) {
            renderer::LinearRgb sum;
            for (int dy = 0; dy < factor; ++dy)
                for (int dx = 0; dx < factor; ++dx) {
                    const auto pixel = imaging::light_at(
                        image, static_cast<std::size_t>((y * factor + dy) * image.width +
                                                        x * factor + dx));
                    sum.r += pixel.r / area;
                    sum.g += pixel.g / area;
                    sum.b += pixel.b / area;
                }
            small.pixels.push_back(sum);
        }
    small.coverage.assign(small.pixels.size(), 1.0F);
    return small;
}

/// The bytes of an 8-bit PNG file: image files are written to disk only, so by way of one.
tl::expected<std::string, std::string> png_bytes(const imaging::LinearImage& image) {
    const auto file =
        fs::temp_directory_path() / fmt::format("pairlight-thumbnail-{}.png", getpid());
    auto bytes = imaging::write_png(file, imaging::encode_8bit(image)).and_then([&] {
        return read_text_file(file);
    });
    std::error_code ignored;
    fs::remove(file, ignored);
    return bytes;
}

tl::expected<report::Thumbnail, std::string> thumbnail(const fs::path& file,
                                                       const protocols::Picture& picture) {
    const auto read = imaging::read_encoded(file);
    if (!read)
        return tl::unexpected(read.error());
    const auto longer = std::max(read->image.width, read->image.height);
    const auto small = shrunk(read->image, std::max(1, (longer + longest_edge - 1) / longest_edge));
    auto png = png_bytes(small);
    if (!png)
        return tl::unexpected(png.error());
    return report::Thumbnail{picture, std::move(*png), small.width, small.height};
}

} // namespace

tl::expected<std::vector<report::Thumbnail>, std::string>
thumbnails(const LoadedStudy& loaded, const std::function<void(double)>& progress) {
    std::vector<protocols::Picture> there;
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions)
                if (const protocols::Picture picture{scene.id, variant.id, condition.id};
                    fs::exists(png_file(loaded.folder, picture)))
                    there.push_back(picture);
    std::vector<report::Thumbnail> all;
    for (const auto& picture : there) {
        auto one = thumbnail(png_file(loaded.folder, picture), picture);
        if (!one)
            return tl::unexpected(one.error());
        all.push_back(std::move(*one));
        progress(static_cast<double>(all.size()) / static_cast<double>(there.size()));
    }
    return all;
}

} // namespace experiment::stimuli
