#include "renderer/gpu/context.h"

#include <cstdio>
#include <cstdlib>

namespace {

using renderer::gpu::Context;

TEST(Context, NeedsNoDisplayAndSaysWhoDraws) {
    const auto context = Context::surfaceless();
    ASSERT_TRUE(context) << context.error();
    EXPECT_THAT(renderer::gpu::description(), testing::ContainsRegex(".+, OpenGL 4\\.5"));
    EXPECT_TRUE(renderer::gpu::check("the beginning"));
}

TEST(Context, CanFollowAnother) {
    { ASSERT_TRUE(Context::surfaceless()); }
    ASSERT_TRUE(Context::surfaceless());
}

TEST(Context, CanBeMoved) {
    auto first = Context::surfaceless();
    ASSERT_TRUE(first) << first.error();
    const Context second = std::move(*first);
    EXPECT_THAT(renderer::gpu::description(), testing::HasSubstr("OpenGL"));
}

// EGL reads its environment once per process: a child that has never opened it sees no driver.
void open_without_drivers() {
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent/vendor.json", 1);
    const auto context = Context::surfaceless();
    std::fprintf(stderr, "%s\n", context ? "a context" : context.error().c_str());
    std::exit(context ? 0 : 7);
}

TEST(ContextDeathTest, SaysWhatIsMissingWhereThereIsNoDriver) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(open_without_drivers(), testing::ExitedWithCode(7),
                "no OpenGL 4.5 without a display: EGL .*surfaceless.*libgl1-mesa-dri");
}

} // namespace
