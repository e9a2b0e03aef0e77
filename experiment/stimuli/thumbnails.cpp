// Shrinking and encoding are the imaging room's; here is which pictures there are.
#include "experiment/stimuli/thumbnails.h"

#include "experiment/stimuli/scene_renderer.h"
#include "renderer/imaging/image_files.h"
#include "renderer/imaging/reduction.h"

#include <utility>

namespace experiment::stimuli {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;

namespace {

constexpr int longest_edge = 160;

tl::expected<report::Thumbnail, std::string> thumbnail(const fs::path& file,
                                                       const protocols::Picture& picture) {
    const auto read = imaging::read_encoded(file);
    if (!read)
        return tl::unexpected(read.error());
    const auto small = imaging::reduced(read->image, longest_edge);
    auto png = imaging::png_bytes(small);
    if (!png)
        return tl::unexpected(png.error());
    return report::Thumbnail{picture, std::move(*png), small.width, small.height};
}

std::vector<protocols::Picture> pictures_there(const LoadedStudy& loaded) {
    std::vector<protocols::Picture> there;
    for (const auto& scene : loaded.study.scenes)
        for (const auto& variant : shown_variants(loaded.study))
            for (const auto& condition : loaded.study.conditions)
                if (const protocols::Picture picture{scene.id, variant.id, condition.id};
                    fs::exists(png_file(loaded.folder, picture)))
                    there.push_back(picture);
    return there;
}

} // namespace

tl::expected<std::vector<report::Thumbnail>, std::string>
thumbnails(const LoadedStudy& loaded, const std::function<void(double)>& progress) {
    const auto there = pictures_there(loaded);
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
