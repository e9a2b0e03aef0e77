#include "protocols/digest.h"
#include "protocols/seeds.h"

#include <set>

namespace {

using namespace protocols;

Study pilot() {
    Study study;
    study.id = "pilot";
    study.seed = 2012;
    return study;
}

// $ printf 'pilot|2012|P7K2M|3|order' | sha256sum
TEST(StreamSeed, IsTheHeadOfADigestAnyoneCanCompute) {
    EXPECT_EQ(hexadecimal(stream_seed(pilot(), {"P7K2M"}, 3, Purpose::Order)),
              "7386fb67fc91d36f9df1c1261f5a31a7");
}

TEST(StreamSeed, NamesEveryPurpose) {
    const auto head = [](std::string_view text) { return hexadecimal(sha256(text)).substr(0, 32); };
    EXPECT_EQ(hexadecimal(stream_seed(pilot(), {"P"}, 1, Purpose::Sides)),
              head("pilot|2012|P|1|sides"));
    EXPECT_EQ(hexadecimal(stream_seed(pilot(), {"P"}, 1, Purpose::WarmUp)),
              head("pilot|2012|P|1|warmup"));
    EXPECT_EQ(hexadecimal(stream_seed(pilot(), {"P"}, 1, Purpose::Training)),
              head("pilot|2012|P|1|training"));
}

TEST(StreamSeed, ChangesWithEverythingThatNamesIt) {
    auto other_seed = pilot(), other_study = pilot();
    other_seed.seed = 2013;
    other_study.id = "pilot2";
    const std::set<Seed> seeds{stream_seed(pilot(), {"P"}, 1, Purpose::Order),
                               stream_seed(other_seed, {"P"}, 1, Purpose::Order),
                               stream_seed(other_study, {"P"}, 1, Purpose::Order),
                               stream_seed(pilot(), {"Q"}, 1, Purpose::Order),
                               stream_seed(pilot(), {"P"}, 2, Purpose::Order),
                               stream_seed(pilot(), {"P"}, 1, Purpose::Order, 1)};
    EXPECT_EQ(seeds.size(), 6u);
}

} // namespace
