#include "renderer/imaging/image_files.h"

#include <OpenImageIO/imageio.h>

#include <cmath>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;
using namespace renderer;
using namespace renderer::imaging;
using testing::HasSubstr;

// A folder of its own for every test, gone afterwards.
class ImageFiles : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fs::path(testing::TempDir()) / (std::string("pairlight-") + test->name());
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }

    void TearDown() override { fs::remove_all(folder_); }

    fs::path file(const std::string& name) const { return folder_ / name; }

    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_))
            found.push_back(entry.path().filename().string());
        return found;
    }

  private:
    fs::path folder_;
};

std::string bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << stream.rdbuf();
    return bytes.str();
}

void write_text(const fs::path& file, const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
}

template <class Sample>
void write_raw(const fs::path& file,
               OIIO::ImageSpec spec,
               OIIO::TypeDesc type,
               const std::vector<Sample>& samples) {
    const auto output = OIIO::ImageOutput::create(file.string());
    ASSERT_TRUE(output) << OIIO::geterror();
    ASSERT_TRUE(output->open(file.string(), spec)) << output->geterror();
    ASSERT_TRUE(output->write_image(type, samples.data())) << output->geterror();
    ASSERT_TRUE(output->close()) << output->geterror();
}

// Halves hold these values exactly; all four channels and all pixels differ.
LinearImage exact_light() {
    LinearImage image{3, 2, {}, {}};
    for (int pixel = 0; pixel < 6; ++pixel) {
        const auto light = static_cast<float>(pixel);
        image.pixels.push_back({light / 8, light / 16 + 1, light * 100});
        image.coverage.push_back(light / 8);
    }
    return image;
}

EncodedImage ramp(int bits) {
    EncodedImage image{7, 3, bits, {}};
    const unsigned greatest = bits == 8 ? 255 : 65535;
    for (unsigned i = 0; i < 63; ++i)
        image.codes.push_back(static_cast<std::uint16_t>(i * greatest / 62));
    return image;
}

TEST_F(ImageFiles, ExrKeepsLightCoverageAndOrder) {
    ASSERT_TRUE(write_exr(file("a.exr"), exact_light()));
    const auto back = read_exr(file("a.exr"));
    ASSERT_TRUE(back.has_value()) << back.error();
    EXPECT_EQ(back->width, 3);
    EXPECT_EQ(back->height, 2);
    EXPECT_EQ(back->pixels, exact_light().pixels);
    EXPECT_EQ(back->coverage, exact_light().coverage);
}

TEST_F(ImageFiles, ExrRoundsToHalves) {
    LinearImage image{1, 1, {{0.1F, 1000.3F, 3e-5F}}, {1}};
    ASSERT_TRUE(write_exr(file("a.exr"), image));
    const auto back = read_exr(file("a.exr"));
    ASSERT_TRUE(back.has_value()) << back.error();
    EXPECT_NEAR(back->pixels[0].r, 0.1, 0.1 / 2048); // 11 bits of precision, half a step
    EXPECT_NEAR(back->pixels[0].g, 1000.3, 1000.3 / 2048);
    EXPECT_NEAR(back->pixels[0].b, 3e-5, 3e-8); // below the normal halves: a step of 6e-8
}

TEST_F(ImageFiles, PngKeepsEveryCode) {
    for (const int bits : {8, 16}) {
        ASSERT_TRUE(write_png(file("a.png"), ramp(bits)));
        const auto back = read_encoded(file("a.png"));
        ASSERT_TRUE(back.has_value()) << back.error();
        EXPECT_EQ(back->image.bits, bits);
        EXPECT_EQ(back->image.width, 7);
        EXPECT_EQ(back->image.height, 3);
        EXPECT_EQ(back->image.codes, ramp(bits).codes);
        EXPECT_EQ(back->colour_remark, "");
    }
}

TEST_F(ImageFiles, PngInMemoryIsPngOnDisk) {
    ASSERT_TRUE(write_png(file("a.png"), ramp(8)));
    const auto bytes = png_bytes(ramp(8));
    ASSERT_TRUE(bytes.has_value()) << bytes.error();
    EXPECT_EQ(*bytes, bytes_of(file("a.png")));
}

