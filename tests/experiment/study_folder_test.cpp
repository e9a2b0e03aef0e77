#include "experiment/study_folder.h"

namespace {

using experiment::study_folder;

TEST(StudyFolder, IsMeantByItselfAndByItsStudyFile) {
    EXPECT_EQ(study_folder("mine").study_file(), "mine/study.toml");
    EXPECT_EQ(study_folder("mine/study.toml").votes(), "mine/votes.sqlite");
    EXPECT_EQ(study_folder("study.toml").root, ".");
}

} // namespace
