#include "experiment/cost/shared_transfers.h"
#include "renderer/geometry/bodies.h"

namespace {

using experiment::cost::SharedTransfers;
namespace transfer = renderer::transfer;

constexpr transfer::TransferOptions with_bands(int bands, int directions = 128) {
    return {.mode = transfer::Mode::ShadowedDiffuse, .bands = bands, .directions = directions};
}

TEST(SharedTransfers, ServeFewerBandsAndChargeForWhatTheyTook) {
    const auto mesh = renderer::geometry::sphere(1, 2);
    SharedTransfers transfers(mesh, {{0.1, 0.1, 0.1}, {1, 1, 1}, 1}, 1);
    const auto four = transfers.field(with_bands(4));
    ASSERT_TRUE(four) << four.error();
    EXPECT_EQ(transfers.seconds_saved(), 0);
    EXPECT_EQ(*transfers.field(with_bands(4)), *four); // the very same
    const double charged = transfers.seconds_saved();
    EXPECT_GT(charged, 0);
    const auto two = transfers.field(with_bands(2));
    ASSERT_TRUE(two) << two.error();
    EXPECT_EQ((*two)->transfer, transfer::first_bands(**four, 2).transfer);
    EXPECT_EQ(transfers.seconds_saved(), charged);
    // more bands and other rays are transfers of their own
    EXPECT_EQ((*transfers.field(with_bands(5)))->bands, 5);
    EXPECT_NE((*transfers.field(with_bands(2, 256)))->transfer, (*two)->transfer);
    EXPECT_EQ(transfers.seconds_saved(), 0);
}

} // namespace
