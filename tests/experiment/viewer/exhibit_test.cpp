#include "experiment/text_files.h"
#include "experiment/viewer/exhibit.h"
#include "renderer/methods/catalogue.h"
#include "tests/experiment/store/temporary_folder.h"

namespace {

using namespace experiment::viewer;
using testing::HasSubstr;

constexpr const char* study_text = R"([study]
id       = "two"
title    = "Two bodies"
question = "Which picture looks more realistic?"
seed     = 7
width    = 200
height   = 150

[display]
surround = "code:99"

[[scene]]
id           = "ball"
model        = "sphere"
material     = "skin1"
diameter_mm  = 40

[[scene]]
id           = "ring"
model        = "torus"
material     = "marble"

[[variant]]
id       = "back"
to_light = [0, 0, -1]

[[condition]]
id     = "few"
label  = "few bands"
method = "shss"
bands  = 2

[[condition]]
id     = "plain"
label  = "plain"
method = "phong"

[[condition]]
id     = "photo"
source = "images"
)";

TEST(Exhibit, OfABodyHasEveryMethodAndSomeLights) {
    const auto exhibit = open_exhibit("sphere", {.diameter_mm = 30, .material = "skin2"});
    ASSERT_TRUE(exhibit) << exhibit.error();
    EXPECT_EQ(exhibit->pieces.size(), 1U);
    EXPECT_EQ(exhibit->pieces[0].scene.diameter_mm, 30);
    EXPECT_EQ(exhibit->choices.size(), renderer::methods::catalogue().size());
    EXPECT_GE(exhibit->variants.size(), 3U);
    for (const auto& variant : exhibit->variants) {
        const auto& [x, y, z] = variant.lights.at(0).to_light;
        EXPECT_NEAR(x * x + y * y + z * z, 1, 1e-12);
    }
}

TEST(Exhibit, OfAStudyHasItsScenesVariantsAndConditionsFirst) {
    const tests::TemporaryFolder folder;
    ASSERT_TRUE(experiment::write_text_file(folder.path() / "study.toml", study_text));
    for (const auto& name : {folder.path(), folder.path() / "study.toml"}) {
        const auto exhibit = open_exhibit(name.string(), {});
        ASSERT_TRUE(exhibit) << exhibit.error();
        EXPECT_EQ(exhibit->name, "Two bodies");
        EXPECT_EQ(exhibit->surround, 99);
        ASSERT_EQ(exhibit->pieces.size(), 2U);
        EXPECT_EQ(exhibit->pieces[0].scene.id.value, "ball");
        EXPECT_EQ(exhibit->variants.at(0).id.value, "back");
        ASSERT_EQ(exhibit->choices.size(), 2 + renderer::methods::catalogue().size());
        EXPECT_EQ(exhibit->choices[0].label, "few bands");
        EXPECT_EQ(exhibit->choices[0].dials.at("bands"),
                  renderer::methods::DialValue(std::int64_t{2}));
        EXPECT_THAT(exhibit->remarks, testing::ElementsAre(HasSubstr("photo")));
    }
}

TEST(Exhibit, SaysWhatIsMissing) {
    EXPECT_THAT(open_exhibit("no-such-model", {}).error(), HasSubstr("no-such-model"));
    EXPECT_THAT(open_exhibit("no-such-folder/study.toml", {}).error(), HasSubstr("pairlight init"));
    EXPECT_THAT(open_exhibit("sphere", {.material = "cheese"}).error(),
                testing::AllOf(HasSubstr("\"cheese\""), HasSubstr("marble")));
}

} // namespace
