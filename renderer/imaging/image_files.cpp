// Image files by OpenImageIO.
#include "renderer/imaging/image_files.h"

#include "renderer/contract.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>

namespace renderer::imaging {

namespace {

namespace fs = std::filesystem;
using OIIO::ImageInput;
using OIIO::ImageOutput;
using OIIO::ImageSpec;
using OIIO::TypeDesc;

constexpr float greatest_half = 65504;

tl::unexpected<std::string> refusal(const fs::path& file, std::string_view reason) {
    return tl::unexpected(fmt::format("{}: {}", file.string(), reason));
}

// OpenImageIO ends some messages with a line break and tells others in several lines.
std::string one_line(std::string message) {
    while (!message.empty() && message.back() == '\n')
        message.pop_back();
    std::ranges::replace(message, '\n', ' ');
    return message;
}

std::size_t pixel_count(int width, int height) {
    EXPECTS(width > 0 && height > 0);
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

// The name ends as the final one does, because the ending chooses the format; the process number
// keeps two programs that make the same picture apart.
fs::path unfinished(const fs::path& file) {
    return file.parent_path() / fmt::format(".{}.unfinished-{}{}", file.stem().string(), ::getpid(),
                                            file.extension().string());
}

void add_texts(ImageSpec& spec, const std::vector<TextEntry>& texts) {
    for (const auto& entry : texts)
        spec.attribute(entry.name, entry.text);
}

// What went wrong, or nothing.
std::string
write_pixels(const fs::path& file, const ImageSpec& spec, TypeDesc type, const void* pixels) {
    const auto output = ImageOutput::create(file.string());
    if (!output)
        return "cannot be written: " + one_line(OIIO::geterror());
    const bool written =
        output->open(file.string(), spec) && output->write_image(type, pixels) && output->close();
    return written ? "" : "cannot be written: " + one_line(output->geterror());
}

Expected<void>
write_whole(const fs::path& file, const ImageSpec& spec, TypeDesc type, const void* pixels) {
    std::error_code failure;
    if (const auto folder = file.parent_path();
        !folder.empty() && !fs::is_directory(folder, failure))
        return refusal(file, "cannot be written: its folder does not exist");
    const fs::path beside = unfinished(file);
    std::string reason = write_pixels(beside, spec, type, pixels);
    if (reason.empty()) {
        fs::rename(beside, file, failure);
        if (!failure)
            return {};
        reason = "cannot be written: " + failure.message();
    }
    fs::remove(beside, failure);
    return refusal(file, reason);
}

using Reader = std::unique_ptr<ImageInput>;

Expected<Reader> open(const fs::path& file) {
    std::error_code failure;
    if (!fs::exists(file, failure))
        return refusal(file, "there is no such file");
    if (!fs::is_regular_file(file, failure))
        return refusal(file, "is not a file");
    Reader reader = ImageInput::open(file.string());
    if (!reader)
        return refusal(file, "is not a picture that can be read: " + one_line(OIIO::geterror()));
    // A header may claim any size: memory for it is asked for only where that can be true.
    if (const auto& spec = reader->spec(); spec.width > longest_edge || spec.height > longest_edge)
        return refusal(file, fmt::format("is {}x{} pixels, expected at most {} along an edge; "
                                         "make it smaller, or save it anew if it is not",
                                         spec.width, spec.height, longest_edge));
    return reader;
}

template <class Sample>
Expected<std::vector<Sample>>
read_samples(const fs::path& file, ImageInput& reader, TypeDesc type) {
    const auto& spec = reader.spec();
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<Sample> samples(pixel_count(spec.width, spec.height) * channels);
    if (!reader.read_image(0, 0, 0, spec.nchannels, type, samples.data()))
        return refusal(file, "is damaged: " + one_line(reader.geterror()));
    return samples;
}

Expected<void> check_exr(const fs::path& file, const ImageInput& reader) {
    const auto& spec = reader.spec();
    if (std::string_view(reader.format_name()) != "openexr")
        return refusal(file, fmt::format("is {}, expected EXR", reader.format_name()));
    const std::vector<std::string> wanted{"R", "G", "B", "A"};
    const auto& names = spec.channelnames;
    if (names.size() < wanted.size() || !std::equal(wanted.begin(), wanted.end(), names.begin()))
        return refusal(file, fmt::format("has the channels {}, expected R, G, B, A",
                                         fmt::join(spec.channelnames, ", ")));
    return {};
}

Expected<void> check_halves(const fs::path& file, const LinearImage& image) {
    const auto fits = [](float value) { return std::abs(value) <= greatest_half; };
    const auto width = static_cast<std::size_t>(image.width);
    for (std::size_t pixel = 0; pixel < image.pixels.size(); ++pixel) {
        const auto& light = image.pixels[pixel];
        if (!fits(light.r) || !fits(light.g) || !fits(light.b) || !fits(image.coverage[pixel]))
            return refusal(
                file, fmt::format("cannot be written: pixel ({}, {}) is ({}, {}, {}) with coverage "
                                  "{}, expected finite values up to {}",
                                  pixel % width, pixel / width, light.r, light.g, light.b,
                                  image.coverage[pixel], greatest_half));
    }
    return {};
}

Expected<void> check_encoded(const fs::path& file, const ImageSpec& spec) {
    if (spec.format != TypeDesc::UINT8 && spec.format != TypeDesc::UINT16)
        return refusal(file, fmt::format("holds {} samples, expected 8 or 16-bit integers",
                                         spec.format.c_str()));
    const bool colour = spec.nchannels == 3 || (spec.nchannels == 4 && spec.alpha_channel == 3);
    if (!colour)
        return refusal(file,
                       fmt::format("has {} ({}), expected RGB or opaque RGBA",
                                   spec.nchannels == 1 ? "1 channel"
                                                       : fmt::format("{} channels", spec.nchannels),
                                   fmt::join(spec.channelnames, ", ")));
    if (const int turned = spec.get_int_attribute("Orientation", 1); turned != 1)
        return refusal(file, fmt::format("is stored turned or mirrored (orientation {}), expected "
                                         "upright; save it as it should be seen",
                                         turned));
    return {};
}

std::string colour_remark(const ImageSpec& spec) {
    if (spec.find_attribute("ICCProfile") != nullptr) {
        const std::string profile = spec.get_string_attribute("ICCProfile:profile_description");
        return profile.find("sRGB") != std::string::npos
                   ? ""
                   : fmt::format("ICC profile '{}'", profile.empty() ? "without a name" : profile);
    }
    const std::string space = spec.get_string_attribute("oiio:ColorSpace", "sRGB");
    if (OIIO::Strutil::iequals(space, "sRGB"))
        return "";
    const float gamma = spec.get_float_attribute("oiio:Gamma", 0);
    return gamma > 0 ? fmt::format("gamma {:.3g}", gamma) : fmt::format("colour space {}", space);
}

Expected<void> check_opaque(const fs::path& file,
                            const ImageSpec& spec,
                            std::span<const std::uint16_t> samples,
                            int greatest) {
    const auto width = static_cast<std::size_t>(spec.width);
    for (std::size_t pixel = 0; 4 * pixel < samples.size(); ++pixel)
        if (const int alpha = samples[4 * pixel + 3]; alpha != greatest)
            return refusal(file, fmt::format("is not opaque: alpha of pixel ({}, {}) is {} of {}; "
                                             "flatten it over the study's grey",
                                             pixel % width, pixel / width, alpha, greatest));
    return {};
}

std::vector<std::uint16_t> without_alpha(std::span<const std::uint16_t> samples) {
    std::vector<std::uint16_t> codes;
    codes.reserve(samples.size() / 4 * 3);
    for (std::size_t first = 0; first < samples.size(); first += 4)
        codes.insert(codes.end(), {samples[first], samples[first + 1], samples[first + 2]});
    return codes;
}

ImageSpec png_spec(const EncodedImage& image) {
    EXPECTS(image.bits == 8 || image.bits == 16);
    EXPECTS(image.codes.size() == 3 * pixel_count(image.width, image.height));
    ImageSpec spec(image.width, image.height, 3,
                   image.bits == 8 ? TypeDesc::UINT8 : TypeDesc::UINT16);
    spec.attribute("png:compressionLevel", 3); // twice as fast as the default, files 5 % larger
    spec.attribute("oiio:ColorSpace", "sRGB");
    return spec;
}

std::vector<std::uint8_t> bytes_of(const EncodedImage& image) {
    EXPECTS(std::ranges::all_of(image.codes, [](auto code) { return code <= 255; }));
    std::vector<std::uint8_t> bytes(image.codes.size());
    std::ranges::transform(image.codes, bytes.begin(),
                           [](auto code) { return static_cast<std::uint8_t>(code); });
    return bytes;
}

Expected<std::vector<std::uint16_t>> read_codes(const fs::path& file, ImageInput& reader) {
    if (reader.spec().format == TypeDesc::UINT16)
        return read_samples<std::uint16_t>(file, reader, TypeDesc::UINT16);
    return read_samples<std::uint8_t>(file, reader, TypeDesc::UINT8).map([](const auto& bytes) {
        return std::vector<std::uint16_t>(bytes.begin(), bytes.end());
    });
}

} // namespace

Expected<FileSize> size_in_file(const fs::path& file) {
    return open(file).map([](const Reader& reader) {
        return FileSize{reader->spec().width, reader->spec().height};
    });
}

Expected<void>
write_exr(const fs::path& file, const LinearImage& image, const std::vector<TextEntry>& texts) {
    EXPECTS(file.extension() == ".exr");
    EXPECTS(image.pixels.size() == pixel_count(image.width, image.height));
    EXPECTS(image.coverage.size() == image.pixels.size());
    if (auto checked = check_halves(file, image); !checked)
        return checked;
    std::vector<std::array<float, 4>> samples;
    samples.reserve(image.pixels.size());
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        samples.push_back(
            {image.pixels[i].r, image.pixels[i].g, image.pixels[i].b, image.coverage[i]});
    ImageSpec spec(image.width, image.height, 4, TypeDesc::HALF);
    spec.attribute("compression", "piz"); // lossless, and the fastest that makes files smaller
    spec.attribute("oiio:ColorSpace", "Linear");
    add_texts(spec, texts);
    return write_whole(file, spec, TypeDesc::FLOAT, samples.data());
}

Expected<LinearImage> read_exr(const fs::path& file) {
    const auto reader = open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    if (auto checked = check_exr(file, **reader); !checked)
        return tl::unexpected(checked.error());
    const auto samples = read_samples<float>(file, **reader, TypeDesc::FLOAT);
    if (!samples)
        return tl::unexpected(samples.error());
    const auto& spec = (*reader)->spec();
    LinearImage image{spec.width, spec.height, {}, {}};
    image.pixels.reserve(pixel_count(spec.width, spec.height));
    image.coverage.reserve(pixel_count(spec.width, spec.height));
    for (std::size_t i = 0; i < samples->size(); i += static_cast<std::size_t>(spec.nchannels)) {
        image.pixels.push_back({(*samples)[i], (*samples)[i + 1], (*samples)[i + 2]});
        image.coverage.push_back((*samples)[i + 3]);
    }
    return image;
}

Expected<void>
write_layers(const fs::path& file, const LayeredImage& image, const std::vector<TextEntry>& texts) {
    EXPECTS(file.extension() == ".exr");
    const std::size_t pixels = pixel_count(image.width, image.height), n = image.layers.size();
    EXPECTS(n >= 4 && image.layers[0].channel == "R" && image.layers[3].channel == "A");
    ImageSpec spec(image.width, image.height, static_cast<int>(n), TypeDesc::FLOAT);
    std::vector<float> samples(pixels * n);
    spec.channelnames.clear();
    for (std::size_t k = 0; k < n; ++k) {
        const auto& layer = image.layers[k];
        EXPECTS(layer.values.size() == pixels);
        spec.channelnames.push_back(layer.channel);
        for (std::size_t i = 0; i < pixels; ++i)
            samples[i * n + k] = layer.values[i];
    }
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    add_texts(spec, texts);
    return write_whole(file, spec, TypeDesc::FLOAT, samples.data());
}

Expected<LayeredImage> read_layers(const fs::path& file) {
    const auto reader = open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    if (auto checked = check_exr(file, **reader); !checked)
        return tl::unexpected(checked.error());
    const auto samples = read_samples<float>(file, **reader, TypeDesc::FLOAT);
    if (!samples)
        return tl::unexpected(samples.error());
    const auto& spec = (*reader)->spec();
    LayeredImage image{spec.width, spec.height, {}};
    const std::size_t n = spec.channelnames.size();
    for (std::size_t k = 0; k < n; ++k) {
        Layer layer{spec.channelnames[k], {}};
        for (std::size_t i = k; i < samples->size(); i += n)
            layer.values.push_back((*samples)[i]);
        image.layers.push_back(std::move(layer));
    }
    return image;
}

Expected<void>
write_png(const fs::path& file, const EncodedImage& image, const std::vector<TextEntry>& texts) {
    EXPECTS(file.extension() == ".png");
    auto spec = png_spec(image);
    add_texts(spec, texts);
    if (image.bits == 8)
        return write_whole(file, spec, TypeDesc::UINT8, bytes_of(image).data());
    return write_whole(file, spec, TypeDesc::UINT16, image.codes.data());
}

Expected<std::string> png_bytes(const EncodedImage& image) {
    const auto spec = png_spec(image);
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = ImageOutput::create("png");
    if (!output)
        return refusal("a PNG in memory", one_line(OIIO::geterror()));
    const auto write = [&] {
        return image.bits == 8 ? output->write_image(TypeDesc::UINT8, bytes_of(image).data())
                               : output->write_image(TypeDesc::UINT16, image.codes.data());
    };
    if (!output->set_ioproxy(&memory) || !output->open("memory.png", spec) || !write() ||
        !output->close())
        return refusal("a PNG in memory", one_line(output->geterror()));
    return std::string(bytes.begin(), bytes.end());
}

Expected<FileImage> read_encoded(const fs::path& file) {
    const auto reader = open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    const auto& spec = (*reader)->spec();
    if (auto checked = check_encoded(file, spec); !checked)
        return tl::unexpected(checked.error());
    auto samples = read_codes(file, **reader);
    if (!samples)
        return tl::unexpected(samples.error());
    const int bits = spec.format == TypeDesc::UINT16 ? 16 : 8;
    if (spec.nchannels == 4) {
        if (auto checked = check_opaque(file, spec, *samples, (1 << bits) - 1); !checked)
            return tl::unexpected(checked.error());
        samples = without_alpha(*samples);
    }
    return FileImage{{spec.width, spec.height, bits, std::move(*samples)}, colour_remark(spec)};
}

Expected<std::vector<TextEntry>> read_texts(const fs::path& file) {
    const auto reader = open(file);
    if (!reader)
        return tl::unexpected(reader.error());
    std::vector<TextEntry> texts;
    for (const auto& attribute : (*reader)->spec().extra_attribs)
        if (attribute.type() == TypeDesc::STRING)
            texts.push_back({attribute.name().string(), attribute.get_string()});
    return texts;
}

} // namespace renderer::imaging
