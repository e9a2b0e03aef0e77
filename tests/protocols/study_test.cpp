#include "protocols/study.h"

namespace {

using namespace protocols;

TEST(PicturePath, NamesSceneVariantAndCondition) {
    EXPECT_EQ(picture_path({{"bunny"}, {"back"}, {"shss-25"}}), "bunny/back/shss-25");
}

TEST(PicturePath, OfAStudyWithoutVariantsHasNoVariantFolder) {
    EXPECT_EQ(picture_path({{"bunny"}, {""}, {"mine"}}), "bunny/mine");
}

TEST(ShownVariants, AreOneNamelessVariantWhereTheStudyHasNone) {
    ASSERT_EQ(shown_variants(Study{}).size(), 1u);
    EXPECT_EQ(shown_variants(Study{}).front().id.value, "");
}

} // namespace
