// Pictures on disk: linear EXR, encoded PNG, and whatever a researcher brings.
//
// The one door to OpenImageIO, in a library of its own: it costs every process that links it 0.3 s
// at the start.  Writing is atomic: a file is there whole, or as it was before.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/encoded_image.h"
#include "renderer/imaging/layers.h"
#include "renderer/imaging/linear_image.h"

#include <filesystem>
#include <string>
#include <vector>

namespace renderer::imaging {

/// A line of text kept inside a picture's file, such as {"stimulus:id", "bunny/back/shss-5"}.
struct TextEntry {
    std::string name;
    std::string text;
    bool operator==(const TextEntry&) const = default;
};

/// A picture made elsewhere.
struct FileImage {
    EncodedImage image;
    /// "", or what the file says of its colours that is not sRGB: "ICC profile 'Adobe RGB (1998)'",
    /// "gamma 1.8".  The codes are the file's own, unconverted.
    std::string colour_remark;
};

/// Of the pictures that are read, pixels: what a study can ask for.
constexpr int longest_edge = 16384;

struct FileSize {
    int width = 0, height = 0;
};

/// The size that a picture's file says it has, before any pixel is read.
/// Errors: the file is missing, no picture, or beyond `longest_edge`, as for every reader below.
Expected<FileSize> size_in_file(const std::filesystem::path& file);

/// Writes half-precision RGBA EXR, linear, colours premultiplied.
/// Errors: the folder or file cannot be written; a pixel that half cannot hold (not finite, or
///         above 65504), named.  EXPECTS on sizes.
Expected<void> write_exr(const std::filesystem::path& file,
                         const LinearImage& image,
                         const std::vector<TextEntry>& texts = {});

/// Channels beside R, G, B and A are left alone.
/// Errors: the file is missing, no picture, or not EXR with the channels R, G, B, A.
Expected<LinearImage> read_exr(const std::filesystem::path& file);

/// Writes EXR with a 32-bit float channel for each layer; the first four are R, G, B, A, so that
/// other programs and `read_exr` see a picture.
/// Errors: the folder or file cannot be written.  EXPECTS on sizes and the first four names.
Expected<void> write_layers(const std::filesystem::path& file,
                            const LayeredImage& image,
                            const std::vector<TextEntry>& texts = {});

/// Errors: the file is missing, no picture, or not EXR with the channels R, G, B, A.
Expected<LayeredImage> read_layers(const std::filesystem::path& file);

/// Writes an opaque sRGB PNG with as many bits as the picture has.
/// Errors: the folder or file cannot be written.  EXPECTS on sizes.
Expected<void> write_png(const std::filesystem::path& file,
                         const EncodedImage& image,
                         const std::vector<TextEntry>& texts = {});

/// The bytes of a PNG file, for pictures that are carried inside something else.
/// Errors: those of the encoder.  EXPECTS on sizes.
Expected<std::string> png_bytes(const EncodedImage& image);

/// Reads PNG, JPEG or TIFF of 8 or 16 bits per channel.
/// Errors: the file is missing or no picture; channels other than RGB or RGBA; alpha that is not
///         opaque everywhere; pixels that are not 8 or 16-bit integers; stored turned or mirrored.
Expected<FileImage> read_encoded(const std::filesystem::path& file);

/// The lines of text in a picture's file, in the file's order; whatever else is recorded as text
/// there comes along.  Errors: the file is missing or no picture.
Expected<std::vector<TextEntry>> read_texts(const std::filesystem::path& file);

} // namespace renderer::imaging
