#include "experiment/study_folder.h"

namespace {

using experiment::is_study;
using experiment::study_folder;

TEST(StudyFolder, IsMeantByItselfAndByItsStudyFile) {
    EXPECT_EQ(study_folder("mine").study_file(), "mine/study.toml");
    EXPECT_EQ(study_folder("mine/study.toml").votes(), "mine/votes.sqlite");
    EXPECT_EQ(study_folder("study.toml").root, ".");
}

TEST(StudyFolder, IsToldFromAModel) {
    EXPECT_TRUE(is_study("mine/study.toml"));
    EXPECT_FALSE(is_study("torus"));
    EXPECT_FALSE(is_study("scans/bunny.ply"));
    EXPECT_FALSE(is_study(std::string(5000, 'a'))); // too long for a name: nothing is thrown
}

} // namespace
