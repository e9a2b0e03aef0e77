// An own image is taken as it is: its colours are its author's, and a remark says what its file
// claims of them.
#include "experiment/stimuli/own_images.h"

#include "experiment/stimuli/scene_renderer.h"
#include "experiment/text_files.h"
#include "protocols/digest.h"
#include "renderer/imaging/image_files.h"

#include <fmt/core.h>

namespace experiment::stimuli {

namespace fs = std::filesystem;

tl::expected<void, std::string>
expect_size(const LoadedStudy& loaded, const protocols::Picture& picture, const fs::path& file) {
    const auto size = renderer::imaging::size_in_file(file);
    if (!size)
        return tl::unexpected(size.error());
    const auto wanted = picture_sizes(loaded.study).at(picture.scene);
    if (protocols::PictureSize{size->width, size->height} == wanted)
        return {};
    return tl::unexpected(fmt::format("{}: is {}x{} pixels, the study says {}x{}", file.string(),
                                      size->width, size->height, wanted.width, wanted.height));
}

tl::expected<PictureRecord, std::string> inspect_own_image(const LoadedStudy& loaded,
                                                           const protocols::Picture& picture) {
    const auto file = png_file(loaded.folder, picture);
    if (!fs::exists(file))
        return tl::unexpected(
            fmt::format("{}: is missing; put the picture of condition \"{}\" there", file.string(),
                        picture.condition.value));
    if (auto fits = expect_size(loaded, picture, file); !fits)
        return tl::unexpected(fits.error());
    const auto read = renderer::imaging::read_encoded(file);
    if (!read)
        return tl::unexpected(read.error());
    const auto& image = read->image;
    const auto bytes = read_text_file(file);
    if (!bytes)
        return tl::unexpected(bytes.error());
    PictureRecord record;
    record.renderer = "own image";
    record.width = image.width;
    record.height = image.height;
    record.png_sha256 = protocols::sha256_hexadecimal(*bytes);
    if (!read->colour_remark.empty())
        record.remark = read->colour_remark + "; shown as if it were sRGB";
    return record;
}

} // namespace experiment::stimuli
