// What is found once for a model, before a picture can be drawn: interrupted, and on models that
// are not closed.
#include "renderer/geometry/bodies.h"
#include "tests/end_to_end/program.h"

#include <fmt/format.h>

#include <filesystem>

namespace {

namespace fs = std::filesystem;
namespace geometry = renderer::geometry;
using namespace tests;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::string off_text(const geometry::Mesh& mesh) {
    auto text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
    for (const auto& p : mesh.positions)
        text += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : mesh.triangles)
        text += fmt::format("3 {} {} {}\n", a, b, c);
    return text;
}

std::string study_of(const std::string& scene_keys, const std::string& conditions) {
    return R"([study]
id       = "precompute"
title    = "One model"
question = "Which?"
seed     = 1
width    = 64
height   = 64
[[scene]]
id          = "body"
model       = "./body.off"
material    = "marble"
diameter_mm = 30
)" + scene_keys +
           conditions;
}

constexpr const char* shss = R"([[condition]]
id         = "shss"
method     = "shss"
directions = 512
[[condition]]
id     = "phong"
method = "phong"
)";

class Precompute : public testing::Test {
  protected:
    static void study_in(const TemporaryFolder& folder,
                         const geometry::Mesh& mesh,
                         const std::string& scene_keys = "",
                         const std::string& conditions = shss) {
        write_file(folder / "body.off", off_text(mesh));
        write_file(folder / "study.toml", study_of(scene_keys, conditions));
        write_file(folder / "instructions.md", "Choose.\n");
    }

    TemporaryFolder folder_;
};

// Tracing takes a second or two here.  Wherever the interruption falls, the next run gets the same
// pictures as one that was left alone, and finds nothing damaged.
TEST_F(Precompute, InterruptedOnItsWayLeavesNoBrokenCache) {
    const auto body = geometry::torus(1, 0.4, 160, 80);
    study_in(folder_, body);
    for (const std::string seconds : {"0.2", "0.5", "0.9"}) {
        const auto outcome = run({"timeout", "-s", "INT", seconds, PAIRLIGHT_PROGRAM, "render",
                                  folder_.path().string()});
        EXPECT_NE(outcome.status, 1) << outcome.err; // done, or ended by the signal
    }
    const auto again = pairlight({"render", folder_.path().string()});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_THAT(again.err, Not(HasSubstr("damaged")));

    const TemporaryFolder untouched;
    study_in(untouched, body);
    ASSERT_EQ(pairlight({"render", untouched.path().string()}).status, 0);
    EXPECT_EQ(read_file(folder_ / "stimuli/body/front/shss.png"),
              read_file(untouched / "stimuli/body/front/shss.png"));
}

geometry::Mesh pierced_sphere() {
    auto mesh = geometry::sphere(1, 3);
    mesh.triangles.resize(mesh.triangles.size() - 6);
    return mesh;
}

TEST_F(Precompute, AModelWithHolesIsRenderedWhereItsSceneAllowsIt) {
    study_in(folder_, pierced_sphere());
    const auto refused = pairlight({"render", folder_.path().string()});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("study.toml:"), HasSubstr("boundary edge"),
                                   HasSubstr("holes = \"winding\"")));

    study_in(folder_, pierced_sphere(), "holes = \"winding\"\n");
    const auto rendered = pairlight({"render", folder_.path().string()});
    ASSERT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_THAT(rendered.err, AllOf(HasSubstr("the surface has holes"),
                                    HasSubstr("rays passed so near an opening")));
}

TEST_F(Precompute, TheReferenceWantsAClosedSurface) {
    study_in(folder_, pierced_sphere(), "holes = \"winding\"\n", R"([[condition]]
id     = "truth"
method = "reference"
[[condition]]
id     = "phong"
method = "phong"
)");
    const auto refused = pairlight({"render", folder_.path().string()});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err, HasSubstr("closed surfaces only, and body.off has holes"));
}

TEST_F(Precompute, AWordForHolesThatNobodyKnowsIsRefused) {
    study_in(folder_, pierced_sphere(), "holes = \"fill\"\n");
    const auto refused = pairlight({"render", folder_.path().string()});
    EXPECT_EQ(refused.status, 1);
    EXPECT_THAT(refused.err,
                AllOf(HasSubstr("study.toml:"), HasSubstr("holes"), HasSubstr("winding")));
}

} // namespace
