// Files of a snapshot.
#include "experiment/viewer/snapshot.h"

#include "renderer/imaging/image_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace experiment::viewer {

namespace fs = std::filesystem;
namespace imaging = renderer::imaging;

namespace {

imaging::EncodedImage encoded(const renderer::gpu::Picture8& picture) {
    return {picture.width, picture.height, 8, {picture.rgb.begin(), picture.rgb.end()}};
}

fs::path with_ending(const fs::path& stem, const std::string& ending) {
    return stem.string() + ending;
}

} // namespace

tl::expected<void, std::string> write_snapshot(const fs::path& stem, const Snapshot& snapshot) {
    const std::vector<imaging::TextEntry> texts{{"Software", PAIRLIGHT_PROGRAM_VERSION}};
    auto written = imaging::write_png(with_ending(stem, ".png"), encoded(snapshot.window), texts);
    for (const auto& [addition, light] : snapshot.light)
        if (written)
            written = imaging::write_exr(with_ending(stem, addition + ".exr"), light, texts);
    return written;
}

fs::path free_stem(const std::string& name) {
    auto plain = name;
    std::ranges::replace_if(
        plain,
        [](unsigned char letter) {
            return std::isalnum(letter) == 0 && letter != '-' && letter != '_' && letter != '.';
        },
        '-');
    for (int number = 1;; ++number)
        if (const auto stem = fmt::format("{}-{:03}", plain, number); !fs::exists(stem + ".png"))
            return stem;
}

} // namespace experiment::viewer
