// The stimuli's manifest: how every picture was made, and at what cost.  stimuli/manifest.json
#pragma once

#include "protocols/vocabulary.h"

#include <tl/expected.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace experiment::stimuli {

/// The model a picture shows, as it was used.
struct ModelRecord {
    std::string file;   ///< where it was found; a body's name where there is no file
    std::string sha256; ///< of the file's bytes; empty for a body
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    bool operator==(const ModelRecord&) const = default;
};

/// What equalising the brightness did.  Luminances are linear means over the object's pixels.
struct BrightnessRecord {
    double mean_before = 0;
    double target = 0;
    double gain = 1;
    double clipped_share = 0;
    bool operator==(const BrightnessRecord&) const = default;
};

/// One picture.  What was not measured is absent, never zero.
struct PictureRecord {
    std::string
        recipe; ///< digest of everything that went into it; equal recipes are not rendered again
    std::string renderer;                     ///< "OpenGL: <renderer string>" or "own image"
    std::map<std::string, std::string> dials; ///< method, bands, law, ... as the study gave them
    std::string png_sha256;
    int width = 0;
    int height = 0;
    std::optional<ModelRecord> model;
    std::optional<BrightnessRecord> brightness;
    std::optional<double> precompute_seconds;
    std::optional<double> frame_milliseconds; ///< median of the draws of this picture
    std::optional<std::size_t> bytes_per_vertex;
    std::optional<std::string> decision; ///< what the method chose by itself, and why
    /// What that changes in the picture: root mean square of brightness, 1 = white, as the method
    /// reckoned beforehand, and as the picture without the choice says.
    std::optional<double> predicted_change, measured_change;
    std::optional<std::string> remark; ///< what was repaired or retried on the way
    bool operator==(const PictureRecord&) const = default;
};

struct Manifest {
    std::string program; ///< name and version
    std::string study_sha256;
    std::map<protocols::Picture, PictureRecord> pictures;
};

std::string manifest_json(const Manifest& manifest);

/// Errors: "<file_name>:<line>: <what is wrong>; <remedy>".
tl::expected<Manifest, std::string> parse_manifest(std::string_view text,
                                                   std::string_view file_name);

} // namespace experiment::stimuli
