#include "experiment/stimuli/manifest.h"

namespace {

using namespace experiment::stimuli;

Manifest two_pictures() {
    Manifest manifest{"pairlight 0.1.0", "ab", {}};
    auto& rendered = manifest.pictures[{{"bunny"}, {"back"}, {"shss-25"}}];
    rendered = {.recipe = "r",
                .renderer = "llvmpipe",
                .dials = {{"bands", "5"}},
                .png_sha256 = "cd",
                .width = 8,
                .height = 9};
    rendered.model = {"bunny.obj", "ef", 34835, 69666};
    rendered.brightness = {0.1, 0.2, 2.0, 0.001};
    rendered.frame_milliseconds = 12.5;
    rendered.decision = "3 of 5 bands";
    rendered.predicted_change = 0.003;
    rendered.measured_change = 0.0025;
    manifest.pictures[{{"bunny"}, {""}, {"mine"}}] = {.recipe = "s",
                                                      .renderer = "own image",
                                                      .dials = {},
                                                      .png_sha256 = "x",
                                                      .width = 1,
                                                      .height = 1};
    return manifest;
}

TEST(Manifest, IsReadBackAsItWasWritten) {
    const auto manifest = two_pictures();
    const auto again = parse_manifest(manifest_json(manifest), "manifest.json");
    ASSERT_TRUE(again) << again.error();
    EXPECT_EQ(again->program, manifest.program);
    EXPECT_EQ(again->study_sha256, manifest.study_sha256);
    EXPECT_EQ(again->pictures, manifest.pictures);
}

TEST(Manifest, SaysWhichFileIsNotOne) {
    EXPECT_EQ(parse_manifest("{", "m.json").error(),
              "m.json:1: the JSON ends before it is complete; expected the manifest as it was "
              "written; take the file away and run `pairlight render` again");
    EXPECT_THAT(parse_manifest("{\"form\": 1}", "m.json").error(),
                testing::StartsWith("m.json:1: there is no program; "));
    EXPECT_THAT(parse_manifest("{\"form\": 7}", "m.json").error(),
                testing::HasSubstr("form is 7, expected 1"));
}

TEST(Manifest, HasEveryPictureOnceAndOfASizeThatCanBe) {
    const auto text = manifest_json(two_pictures());
    const auto complaint = [&](const std::string& there, const std::string& instead) {
        auto damaged = text;
        const auto place = damaged.find(there);
        EXPECT_NE(place, std::string::npos) << there;
        damaged.replace(place, there.size(), instead);
        const auto manifest = parse_manifest(damaged, "m.json");
        return manifest ? "" : manifest.error();
    };
    EXPECT_THAT(complaint("\"width\": 8", "\"width\": -8"),
                testing::HasSubstr("width is -8, expected a whole number from 0"));
    EXPECT_THAT(complaint("\"width\": 8", "\"width\": 8, \"width\": 9"),
                testing::HasSubstr("'width' stands twice"));
    const auto once = text.substr(text.find("[\n") + 2, text.rfind("\n  ]") - text.find("[\n") - 2);
    EXPECT_THAT(complaint(once, once + ",\n" + once), testing::HasSubstr("is there twice"));
}

} // namespace
