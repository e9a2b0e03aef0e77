// Pages that the program writes itself say what the program says.
#include "tests/end_to_end/program.h"

namespace {

using namespace tests;

TEST(MethodsPage, IsTheCommandsOutput) {
    const auto said = pairlight({"methods", "--markdown"});
    EXPECT_EQ(said.status, 0);
    EXPECT_EQ(said.out, read_file(PAIRLIGHT_SOURCE_DIR "/docs/methods.md"))
        << "pairlight methods --markdown > docs/methods.md";
}

} // namespace
