#include "experiment/session/pair_cache.h"
#include "renderer/gpu/context.h"

#include <atomic>

namespace {

using namespace experiment::session;
using renderer::gpu::Picture8;
using testing::HasSubstr;

PairView pair(int number, const std::string& left, const std::string& right) {
    return {number, {{"bunny"}, {"back"}, {left}, {right}}};
}

const std::map<protocols::SceneId, protocols::PictureSize> sizes{{{"bunny"}, {4, 4}},
                                                                 {{"torus"}, {5, 4}}};

class PairCacheTest : public testing::Test {
  protected:
    void SetUp() override { ASSERT_TRUE(context_) << context_.error(); }

    LoadPicture load() {
        return [this](const protocols::Picture& picture) -> Expected<Picture8> {
            ++loaded_;
            if (picture.condition.value == "lost")
                return tl::unexpected(std::string("bunny/back/lost.png: there is no such file"));
            const int size = picture.condition.value == "large" ? 5 : 4;
            return Picture8{size, 4,
                            std::vector<std::uint8_t>(3u * 4u * static_cast<unsigned>(size))};
        };
    }

    renderer::Expected<renderer::gpu::Context> context_ = renderer::gpu::Context::surfaceless();
    std::atomic<int> loaded_ = 0;
};

TEST_F(PairCacheTest, LoadsEachPairOnce) {
    PairCache cache(load(), sizes);
    cache.prepare(pair(1, "green", "phong"));
    cache.prepare(pair(1, "green", "phong"));
    ASSERT_TRUE(cache.get(pair(1, "green", "phong")));
    cache.prepare(pair(2, "shss", "phong"));
    ASSERT_TRUE(cache.get(pair(1, "green", "phong"))); // drawn again while it is on the screen
    ASSERT_TRUE(cache.get(pair(2, "shss", "phong")));
    EXPECT_EQ(loaded_, 4);
}

TEST_F(PairCacheTest, GivesAPairThatWasNeverPrepared) {
    PairCache cache(load(), sizes);
    const auto got = cache.get(pair(7, "green", "phong"));
    ASSERT_TRUE(got);
    EXPECT_EQ((*got)->left.width(), 4);
}

TEST_F(PairCacheTest, RefusesAPictureOfAnotherSize) {
    PairCache cache(load(), sizes);
    EXPECT_EQ(cache.get(pair(1, "green", "large")).error(),
              "bunny/back/large: the picture has 5 x 4 pixels, expected 4 x 4");
}

TEST_F(PairCacheTest, KnowsTheSizeOfEachScenesPictures) {
    PairCache cache(load(), sizes);
    const auto got = cache.get({1, {{"torus"}, {"back"}, {"large"}, {"large"}}});
    ASSERT_TRUE(got) << got.error();
    EXPECT_EQ((*got)->left.width(), 5);
    EXPECT_EQ(cache.get({2, {{"torus"}, {"back"}, {"green"}, {"large"}}}).error(),
              "torus/back/green: the picture has 4 x 4 pixels, expected 5 x 4");
}

TEST_F(PairCacheTest, SaysWhyAPictureCannotBeLoaded) {
    PairCache cache(load(), sizes);
    cache.prepare(pair(1, "lost", "green"));
    cache.upload_what_is_ready();
    EXPECT_THAT(cache.get(pair(1, "lost", "green")).error(), HasSubstr("there is no such file"));
}

} // namespace
