// The viewer: inputs, pictures and controls, again and again until it is done.
#pragma once

#include "experiment/viewer/display.h"
#include "experiment/viewer/exhibit.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace experiment::viewer {

struct ViewerOptions {
    std::vector<std::string> strokes; ///< keys pressed at the start, one before each picture
    std::optional<int> frames;        ///< ends after so many pictures that follow the strokes
    std::optional<std::filesystem::path> screenshot; ///< the last of them, *.png, and *.exr beside
    std::function<void(double)> progress; ///< hears how far tracing is, 0..1, from any thread
};

/// Shows the exhibit until a person quits, or the options say that it was enough.
/// Errors: an exhibit whose only scene has a model that cannot be shown; OpenGL's own; with
/// `screenshot`, whatever keeps a side from being drawn.  Otherwise what goes wrong is told on the
/// screen.  EXPECTS strokes of the key table, and at least one frame.
tl::expected<void, std::string>
run_viewer(const Exhibit& exhibit, Display& display, const ViewerOptions& options);

} // namespace experiment::viewer
