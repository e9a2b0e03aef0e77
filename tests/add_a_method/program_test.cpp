// The program with the method of docs/add-a-method.md in it, from outside.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;

constexpr const char* study = R"([study]
id       = "wrapped"
title    = "How far around?"
question = "Which picture looks more realistic?"
seed     = 1
width    = 64
height   = 64
[[scene]]
id       = "torus"
model    = "torus"
material = "marble"
[[condition]]
id     = "half"
label  = "Wrapped by a half"
method = "wrap"
[[condition]]
id     = "all"
method = "wrap"
wrap   = 1.0
)";

class WrapInAStudy : public testing::Test {
  protected:
    void SetUp() override {
        auto name = (fs::temp_directory_path() / "pairlight-wrap-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder_ = name;
    }

    void TearDown() override { fs::remove_all(folder_); }

    int run(const std::string& arguments) {
        const auto command = "'" PAIRLIGHT_WITH_WRAP "' " + arguments + " > '" +
                             (folder_ / "said").string() + "' 2>&1";
        return std::system(command.c_str());
    }

    std::string read(const fs::path& file) {
        std::ifstream stream(file);
        std::stringstream text;
        text << stream.rdbuf();
        return text.str();
    }

    void write_study(const std::string& text) { std::ofstream(folder_ / "study.toml") << text; }

    fs::path folder_;
};

TEST_F(WrapInAStudy, IsRenderedLikeAnyOther) {
    write_study(study);
    ASSERT_EQ(run("render '" + folder_.string() + "'"), 0) << read(folder_ / "said");
    EXPECT_TRUE(fs::exists(folder_ / "stimuli/torus/half.png"));
    EXPECT_TRUE(fs::exists(folder_ / "stimuli/torus/all.exr"));
    const auto manifest = read(folder_ / "stimuli/manifest.json");
    EXPECT_THAT(manifest, testing::HasSubstr("\"wrap\": \"0.5\""));
    EXPECT_THAT(manifest, testing::HasSubstr("\"method\": \"wrap\""));
}

TEST_F(WrapInAStudy, HasItsDialChecked) {
    write_study(std::string(study) + "depth = 3\n");
    EXPECT_NE(run("render '" + folder_.string() + "'"), 0);
    EXPECT_THAT(
        read(folder_ / "said"),
        testing::HasSubstr("depth in [[condition]] is no dial of this method, which has wrap"));
}

TEST_F(WrapInAStudy, IsListed) {
    ASSERT_EQ(run("methods"), 0);
    EXPECT_THAT(read(folder_ / "said"), testing::HasSubstr("Wrap lighting"));
}

} // namespace
