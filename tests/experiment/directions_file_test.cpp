#include "experiment/directions_file.h"
#include "experiment/text_files.h"

#include <fmt/core.h>
#include <unistd.h>

namespace {

namespace fs = std::filesystem;
using namespace experiment;

class DirectionsFile : public testing::Test {
  protected:
    fs::path file =
        fs::temp_directory_path() / fmt::format("pairlight-directions-{}.csv", getpid());

    void TearDown() override { fs::remove(file); }

    auto reading(const std::string& text) {
        EXPECT_TRUE(write_text_file(file, text));
        return read_directions(file);
    }
};

TEST_F(DirectionsFile, IsReadByTheNamesOfItsColumns) {
    const auto directions = reading("name,z,y,x\nup,0,1,0\nslanted,0.8,0,0.6\n");
    ASSERT_TRUE(directions) << directions.error();
    ASSERT_EQ(directions->size(), 2u);
    EXPECT_EQ((*directions)[0], glm::dvec3(0, 1, 0));
    EXPECT_EQ((*directions)[1], glm::dvec3(0.6, 0, 0.8));
    EXPECT_TRUE(reading("\xEF\xBB\xBFx,y,z\r\n0,0,1\r\n"));
}

TEST_F(DirectionsFile, NamesTheLineThatIsWrong) {
    EXPECT_THAT(reading("x,y,z\n0,0,1\n0,0,2\n").error(),
                testing::HasSubstr(":3: the vector's length is 2"));
    EXPECT_THAT(reading("x,y,z\n0,zero,1\n").error(),
                testing::HasSubstr(":2: y is \"zero\", expected a number"));
    EXPECT_THAT(reading("x,y,z\nnan,0,1\n").error(), testing::HasSubstr(":2: "));
    EXPECT_THAT(reading("x,y,z\n0,1\n").error(), testing::HasSubstr(":2: 2 fields, expected 3"));
    EXPECT_THAT(reading("x,y,z\n0,0,1,7\n").error(),
                testing::HasSubstr(":2: 4 fields, expected 3"));
    EXPECT_THAT(reading("x,y,z,x\n0,0,1,0\n").error(),
                testing::HasSubstr(":1: the header row has to name"));
    EXPECT_THAT(reading(std::string("x,y,z\n0,\0000,1\n", 14)).error(),
                testing::HasSubstr(":2: a zero byte"));
    EXPECT_THAT(reading("a,b,c\n").error(), testing::HasSubstr(":1: the header row has to name"));
    EXPECT_THAT(reading("x,y,z\n").error(), testing::HasSubstr("has no directions"));
}

} // namespace
