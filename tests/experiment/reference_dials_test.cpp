#include "experiment/reference_dials.h"

#include "experiment/read_study.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace {

using namespace experiment;

TEST(ReferenceDials, AreKnownToStudyFiles) {
    const auto known = known_names();
    EXPECT_THAT(known.methods, testing::Contains(std::string(reference_method)));
    const auto dials = known.complete("reference", {{"seconds", std::int64_t{20}}});
    ASSERT_TRUE(dials);
    const auto run = reference_run(*dials);
    EXPECT_EQ(run.rule.relative, 0.005);
    ASSERT_TRUE(run.rule.time_budget);
    EXPECT_EQ(run.rule.time_budget->count(), 20);
    EXPECT_EQ(run.settings.boundary.kind, renderer::reference::BoundaryKind::Matched);
    EXPECT_EQ(run.seed, 1u);
}

TEST(ReferenceDials, RefuseWhatNoPathCouldDo) {
    const auto known = known_names();
    const auto polished = known.complete("reference", {{"boundary", std::string("smooth")}});
    ASSERT_FALSE(polished);
    EXPECT_EQ(polished.error().dial, "boundary");
    EXPECT_FALSE(known.complete("reference", {{"roughness", 0.01}}));
    EXPECT_FALSE(known.complete("reference", {{"bands", std::int64_t{5}}}));
}

} // namespace
