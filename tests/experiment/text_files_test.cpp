#include "experiment/text_files.h"

#include <fmt/core.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace {

namespace fs = std::filesystem;
using namespace experiment;

class TextFiles : public testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / fmt::format("pairlight-text-{}", getpid());

    void SetUp() override { fs::create_directories(folder); }

    void TearDown() override { fs::remove_all(folder); }
};

TEST_F(TextFiles, ReadBackWhatWasWritten) {
    const std::string text("a\0b\r\n\xC3\xA9", 7);
    ASSERT_TRUE(write_text_file(folder / "deep" / "file", text));
    EXPECT_EQ(read_text_file(folder / "deep" / "file"), text);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "deep"), {}), 1)
        << "a temporary file stayed";
}

TEST_F(TextFiles, SayWhichFileCouldNotBeReadAndWhy) {
    EXPECT_EQ(read_text_file(folder / "absent").error(),
              (folder / "absent").string() + ": cannot be read: No such file or directory");
    EXPECT_EQ(read_text_file(folder).error(), folder.string() + ": cannot be read: it is a folder");
}

TEST_F(TextFiles, KeepTheOldOneWhenWritingFails) {
    ASSERT_TRUE(write_text_file(folder / "file", "old"));
    ASSERT_TRUE(write_text_file(folder / "not-a-folder", ""));
    const auto failed = write_text_file(folder / "not-a-folder" / "file", "new");
    ASSERT_FALSE(failed);
    EXPECT_THAT(failed.error(), testing::HasSubstr("cannot be written"));
    EXPECT_EQ(read_text_file(folder / "file"), "old");
}

TEST(TextFilesOnDevices, WriteIntoADeviceWithoutReplacingIt) {
    EXPECT_TRUE(experiment::write_text_file("/dev/null", "text"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
    const auto full = experiment::write_text_file("/dev/full", "text");
    ASSERT_FALSE(full);
    EXPECT_THAT(full.error(), testing::HasSubstr("/dev/full: cannot be written"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
}

} // namespace
