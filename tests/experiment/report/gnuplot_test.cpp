#include "experiment/report/gnuplot.h"

#include <filesystem>
#include <sstream>

namespace {

using namespace experiment::report;
using testing::HasSubstr;

TEST(Gnuplot, WritesWhatTheScriptDraws) {
    const auto svg = run_gnuplot("set terminal svg\nplot x\n");
    ASSERT_TRUE(svg.has_value()) << svg.error();
    EXPECT_THAT(*svg, HasSubstr("<svg"));
    EXPECT_THAT(*svg, HasSubstr("</svg>"));
}

// A script and an output longer than any pipe holds.
TEST(Gnuplot, IsNotHeldUpByLongScripts) {
    std::ostringstream script;
    script << "set terminal svg\n$d << END\n";
    for (int i = 0; i < 20000; ++i)
        script << i << ' ' << i % 7 << '\n';
    script << "END\nplot $d with points\n";
    const auto svg = run_gnuplot(script.str());
    ASSERT_TRUE(svg.has_value()) << svg.error();
    EXPECT_GT(svg->size(), 300000U);
}

TEST(Gnuplot, ThatIsNotThereIsNamedWithItsPackage) {
    const auto drawn = run_gnuplot("plot x\n", "no-such-plotter");
    ASSERT_FALSE(drawn.has_value());
    EXPECT_THAT(drawn.error(), HasSubstr("no-such-plotter: there is no such program"));
    EXPECT_THAT(drawn.error(), HasSubstr("gnuplot-nox"));
}

TEST(Gnuplot, SaysWhyItFailed) {
    const auto drawn = run_gnuplot("set terminal svg\nplot sin(\n");
    ASSERT_FALSE(drawn.has_value());
    EXPECT_THAT(drawn.error(), HasSubstr("gnuplot failed with status 1: "));
    EXPECT_THAT(drawn.error(), HasSubstr("invalid expression"));
    EXPECT_EQ(drawn.error().find('\n'), std::string::npos);
}

// A condition's label is a stranger's text: it must neither end the string nor run a command.
TEST(Gnuplot, StringsAreOnlyStrings) {
    const auto trace = std::filesystem::path(testing::TempDir()) / "pairlight-was-run";
    std::filesystem::remove(trace);
    for (const std::string& label :
         {"`touch " + trace.string() + "`", "'; system('touch " + trace.string() + "') #",
          "\"; system(\"touch " + trace.string() + "\") #",
          "@x\nsystem('touch " + trace.string() + "')", std::string("\\"), std::string("a\\'b")}) {
        const auto svg = run_gnuplot("set terminal svg noenhanced\nset title " +
                                     gnuplot_string(label) + "\nplot x\n");
        EXPECT_TRUE(svg.has_value()) << label << ": " << svg.error();
        EXPECT_FALSE(std::filesystem::exists(trace)) << label;
    }
    EXPECT_EQ(gnuplot_string("it's\nso"), "'it\u2019s so'");
}

} // namespace
