// Five schedules kept as files, so that a generator that changes is noticed.  To write them anew,
// after a change that is meant: PAIRLIGHT_WRITE_GOLDEN=1 protocols_tests --gtest_filter='*Golden*'
#include "protocols/schedule.h"
#include "tests/protocols/designs.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

namespace {

using namespace protocols;

std::string_view name(Phase phase) {
    return phase == Phase::Training ? "training" : phase == Phase::WarmUp ? "warmup" : "main";
}

std::string as_csv(const Schedule& schedule) {
    auto text = fmt::format("# generator {}, order {}, sides {}\n", schedule.generator,
                            schedule.order_seed, schedule.sides_seed);
    text += "trial,phase,scene,variant,left,right\n";
    for (const auto& [number, phase, trial] : schedule.trials)
        text += fmt::format("{},{},{},{},{},{}\n", number, name(phase), trial.scene.value,
                            trial.variant.value, trial.left.value, trial.right.value);
    return text;
}

class GoldenSchedule : public testing::TestWithParam<int> {};

/// The paper's design under five seeds, a session further each time.
TEST_P(GoldenSchedule, IsDrawnAgainByteForByte) {
    auto study = tests::design(3, 3, 4);
    study.plan.sessions = 5;
    study.seed = static_cast<std::uint64_t>(GetParam());
    const auto text = as_csv(make_schedule(study, {"P7K2M"}, GetParam()).value());
    const auto path = fmt::format("{}/schedules/seed-{}.csv", PAIRLIGHT_TEST_DATA, GetParam());
    if (std::getenv("PAIRLIGHT_WRITE_GOLDEN") != nullptr)
        std::ofstream(path) << text;
    std::ifstream file(path);
    ASSERT_TRUE(file.is_open()) << path;
    std::stringstream kept;
    kept << file.rdbuf();
    EXPECT_EQ(text, kept.str());
}

INSTANTIATE_TEST_SUITE_P(OfFiveSeeds, GoldenSchedule, testing::Range(1, 6));

} // namespace
