// What is wrong with the words of a command is said by the option, the value and what may stand
// there, and leaves nothing behind.
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// What the program says when it fails; it has to.
std::string complaint(const std::vector<std::string>& words) {
    const auto outcome = pairlight(words);
    EXPECT_NE(outcome.status, 0) << words.front();
    return outcome.err;
}

TEST(CommandLine, NamesTheWordsThatMayStandThere) {
    EXPECT_THAT(complaint({"cost", "torus", "--holes", "wnding"}),
                StartsWith("pairlight: --holes: 'wnding', expected one of refuse, winding (did you "
                           "mean 'winding'?); `pairlight cost --help` lists the options"));
    // what the words stand for inside the program is no word
    EXPECT_THAT(complaint({"cost", "torus", "--holes", "1"}), HasSubstr("--holes: '1', expected"));
    EXPECT_THAT(complaint({"thickness", "torus", "--directions", "d.csv", "--kind", "summ"}),
                HasSubstr("--kind: 'summ', expected one of first, span, sum"));
    EXPECT_THAT(complaint({"export", "study", "--format", "csv"}),
                HasSubstr("--format: 'csv', ex"));
    EXPECT_THAT(complaint({"analyze", "v.csv", "--format", "csv"}),
                HasSubstr("--format: 'csv', e"));
    EXPECT_THAT(complaint({"reference", "slab", "--incidence", "norm"}),
                AllOf(HasSubstr("--incidence: 'norm', expected one of diffuse, normal"),
                      HasSubstr("`pairlight reference slab --help`")));
    EXPECT_THAT(complaint({"cost", "torus", "--material", "marbel"}),
                HasSubstr("did you mean 'marble'?"));
    EXPECT_THAT(complaint({"init", "x", "--language", "fr"}),
                HasSubstr("--language: 'fr', expected one of en, de"));
    EXPECT_THAT(complaint({"cost", "torus", "--rounds", "1.5"}),
                HasSubstr("--rounds: 1.5 is not a whole number"));
    EXPECT_THAT(complaint({"view", "torus", "--frames", "-3"}),
                HasSubstr("--frames: -3 is not a number from 1 to"));
}

