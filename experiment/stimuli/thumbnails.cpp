// From stimulus files to small PNGs.
#include "experiment/stimuli/thumbnails.h"

#include "experiment/stimuli/display_picture.h"
#include "renderer/imaging/image_files.h"
#include "renderer/imaging/reduction.h"

namespace experiment::stimuli {

namespace {

tl::expected<report::Thumbnail, std::string>
thumbnail(const LoadedStudy& loaded, const protocols::Picture& picture, int greatest_edge) {
    const auto file = find_picture(loaded, picture);
    if (!file)
        return tl::unexpected(file.error());
    const auto read = renderer::imaging::read_encoded(*file);
    if (!read)
        return tl::unexpected(read.error());
    const auto small = renderer::imaging::reduced(read->image, greatest_edge);
    auto png = renderer::imaging::png_bytes(small);
    if (!png)
        return tl::unexpected(png.error());
    return report::Thumbnail{picture, std::move(*png), small.width, small.height};
}

} // namespace

tl::expected<std::vector<report::Thumbnail>, std::string> thumbnails(const LoadedStudy& loaded,
                                                                     int greatest_edge) {
    std::vector<report::Thumbnail> all;
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : protocols::shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions) {
                auto one = thumbnail(loaded, {scene.id, variant.id, condition.id}, greatest_edge);
                if (!one)
                    return tl::unexpected(one.error());
                all.push_back(std::move(*one));
            }
    return all;
}

} // namespace experiment::stimuli