TEST_F(ImageFiles, KeepWhatTheyAreToldAboutThemselves) {
    const std::vector<TextEntry> texts{{"stimulus:id", "bunny/back/shss-5"},
                                       {"Software", "pairlight 0.1.0"}};
    ASSERT_TRUE(write_exr(file("a.exr"), exact_light(), texts));
    ASSERT_TRUE(write_png(file("a.png"), ramp(16), texts));
    for (const auto* name : {"a.exr", "a.png"}) {
        const auto kept = read_texts(file(name));
        ASSERT_TRUE(kept.has_value()) << kept.error();
        for (const auto& text : texts)
            EXPECT_THAT(*kept, testing::Contains(text)) << name;
    }
}

// A manifest holds hashes of files: the same picture is the same bytes.
TEST_F(ImageFiles, AreTheSameBytesWhenWrittenAgain) {
    ASSERT_TRUE(write_exr(file("a.exr"), exact_light()));
    ASSERT_TRUE(write_exr(file("b.exr"), exact_light()));
    EXPECT_EQ(bytes_of(file("a.exr")), bytes_of(file("b.exr")));
    ASSERT_TRUE(write_png(file("a.png"), ramp(16)));
    ASSERT_TRUE(write_png(file("b.png"), ramp(16)));
    EXPECT_EQ(bytes_of(file("a.png")), bytes_of(file("b.png")));
}

TEST_F(ImageFiles, ReplaceOneAnotherAndLeaveNothingBeside) {
    write_text(file("a.png"), "old");
    ASSERT_TRUE(write_png(file("a.png"), ramp(8)));
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
    EXPECT_TRUE(read_encoded(file("a.png")).has_value());
}

TEST_F(ImageFiles, ThatCannotBeReplacedLeaveNothingBeside) {
    fs::create_directories(file("a.png") / "in the way");
    const auto written = write_png(file("a.png"), ramp(8));
    ASSERT_FALSE(written.has_value());
    EXPECT_THAT(written.error(), HasSubstr("a.png: cannot be written"));
    EXPECT_EQ(names(), std::vector<std::string>{"a.png"});
}

TEST_F(ImageFiles, RefuseAFolderThatIsNotThere) {
    const auto written = write_exr(file("nowhere/a.exr"), exact_light());
    ASSERT_FALSE(written.has_value());
    EXPECT_THAT(written.error(),
                HasSubstr("nowhere/a.exr: cannot be written: its folder does not"));
}

// Nobody may make files in /proc, not even the superuser, whom a read-only folder does not stop.
TEST_F(ImageFiles, RefuseAFolderThatTakesNoFiles) {
    for (const auto& written :
         {write_png("/proc/a.png", ramp(8)), write_exr("/proc/a.exr", exact_light())}) {
        ASSERT_FALSE(written.has_value());
        EXPECT_THAT(written.error(), testing::StartsWith("/proc/a."));
        EXPECT_THAT(written.error(), HasSubstr(": cannot be written: Could not open"));
        EXPECT_EQ(written.error().find('\n'), std::string::npos);
    }
}

TEST_F(ImageFiles, RefuseLightThatHalvesCannotHold) {
    for (const float bad : {std::nanf(""), 70000.0F}) {
        auto image = exact_light();
        image.pixels[4].g = bad;
        const auto written = write_exr(file("a.exr"), image);
        ASSERT_FALSE(written.has_value());
        EXPECT_THAT(written.error(), HasSubstr("pixel (1, 1)"));
        EXPECT_TRUE(names().empty());
    }
}

TEST_F(ImageFiles, NameTheFileThatIsMissing) {
    const auto image = read_encoded(file("missing.png"));
    ASSERT_FALSE(image.has_value());
    EXPECT_THAT(image.error(), HasSubstr("missing.png: there is no such file"));
    EXPECT_FALSE(read_exr(file("missing.exr")).has_value());
    EXPECT_FALSE(read_encoded(file(".")).has_value());
}