TEST(CommandLine, ReadsNumbersAsPeopleWriteThem) {
    TemporaryFolder folder;
    const auto votes = (folder / "v.csv").string(), table = (folder / "t.csv").string();
    write_file(votes, "observer,session,trial,scene,left,right,chosen\nP1,1,1,a,x,y,left\n"
                      "P2,1,1,a,x,y,right\n");
    write_file(table, "y,a\n1,p\n2,p\n3,q\n5,q\n");
    const auto findings = [&](const char* option, const char* number) {
        const auto outcome = pairlight({"analyze", votes, option, number, "--json", "-"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return outcome.out;
    };
    EXPECT_EQ(findings("--replicates", "0150"), findings("--replicates", "150"));
    EXPECT_EQ(findings("--seed", "010"), findings("--seed", "10"));
    EXPECT_EQ(
        pairlight({"anova", table, "--response", "y", "--factor", "a", "--type", "03"}).status, 0);
    EXPECT_THAT(complaint({"anova", table, "--response", "y", "--factor", "a", "--type", "0x2"}),
                HasSubstr("--type: 0x2 is not a whole number from 1 to 3"));
    for (const auto* seed : {"-1", "18446744073709551616"})
        for (const auto& words :
             std::vector<std::vector<std::string>>{{"analyze", votes, "--seed", seed},
                                                   {"reference", "slab", "--seed", seed},
                                                   {"reference", "torus", "--seed", seed}})
            EXPECT_THAT(complaint(words),
                        HasSubstr(std::string("--seed: ") + seed +
                                  " is not a whole number from 0 to 18446744073709551615"));
    for (const auto* many : {"-1", "18446744073709551616"}) {
        EXPECT_THAT(complaint({"reference", "slab", "--paths", many}),
                    HasSubstr(std::string("--paths: ") + many + " is not a number from 128 to"));
        EXPECT_THAT(complaint({"simplify", "torus", "--triangles", many}),
                    HasSubstr(std::string("--triangles: ") + many + " is not a number from 4 to"));
    }
}

TEST(CommandLine, TakesTheWordsThatMayStandThere) {
    EXPECT_EQ(pairlight({"reference", "slab", "--incidence", "diffuse", "--paths", "128"}).status,
              0);
    EXPECT_EQ(pairlight({"cost", "--help"}).status, 0);
    EXPECT_THAT(pairlight({"cost", "--help"}).out, HasSubstr("{refuse,winding}"));
}

// The parser would have taken --out for a number, and complained of that.
TEST(CommandLine, BlamesTheOptionThatHasTooFewValues) {
    EXPECT_EQ(complaint({"cost", "torus", "--to-light", "0", "1", "--out", "x"}),
              "pairlight: --to-light 0 1: 2 values given before --out, expected 3\n");
    EXPECT_EQ(complaint({"reference", "torus", "--to-light", "-1", "--out", "x.exr"}),
              "pairlight: --to-light -1: 1 value given before --out, expected 3\n");
    EXPECT_EQ(complaint({"reference", "torus", "--out", "x.exr", "--up", "0", "1"}),
              "pairlight: --up 0 1: 2 values given, expected 3\n");
    EXPECT_EQ(complaint({"thickness", "torus", "--directions", "--exact"}),
              "pairlight: --directions: no value given before --exact, expected 1\n");
    EXPECT_EQ(complaint({"reference", "slab", "--paths", "--seed", "3"}),
              "pairlight: --paths: no value given before --seed, expected 1\n");
    // negative numbers are values, and who means such a name can say so
    EXPECT_EQ(pairlight({"cost", "torus", "--to-light", "-1", "-1", "-1", "--methods", "no"}).err,
              pairlight({"cost", "torus", "--methods", "no"}).err);
    EXPECT_THAT(complaint({"thickness", "torus", "--exact", "--directions=--exact"}),
                HasSubstr("--exact: cannot be read"));
}

TEST(CommandLine, NamesItsVersion) {
    const auto outcome = pairlight({"--version"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, PAIRLIGHT_PROGRAM_VERSION "\n");
}

TEST(CommandLine, EndsWithOneStatusForAllWrongWords) {
    for (const auto& words :
         std::vector<std::vector<std::string>>{{},
                                               {"--bogus"},
                                               {"tea"},
                                               {"anova"},
                                               {"anova", "t.csv", "--resp"},
                                               {"anova", "t.csv", "--type", "4"},
                                               {"anova", "t.csv", "--type="},
                                               {"methods", "--markdown=maybe"},
                                               {"import", "s", "--from", "none"}})
        EXPECT_EQ(pairlight(words).status, 1) << testing::PrintToString(words);
}

class OutputPlaces : public testing::Test {
  protected:
    TemporaryFolder folder_;

    std::string in_folder(const std::string& name) const { return (folder_ / name).string(); }

    std::string measurements() const {
        write_file(folder_ / "t.csv", "y,a\n1,p\n2,p\n3,q\n5,q\n");
        return in_folder("t.csv");
    }

    /// As somebody in the folder would run it.
    Outcome pairlight_there(std::vector<std::string> words) const {
        words.insert(words.begin(), {"env", "-C", folder_.path().string(), PAIRLIGHT_PROGRAM});
        return run(words);
    }
};

TEST_F(OutputPlaces, ADashIsStandardOutput) {
    const auto table = measurements();
    const auto anova =
        pairlight_there({"anova", table, "--response", "y", "--factor", "a", "--json", "-"});
    ASSERT_EQ(anova.status, 0) << anova.err;
    EXPECT_TRUE(nlohmann::json::parse(anova.out).contains("terms"));
    write_small_study(folder_ / "study");
    ASSERT_EQ(
        pairlight({"session", in_folder("study"), "--observer", "P1", "--simulate", ""}).status, 0);
    const auto exported = pairlight_there({"export", "study", "--format", "long", "--csv", "-"});
    EXPECT_THAT(exported.out, StartsWith("study,observer,session,"));
    EXPECT_EQ(exported.err, "");
    const auto analysis = pairlight_there({"analyze", "study", "--json", "-"});
    EXPECT_TRUE(nlohmann::json::accept(analysis.out)) << analysis.out;
    EXPECT_THAT(pairlight_there({"schedule", "study", "--observer", "P2", "--csv", "-"}).out,
                StartsWith("trial,phase,"));
    EXPECT_THAT(pairlight_there({"simplify", "torus", "--one-of", "8", "--out", "-"}).out,
                StartsWith("OFF\n"));
    EXPECT_FALSE(fs::exists(folder_ / "-"));
}

TEST_F(OutputPlaces, ADashIsNoFolder) {
    for (const auto& words :
         std::vector<std::vector<std::string>>{{"cost", "torus", "--out", "-"},
                                               {"init", "-"},
                                               {"demo", "-"},
                                               {"pages", "study", "--png", "-"},
                                               {"compare", "a.exr", "b.exr", "--maps", "-"}}) {
        const auto outcome = pairlight_there(words);
        EXPECT_NE(outcome.status, 0) << words.front();
        EXPECT_THAT(outcome.err, HasSubstr("- is standard output")) << words.front();
    }
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(OutputPlaces, AnEmptyTextIsNotTakenForNone) {
    for (const auto& [words, name] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"init", ""}, "DIR"},
             {{"demo", ""}, "DIR"},
             {{"check", ""}, "STUDY"},
             {{"analyze", "v.csv", "--groups", ""}, "--groups"},
             {{"analyze", "v.csv", "--json", ""}, "--json"},
             {{"anova", "t.csv", "--within", ""}, "--within"},
             {{"anova", "t.csv", "--control", ""}, "--control"},
             {{"cost", "torus", "--out", ""}, "--out"},
             {{"cost", "torus", "--from", ""}, "--from"},
             {{"compare", "a.png", "b.png", "--mask", ""}, "--mask"},
             {{"compare", "a.png", "b.png", "--maps", ""}, "--maps"},
             {{"export", "study", "--format", "long", "--csv", ""}, "--csv"},
             {{"simplify", "torus", "--one-of", "8", "--out", ""}, "--out"},
             {{"import", "study", "--from", ""}, "--from"}}) {
        const auto outcome = pairlight_there(words);
        EXPECT_EQ(outcome.status, 1) << testing::PrintToString(words);
        EXPECT_THAT(outcome.err, HasSubstr("pairlight: " + name + ": \"\" says nothing, expected"))
            << testing::PrintToString(words);
        EXPECT_TRUE(fs::is_empty(folder_.path())) << testing::PrintToString(words);
    }
    EXPECT_THAT(pairlight_there({"cost", "torus", "--from", "."}).err,
                HasSubstr("--from .: is a folder; name its cost.json"));
    EXPECT_THAT(pairlight_there({"import", "study", "--from", "none"}).err,
                HasSubstr("--from: none is not a folder that is there"));
}

TEST_F(OutputPlaces, NothingIsMadeForWhatIsRefused) {
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"cost", "torus", "--methods", "nomethod", "--out", "x/y"},
             {"cost", "no-such-model", "--out", "x/y"},
             {"cost", "no-such-model"},
             {"reference", "no-such-model", "--out", "x/y.exr"},
             {"thickness", "torus", "--directions", "none.csv", "--csv", "x/y.csv"},
             {"simplify", "torus", "--triangles", "4", "--out", "x/y.off"},
             {"init", "x", "--template", "none"},
             {"anova", "none.csv", "--response", "y", "--factor", "a", "--json", "x/y.json"}}) {
        EXPECT_NE(pairlight_there(words).status, 0) << words[0] << ' ' << words[1];
        EXPECT_TRUE(fs::is_empty(folder_.path())) << words[0] << ' ' << words[1];
    }
    write_file(folder_ / "file", "");
    EXPECT_THAT(pairlight_there({"cost", "torus", "--out", "file/x"}).err,
                HasSubstr("nothing can be written there"));
}

