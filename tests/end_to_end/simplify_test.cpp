// pairlight simplify, from outside.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_files.h"
#include "renderer/geometry/mesh_report.h"
#include "tests/end_to_end/program.h"

namespace {

using namespace tests;
using testing::HasSubstr;

TEST(SimplifyCommand, WritesAModelThatIsReadBackClosed) {
    const TemporaryFolder folder;
    const auto file = folder / "coarse.off";
    const auto done = pairlight({"simplify", "torus", "--one-of", "4", "--out", file.string()});
    ASSERT_EQ(done.status, 0) << done.err;
    EXPECT_THAT(done.err, HasSubstr("triangles, "));
    const auto mesh = renderer::geometry::read_mesh(file);
    ASSERT_TRUE(mesh) << mesh.error();
    const auto report = renderer::geometry::examine(*mesh);
    EXPECT_TRUE(is_closed_and_oriented(report));
    EXPECT_EQ(report.genus, 1);
    // a finer step on what was written goes on from there, and to the number that is asked for
    const auto finer = pairlight({"simplify", file.string(), "--triangles", "100"});
    EXPECT_EQ(finer.status, 0) << finer.err;
    EXPECT_THAT(finer.out, HasSubstr("OFF\n50 100 0\n"));
}

TEST(SimplifyCommand, SaysWhatCannotBe) {
    EXPECT_THAT(pairlight({"simplify", "torus"}).err, HasSubstr("either --one-of or --triangles"));
    const auto few = pairlight({"simplify", "torus", "--triangles", "4"});
    EXPECT_NE(few.status, 0);
    EXPECT_THAT(few.err, HasSubstr("torus: "));
    EXPECT_THAT(few.err, HasSubstr("are the fewest that keep its pieces and handles"));
    const TemporaryFolder folder;
    const auto file = (folder / "own.off").string();
    ASSERT_EQ(pairlight({"simplify", "sphere", "--triangles", "80", "--out", file}).status, 0);
    EXPECT_NE(pairlight({"simplify", file, "--one-of", "2", "--out", file}).status, 0)
        << "the model itself was overwritten";
    // by way of a folder that is not there yet, too
    const auto around = (folder / "new" / ".." / "own.off").string();
    EXPECT_NE(pairlight({"simplify", file, "--one-of", "2", "--out", around}).status, 0);
    EXPECT_EQ(renderer::geometry::read_mesh(file)->triangles.size(), 80u);
    const auto ply = pairlight({"simplify", "sphere", "--triangles", "80", "--out", "x.ply"});
    EXPECT_NE(ply.status, 0);
    EXPECT_THAT(ply.err, HasSubstr("x.ply: expected a name that ends in .off"));
}

} // namespace