TEST_F(ImageFiles, NameTheFileThatIsNoPicture) {
    for (const std::string text : {"", "Dear diary", "\x89PNG\r\n\x1a\n and then nothing"}) {
        write_text(file("a.png"), text);
        const auto image = read_encoded(file("a.png"));
        ASSERT_FALSE(image.has_value()) << text;
        EXPECT_THAT(image.error(), HasSubstr("a.png: is not a picture that can be read"));
        EXPECT_EQ(image.error().find('\n'), std::string::npos) << image.error();
    }
}

TEST_F(ImageFiles, AreNeverReadInPart) {
    ASSERT_TRUE(write_png(file("whole.png"), ramp(16)));
    const auto whole = bytes_of(file("whole.png"));
    // The last 12 bytes are the end marker, without which the picture is complete.
    for (std::size_t kept = 0; kept + 24 < whole.size(); ++kept) {
        write_text(file("cut.png"), whole.substr(0, kept));
        ASSERT_FALSE(read_encoded(file("cut.png")).has_value()) << kept << " bytes";
    }
}

// A PNG whose header says another size than its pixels have, its checksum mended.
std::string claiming(std::string png, std::uint32_t width, std::uint32_t height) {
    const auto put = [&](std::size_t at, std::uint32_t number) {
        for (std::size_t byte = 0; byte < 4; ++byte)
            png[at + byte] = static_cast<char>(number >> (24 - 8 * byte) & 0xFFU);
    };
    put(16, width);
    put(20, height);
    std::uint32_t rest = 0xFFFFFFFFU; // of the division of "IHDR" and its 13 bytes
    for (std::size_t at = 12; at < 29; ++at) {
        rest ^= static_cast<unsigned char>(png[at]);
        for (int bit = 0; bit < 8; ++bit)
            rest = (rest >> 1U) ^ ((rest & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    put(29, ~rest);
    return png;
}

TEST_F(ImageFiles, ThatClaimToBeHugeAreRefusedByTheirHeader) {
    const auto png = png_bytes(ramp(8)).value();
    write_text(file("huge.png"), claiming(png, 60000, 60000));
    const auto refusal = file("huge.png").string() +
                         ": is 60000x60000 pixels, expected at most 16384 along an edge; make it "
                         "smaller, or save it anew if it is not";
    EXPECT_EQ(read_encoded(file("huge.png")).error(), refusal);
    EXPECT_EQ(size_in_file(file("huge.png")).error(), refusal);
    EXPECT_EQ(read_texts(file("huge.png")).error(), refusal);
    write_text(file("long.png"), claiming(png, 7, 16385));
    EXPECT_THAT(read_encoded(file("long.png")).error(), HasSubstr("is 7x16385 pixels"));
}

TEST_F(ImageFiles, SayTheirSizeBeforeAnyPixelIsRead) {
    write_text(file("claims.png"), claiming(png_bytes(ramp(8)).value(), 5000, 4000));
    const auto size = size_in_file(file("claims.png"));
    ASSERT_TRUE(size) << size.error();
    EXPECT_EQ(size->width, 5000);
    EXPECT_EQ(size->height, 4000);
    EXPECT_THAT(read_encoded(file("claims.png")).error(), HasSubstr("is damaged"));
}

TEST_F(ImageFiles, RefuseTransparencyAndNameThePixel) {
    std::vector<std::uint8_t> samples(4 * 6, 255);
    const OIIO::ImageSpec spec(3, 2, 4, OIIO::TypeDesc::UINT8);
    write_raw(file("a.png"), spec, OIIO::TypeDesc::UINT8, samples);
    const auto opaque = read_encoded(file("a.png"));
    ASSERT_TRUE(opaque.has_value()) << opaque.error();
    EXPECT_EQ(opaque->image.codes, std::vector<std::uint16_t>(18, 255));

    samples[4 * 4 + 3] = 254;
    write_raw(file("a.png"), spec, OIIO::TypeDesc::UINT8, samples);
    const auto glass = read_encoded(file("a.png"));
    ASSERT_FALSE(glass.has_value());
    EXPECT_THAT(glass.error(), HasSubstr("is not opaque: alpha of pixel (1, 1) is 254 of 255"));
}

TEST_F(ImageFiles, RefuseOtherChannels) {
    write_raw(file("grey.png"), OIIO::ImageSpec(2, 2, 1, OIIO::TypeDesc::UINT8),
              OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>(4, 7));
    const auto grey = read_encoded(file("grey.png"));
    ASSERT_FALSE(grey.has_value());
    EXPECT_THAT(grey.error(), HasSubstr("has 1 channel (Y), expected RGB or opaque RGBA"));

    write_raw(file("rgb.exr"), OIIO::ImageSpec(2, 2, 3, OIIO::TypeDesc::HALF),
              OIIO::TypeDesc::FLOAT, std::vector<float>(12, 0.5F));
    const auto rgb = read_exr(file("rgb.exr"));
    ASSERT_FALSE(rgb.has_value());
    EXPECT_THAT(rgb.error(), HasSubstr("has the channels R, G, B, expected R, G, B, A"));
    const auto linear = read_encoded(file("rgb.exr"));
    ASSERT_FALSE(linear.has_value());
    EXPECT_THAT(linear.error(), HasSubstr("holds half samples, expected 8 or 16-bit integers"));
}

TEST_F(ImageFiles, ReadJpegAndTiff) {
    const OIIO::ImageSpec narrow(16, 16, 3, OIIO::TypeDesc::UINT8);
    write_raw(file("a.jpg"), narrow, OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>(768, 128));
    const auto jpeg = read_encoded(file("a.jpg"));
    ASSERT_TRUE(jpeg.has_value()) << jpeg.error();
    EXPECT_EQ(jpeg->image.bits, 8);
    EXPECT_EQ(jpeg->image.codes,
              std::vector<std::uint16_t>(768, 128)); // a flat grey is kept exactly

    const OIIO::ImageSpec wide(16, 16, 3, OIIO::TypeDesc::UINT16);
    write_raw(file("a.tif"), wide, OIIO::TypeDesc::UINT16, std::vector<std::uint16_t>(768, 40000));
    const auto tiff = read_encoded(file("a.tif"));
    ASSERT_TRUE(tiff.has_value()) << tiff.error();
    EXPECT_EQ(tiff->image.bits, 16);
    EXPECT_EQ(tiff->image.codes, std::vector<std::uint16_t>(768, 40000));
}

TEST_F(ImageFiles, RefusePicturesStoredTurned) {
    OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("Orientation", 6);
    write_raw(file("a.jpg"), spec, OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>(768, 128));
    const auto image = read_encoded(file("a.jpg"));
    ASSERT_FALSE(image.has_value());
    EXPECT_THAT(image.error(), HasSubstr("is stored turned or mirrored (orientation 6)"));
}

TEST_F(ImageFiles, RemarkOnColoursThatAreNotSrgb) {
    OIIO::ImageSpec spec(2, 2, 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "Gamma1.8");
    spec.attribute("oiio:Gamma", 1.8F);
    write_raw(file("a.png"), spec, OIIO::TypeDesc::UINT8, std::vector<std::uint8_t>(12, 99));
    const auto image = read_encoded(file("a.png"));
    ASSERT_TRUE(image.has_value()) << image.error();
    EXPECT_EQ(image->colour_remark, "gamma 1.8");
    EXPECT_EQ(image->image.codes, std::vector<std::uint16_t>(12, 99)); // told, not converted
}

TEST_F(ImageFiles, KeepLayersToTheLastBitBesideThePicture) {
    LayeredImage image{2, 1, {}};
    for (const char* name : {"R", "G", "B", "A", "variance.R", "odd.low.G"})
        image.layers.push_back({name, {1.0f + 0.1f * static_cast<float>(name[0]), 1e-30f}});
    ASSERT_TRUE(write_layers(file("a.exr"), image, {{"reference:seed", "7"}}));
    const auto back = read_layers(file("a.exr"));
    ASSERT_TRUE(back) << back.error();
    for (const auto& layer : image.layers) {
        const auto* found = find_layer(*back, layer.channel);
        ASSERT_NE(found, nullptr) << layer.channel;
        EXPECT_EQ(found->values, layer.values);
    }
    const auto picture = read_exr(file("a.exr"));
    ASSERT_TRUE(picture) << picture.error();
    EXPECT_EQ(picture->pixels[0].g, image.layers[1].values[0]);
    EXPECT_EQ(picture->coverage[1], 1e-30f);
}

} // namespace
