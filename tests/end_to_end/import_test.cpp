// Pictures made elsewhere, of several kinds, become a study's stimuli.
#include "renderer/imaging/image_files.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

namespace {

using namespace tests;
using testing::HasSubstr;
namespace imaging = renderer::imaging;

class Import : public testing::Test {
  protected:
    void SetUp() override {
        write_small_study(study.path());
        std::filesystem::rename(study / "stimuli", study / "originals");
    }

    Outcome take(std::vector<std::string> more = {}) {
        std::vector<std::string> command{"import", study.path().string(), "--from",
                                         (study / "originals").string()};
        command.insert(command.end(), more.begin(), more.end());
        return pairlight(command);
    }

    std::filesystem::path stimulus(const std::string& name) const {
        return study.path() / "stimuli" / name;
    }

    TemporaryFolder study;
};

TEST_F(Import, KeepsEveryCodeOfAPng) {
    const auto outcome = take();
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto read = imaging::read_encoded(stimulus("garden/first.png"));
    ASSERT_TRUE(read) << read.error();
    EXPECT_EQ(read->image.codes, small_picture("garden", "first").codes);
    EXPECT_EQ(pairlight({"check", study.path().string()}).status, 0);
}

// A picture of another size is refused by its beginning; the rest, not there here, is not looked
// at.
TEST_F(Import, AnotherSizeIsSeenBeforeThePixelsAre) {
    imaging::EncodedImage wide{3000, 1000, 8, {}};
    wide.codes.assign(3 * 3000 * 1000, 77);
    const auto file = study / "originals/harbour/first.png";
    ASSERT_TRUE(imaging::write_png(file, wide));
    write_file(file, read_file(file).substr(0, 200));
    EXPECT_THAT(take().err, HasSubstr("is 3000x1000 pixels, the study says 200x150"));
    std::filesystem::copy(study / "originals", study / "stimuli",
                          std::filesystem::copy_options::recursive);
    EXPECT_THAT(pairlight({"check", study.path().string()}).err,
                HasSubstr("is 3000x1000 pixels, the study says 200x150"));
}

// Equal within a scene, for that is what is seen side by side; scenes may differ.
TEST_F(Import, TakesEachScenesPicturesInTheirOwnSize) {
    for (const auto* condition : {"first", "second", "third"}) {
        imaging::EncodedImage wide{300, 100, 8, {}};
        wide.codes.assign(3 * 300 * 100, 77);
        ASSERT_TRUE(imaging::write_png(
            study / ("originals/harbour/" + std::string(condition) + ".png"), wide));
    }
    EXPECT_THAT(take().err, HasSubstr("is 300x100 pixels, the study says 200x150"));
    auto text = read_file(study / "study.toml");
    const std::string scene = "id = \"harbour\"\n";
    text.insert(text.find(scene) + scene.size(), "width = 300\nheight = 100\n");
    write_file(study / "study.toml", text);
    const auto outcome = take();
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(pairlight({"check", study.path().string()}).status, 0);
    const VirtualScreen screen(800, 600);
    const auto sat = pairlight(
        {"simulate", study.path().string(), "--observers", "1", "--quiet", "--window", "640x400"});
    EXPECT_EQ(sat.status, 0) << sat.err;
    EXPECT_THAT(pairlight({"simulate", study.path().string(), "--observers", "2", "--quiet",
                           "--window", "600x400"})
                    .err,
                HasSubstr("pictures of 300 x 100 pixels"));
}

TEST_F(Import, TakesJpegAndTiffAsTheyAreDecoded) {
    for (const auto* kind : {"jpg", "tif"}) {
        const auto file = study / ("originals/garden/first." + std::string(kind));
        run({"convert", (study / "originals/garden/second.png").string(), file.string()});
        std::filesystem::remove(study / "originals/garden/first.png");
        const auto outcome = take();
        ASSERT_EQ(outcome.status, 0) << kind << outcome.err;
        EXPECT_EQ(imaging::read_encoded(stimulus("garden/first.png"))->image.codes,
                  imaging::read_encoded(file)->image.codes);
        std::filesystem::remove(file);
    }
}

TEST_F(Import, ShowsLightByTheCurveThatIsNamed) {
    imaging::LinearImage light{picture_width, picture_height, {}, {}};
    light.pixels.assign(picture_width * picture_height, {0.25F, 0.5F, 1.5F});
    light.coverage.assign(light.pixels.size(), 1.0F);
    ASSERT_TRUE(imaging::write_exr(study / "originals/garden/first.exr", light));
    std::filesystem::remove(study / "originals/garden/first.png");
    EXPECT_THAT(take().err, HasSubstr("expected --curve clip"));
    EXPECT_FALSE(std::filesystem::exists(stimulus("garden/second.png"))) << "half an import";
    const auto outcome = take({"--curve", "clip", "--exposure", "1"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    const auto pixel =
        imaging::light_at(imaging::read_encoded(stimulus("garden/first.png"))->image, 0);
    // Twice the light, cut at 1; a 16-bit code is never off by more than 1e-5 of white's light.
    EXPECT_NEAR(pixel.r, 0.5F, 2e-5F);
    EXPECT_NEAR(pixel.g, 1.0F, 2e-5F);
    EXPECT_NEAR(pixel.b, 1.0F, 2e-5F);
    EXPECT_THAT(read_file(study / "stimuli/imported.tsv"),
                HasSubstr("clip, exposure +1 stops, 100.0000 % of pixels cut"));
}

TEST_F(Import, KeepsTheHueUnderReinhardsCurve) {
    imaging::LinearImage light{picture_width, picture_height, {}, {}};
    light.pixels.assign(picture_width * picture_height, {1.0F, 1.0F, 1.0F});
    light.coverage.assign(light.pixels.size(), 1.0F);
    ASSERT_TRUE(imaging::write_exr(study / "originals/garden/first.exr", light));
    std::filesystem::remove(study / "originals/garden/first.png");
    ASSERT_EQ(take({"--curve", "reinhard"}).status, 0);
    const auto pixel =
        imaging::light_at(imaging::read_encoded(stimulus("garden/first.png"))->image, 0);
    for (const auto channel : {pixel.r, pixel.g, pixel.b})
        EXPECT_NEAR(channel, 0.5F, 2e-5F); // 1 / (1 + 1)
}

TEST_F(Import, RefusesAnotherColourProfileUnlessTold) {
    const auto file = study / "originals/garden/first.png";
    run({"convert", file.string(), "-set", "gamma", "0.5555", "-define", "png:include-chunk=gAMA",
         file.string()});
    ASSERT_NE(imaging::read_encoded(file)->colour_remark, "");
    const auto refused = take();
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("expected sRGB"));
    EXPECT_EQ(take({"--colour", "as-is"}).status, 0);
    EXPECT_THAT(read_file(study / "stimuli/imported.tsv"), HasSubstr("in spite of"));
}

TEST_F(Import, WantsOneFileForEachPicture) {
    std::filesystem::copy_file(study / "originals/garden/first.png",
                               study / "originals/garden/first.tif");
    EXPECT_THAT(take().err, HasSubstr("both could be the picture"));
    std::filesystem::remove(study / "originals/garden/first.tif");
    std::filesystem::remove(study / "originals/garden/first.png");
    EXPECT_THAT(take().err, HasSubstr("is missing"));
}

} // namespace
