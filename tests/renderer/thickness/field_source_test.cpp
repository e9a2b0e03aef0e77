#include "renderer/geometry/bodies.h"
#include "renderer/thickness/field_source.h"

#include <stdlib.h>

#include <fstream>

namespace {

using namespace renderer::thickness;
namespace fs = std::filesystem;

class FieldSourceTest : public testing::Test {
  protected:
    FieldSourceTest() {
        std::string name = (fs::temp_directory_path() / "pairlight-fields-XXXXXX").string();
        folder_ = ::mkdtemp(name.data());
    }

    ~FieldSourceTest() override { fs::remove_all(folder_); }

    FieldSource source() const { return {mesh_, folder_ / "cache"}; }

    SourcedField field_of(FieldSource& source, const FieldOptions& options) const {
        auto field = source.field(options);
        EXPECT_TRUE(field) << field.error();
        return field.value_or(SourcedField{});
    }

    fs::path folder_;
    std::shared_ptr<const renderer::geometry::Mesh> mesh_ =
        std::make_shared<const renderer::geometry::Mesh>(renderer::geometry::sphere(1, 1));
    FieldOptions options_{.bands = 5, .directions = 64};
};

TEST_F(FieldSourceTest, TracesThenReadsThenRemembers) {
    auto first = source();
    const auto traced = field_of(first, options_);
    EXPECT_EQ(traced.origin, FieldOrigin::Traced);
    EXPECT_GT(traced.seconds, 0);
    EXPECT_THAT(traced.remarks, testing::IsEmpty());
    EXPECT_TRUE(fs::exists(first.file(options_))); // the folder was made
    const auto again = field_of(first, options_);
    EXPECT_EQ(again.origin, FieldOrigin::Memory);
    EXPECT_EQ(again.field, traced.field);

    auto second = source();
    const auto from_file = field_of(second, options_);
    EXPECT_EQ(from_file.origin, FieldOrigin::File);
    EXPECT_EQ(from_file.field->coefficients, traced.field->coefficients);
    EXPECT_EQ(field_of(second, options_).field, from_file.field);
    EXPECT_THAT(describe(from_file), testing::StartsWith("from its file in "));
    EXPECT_EQ(describe(again), "from memory");
}

// Tracing is the same for one band and for five: what is traced once serves every later wish, and
// is the same whoever asked first.
TEST_F(FieldSourceTest, ServesFewerBandsFromMore) {
    auto one = source();
    const auto two_bands = field_of(one, {.bands = 2, .directions = 64});
    EXPECT_EQ(two_bands.field->bands, 5);
    EXPECT_EQ(field_of(one, options_).field, two_bands.field);
    const auto six = field_of(one, {.bands = 6, .directions = 80});
    EXPECT_EQ(six.origin, FieldOrigin::Traced);
    EXPECT_EQ(six.field->bands, 6);
    EXPECT_EQ(field_of(one, {.bands = 3, .directions = 80}).field, six.field);
    // where five bands would need more directions, it is as many as were asked for
    EXPECT_EQ(field_of(one, {.bands = 2, .directions = 30}).field->bands, 2);
}

TEST_F(FieldSourceTest, RemembersSeveralKindsOfOneMesh) {
    auto one = source();
    const auto sum = field_of(one, options_);
    const auto span = field_of(one, {.kind = Kind::Span, .bands = 5, .directions = 64});
    const auto finer = field_of(one, {.bands = 5, .directions = 128});
    EXPECT_NE(sum.field, span.field);
    EXPECT_NE(sum.field, finer.field);
    EXPECT_EQ(field_of(one, options_).field, sum.field);
    EXPECT_EQ(field_of(one, {.kind = Kind::Span, .bands = 5, .directions = 64}).field, span.field);
}

TEST_F(FieldSourceTest, TracesAgainWhatIsDamagedAndSaysSo) {
    auto first = source();
    const auto traced = field_of(first, options_);
    fs::resize_file(first.file(options_), 1000);
    auto second = source();
    const auto mended = field_of(second, options_);
    EXPECT_EQ(mended.origin, FieldOrigin::Traced);
    ASSERT_EQ(mended.remarks.size(), 1u);
    EXPECT_THAT(mended.remarks[0], testing::AllOf(testing::HasSubstr("is damaged"),
                                                  testing::HasSubstr("traced again")));
    EXPECT_EQ(mended.field->coefficients, traced.field->coefficients);
    auto third = source(); // and it is whole again
    EXPECT_EQ(field_of(third, options_).origin, FieldOrigin::File);
}

TEST_F(FieldSourceTest, AFieldThatCannotBeKeptIsAFieldAllTheSame) {
    std::ofstream(folder_ / "cache") << "a file where the folder should be";
    auto one = source();
    const auto traced = field_of(one, options_);
    EXPECT_EQ(traced.origin, FieldOrigin::Traced);
    ASSERT_EQ(traced.remarks.size(), 1u);
    EXPECT_THAT(traced.remarks[0], testing::HasSubstr("cannot be written"));
}

TEST_F(FieldSourceTest, WithoutAFolderKeepsNoFile) {
    FieldSource one(mesh_, {});
    EXPECT_EQ(field_of(one, options_).origin, FieldOrigin::Traced);
    EXPECT_EQ(field_of(one, options_).origin, FieldOrigin::Memory);
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(FieldSourceTest, ACancelledTracingLeavesNothing) {
    auto one = source();
    std::stop_source stop;
    stop.request_stop();
    const auto cancelled = one.field(options_, {}, stop.get_token());
    ASSERT_FALSE(cancelled);
    EXPECT_THAT(cancelled.error(), testing::StartsWith("cancelled"));
    EXPECT_TRUE(fs::is_empty(folder_));
    EXPECT_EQ(field_of(one, options_).origin, FieldOrigin::Traced); // and can be asked again
}

} // namespace
