#include "protocols/session_length.h"
#include "tests/protocols/designs.h"

namespace {

using namespace protocols;
using namespace std::chrono_literals;

// 54 main trials and 3 warm-ups at 8 s are 7 minutes 36 seconds.
TEST(EstimatedLength, OfThePapersSessionIsAboutEightMinutes) {
    auto study = tests::design(3, 3, 4);
    study.plan.training = 0;
    study.plan.adapt_s = 0;
    EXPECT_EQ(estimated_length(study), 7min + 36s);
}

TEST(EstimatedLength, CountsTrainingAdaptationAndRepetitions) {
    auto study = tests::design(3, 3, 4, 5);
    study.plan.training = 4;
    study.plan.adapt_s = 60;
    EXPECT_EQ(estimated_length(study), (4 + 3 + 270) * 8s + 60s);
    EXPECT_GT(estimated_length(study), longest_session);
}

} // namespace
