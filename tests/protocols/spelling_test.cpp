#include "protocols/spelling.h"

#include <vector>

namespace {

using protocols::nearest_name;

const std::vector<std::string> names{"width", "height", "seed", "skin1", "skin2"};

TEST(NearestName, IsTheOneThatWasProbablyMeant) {
    EXPECT_EQ(nearest_name("widht", names), "width"); // two letters of five
    EXPECT_EQ(nearest_name("wdth", names), "width");
    EXPECT_EQ(nearest_name("heigth", names), "height");
    EXPECT_EQ(nearest_name("seeds", names), "seed");
    EXPECT_EQ(nearest_name("skin3", names), "skin1"); // the first of two equally near
}

TEST(NearestName, IsNoneForAWordFarFromAll) {
    EXPECT_EQ(nearest_name("sink4", names), std::nullopt); // three of five
    EXPECT_EQ(nearest_name("orientation", names), std::nullopt);
    EXPECT_EQ(nearest_name("", names), std::nullopt);
    EXPECT_EQ(nearest_name("seed", {}), std::nullopt);
}

} // namespace
