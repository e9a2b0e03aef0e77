// Pictures that the viewer takes: the window as it is seen, and the light in it.
#pragma once

#include "renderer/gpu/pixel_canvas.h"
#include "renderer/imaging/linear_image.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <map>
#include <string>

namespace experiment::viewer {

struct Snapshot {
    renderer::gpu::Picture8 window;
    std::map<std::string, renderer::imaging::LinearImage> light; ///< by what is added to the name
};

/// Writes <stem>.png, and <stem><addition>.exr for each of the light's pictures.
/// Errors: those of the files.
tl::expected<void, std::string> write_snapshot(const std::filesystem::path& stem,
                                               const Snapshot& snapshot);

/// "<name>-001" in the current folder, or the first number that is free; letters that could mean
/// something to a file system become '-'.
std::filesystem::path free_stem(const std::string& name);

} // namespace experiment::viewer