TEST_F(OutputPlaces, AStudyStaysAsItWasWhereACommandIsRefused) {
    write_small_study(folder_ / "study");
    const auto files = [&] {
        std::vector<std::string> names;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path()))
            names.push_back(entry.path().string());
        std::ranges::sort(names);
        return names;
    };
    const auto before = files();
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"render", "study", "--only", "nowhere"},
             {"report", "study"},
             {"simulate", "study", "--observers", "2", "--observer-spec", "scores=nobody:1"},
             {"session", "study", "--observer", "P1", "--simulate", "scores=nobody:1"},
             {"import", "study", "--from", "study/stimuli/garden"},
             {"export", "study", "--format", "long", "--csv", "x/y.csv"},
             {"register", "study", "--observer", "P1", "--answer", "nothing=1"}}) {
        EXPECT_NE(pairlight_there(words).status, 0) << words[0];
        EXPECT_EQ(files(), before) << words[0];
    }
    ASSERT_EQ(
        pairlight({"session", in_folder("study"), "--observer", "P1", "--simulate", ""}).status, 0);
    write_file(folder_ / "study/cost/cost.json", "{");
    EXPECT_THAT(pairlight_there({"report", "study"}).err, HasSubstr("cost.json:1: "));
    EXPECT_FALSE(fs::exists(folder_ / "study/report"));
}

} // namespace
