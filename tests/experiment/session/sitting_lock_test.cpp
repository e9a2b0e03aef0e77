#include "experiment/session/sitting_lock.h"
#include "tests/experiment/store/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using experiment::session::SittingLock;
using testing::HasSubstr;

TEST(SittingLock, IsForOneProgramAtATime) {
    const tests::TemporaryFolder folder;
    {
        const auto held = SittingLock::take(folder.path(), "P1", 1);
        ASSERT_TRUE(held) << held.error();
        const auto second = SittingLock::take(folder.path(), "P1", 1);
        ASSERT_FALSE(second);
        EXPECT_THAT(second.error(), HasSubstr("session 1 of observer P1 is taking place"));
        EXPECT_TRUE(SittingLock::take(folder.path(), "P1", 2));
        EXPECT_TRUE(SittingLock::take(folder.path(), "P2", 1));
    }
    EXPECT_TRUE(SittingLock::take(folder.path(), "P1", 1));
    EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "a lock was left behind";
}

} // namespace
