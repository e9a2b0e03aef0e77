// A study small enough to be sat through in seconds: own images, two scenes, three conditions.
#pragma once

#include "renderer/imaging/encoded_image.h"

#include <filesystem>
#include <string>

namespace tests {

inline constexpr int picture_width = 200;
inline constexpr int picture_height = 150;
inline constexpr int pairs_asked = 6; ///< 2 scenes, 3 pairs of conditions each

/// Writes study.toml, instructions and the six pictures, each unlike all others.
void write_small_study(const std::filesystem::path& folder);

/// A study of the seed study's shape with pictures of our own: three scenes in three variants, four
/// conditions, three sittings a day apart, 54 pairs and 3 warm-ups in each, four for practice.
void write_seed_study(const std::filesystem::path& folder);

/// The picture of a scene and condition as it was written.
renderer::imaging::EncodedImage small_picture(const std::string& scene,
                                              const std::string& condition);

} // namespace tests
