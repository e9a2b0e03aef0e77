// What goes wrong says so in one line, with a status that is not 0, and changes nothing that was
// recorded.
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using testing::AllOf;
using testing::HasSubstr;

/// A rendered study of one model.
std::string rendered_study(const std::string& model) {
    return R"([study]
id       = "rendered"
title    = "One model"
question = "Which picture looks more realistic?"
seed     = 1
width    = 64
height   = 64
[[scene]]
id       = "body"
model    = ")" +
           model + R"("
material = "marble"
[[condition]]
id     = "phong"
method = "phong"
[[condition]]
id     = "green"
method = "green"
depth_map = 256
)";
}

class BadInput : public testing::Test {
  protected:
    TemporaryFolder folder;

    void study_with(const std::string& text) {
        write_file(folder / "study.toml", text);
        write_file(folder / "instructions.md", "Choose.\n");
    }

    std::string path() const { return folder.path().string(); }
};

TEST_F(BadInput, NamesAModelThatIsNotThereAndWhereItWasLookedFor) {
    study_with(rendered_study("no-such-model"));
    const auto outcome = pairlight({"render", path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("study.toml:"), HasSubstr("no-such-model"),
                                   HasSubstr("fetch-models")));
    EXPECT_FALSE(fs::exists(folder / "stimuli"));
}

TEST_F(BadInput, RefusesAMeshThatIsNotClosed) {
    write_file(folder / "open.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    study_with(rendered_study("./open.off"));
    const auto outcome = pairlight({"render", path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("open.off"), HasSubstr("3 boundary edges")));
    EXPECT_FALSE(fs::exists(folder / "stimuli" / "manifest.json"));
}

TEST_F(BadInput, NamesAnUnknownKeyOfTheStudyByItsLine) {
    study_with(rendered_study("sphere") + "[display]\nsurrounding = \"code:128\"\n");
    const auto outcome = pairlight({"check", path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("study.toml:20: "), HasSubstr("surrounding"),
                                   HasSubstr("surround")));
}

TEST_F(BadInput, RefusesAnObserverWithAFinishedSessionAndChangesNothing) {
    write_small_study(folder.path());
    ASSERT_EQ(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).status, 0);
    const auto store = read_file(folder / "votes.sqlite");
    for (const auto* number : {"", "1"}) {
        std::vector<std::string> words{"session", path(), "--observer", "P1", "--simulate", ""};
        if (*number != '\0')
            words.insert(words.end(), {"--session", number});
        const auto outcome = pairlight(words);
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("P1"), HasSubstr("finished")));
    }
    EXPECT_TRUE(read_file(folder / "votes.sqlite") == store) << "the store was changed";
}

TEST_F(BadInput, SaysThatAFolderCannotBeWrittenAndLosesNothing) {
    write_small_study(folder.path());
    ASSERT_EQ(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).status, 0);
    const auto store = read_file(folder / "votes.sqlite");
    fs::permissions(folder / "votes.sqlite", fs::perms::owner_read | fs::perms::others_read);
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                       fs::perms::others_read | fs::perms::others_exec);
    // Root may write anywhere, so the program runs as somebody else where the test is root.
    std::vector<std::string> words{PAIRLIGHT_PROGRAM, "session", path(), "--observer", "P2",
                                   "--simulate",      ""};
    if (geteuid() == 0)
        words.insert(words.begin(),
                     {"setpriv", "--reuid=65534", "--regid=65534", "--clear-groups"});
    const auto outcome = run(words);
    fs::permissions(folder.path(), fs::perms::owner_all);
    EXPECT_EQ(outcome.status, 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("votes.sqlite"));
    EXPECT_TRUE(read_file(folder / "votes.sqlite") == store) << "the store was changed";
}

TEST_F(BadInput, SaysWhatIsMissingWhereThereIsNoOpenGl) {
    study_with(rendered_study("sphere"));
    setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent.json", 1);
    const auto outcome = pairlight({"render", path()});
    unsetenv("__EGL_VENDOR_LIBRARY_FILENAMES");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("EGL"));
    EXPECT_FALSE(fs::exists(folder / "stimuli"));
}

TEST_F(BadInput, SaysThatASittingNeedsADisplayAndHowToDoWithout) {
    write_small_study(folder.path());
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    const auto outcome = pairlight({"session", path(), "--observer", "P1"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("DISPLAY"), HasSubstr("--simulate")));
    EXPECT_FALSE(fs::exists(folder / "votes.sqlite"));
}

TEST_F(BadInput, NamesAnOwnImageThatIsMissingOrOfAnotherSize) {
    write_small_study(folder.path());
    fs::remove(folder.path() / "stimuli" / "garden" / "first.png");
    EXPECT_THAT(pairlight({"check", path()}).err,
                AllOf(HasSubstr("garden/first.png"), HasSubstr("missing")));
    ASSERT_EQ(
        run({"convert", "-size", "10x10", "xc:red", path() + "/stimuli/garden/first.png"}).status,
        0);
    EXPECT_THAT(pairlight({"check", path()}).err,
                AllOf(HasSubstr("garden/first.png"), HasSubstr("10x10")));
}

TEST_F(BadInput, SaysWhereAModelFileIsEmpty) {
    for (const auto* name : {"empty.off", "empty.ply", "empty.obj"}) {
        write_file(folder / name, "");
        EXPECT_EQ(pairlight({"simplify", (folder / name).string(), "--one-of", "2"}).err,
                  "pairlight: " + (folder / name).string() +
                      ": the file is empty, expected a model\n");
    }
}

TEST_F(BadInput, NamesFilesThatAreFoldersOrNoText) {
    write_small_study(folder.path());
    write_file(folder / "instructions.md", "Choose\xFF.\n");
    EXPECT_THAT(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).err,
                HasSubstr("instructions.md:1: a byte that is no UTF-8"));
    fs::remove(folder / "instructions.md");
    fs::create_directory(folder / "instructions.md");
    EXPECT_THAT(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).err,
                HasSubstr("instructions.md: cannot be read: it is a folder"));
    fs::remove(folder / "study.toml");
    fs::create_symlink("study.toml", folder / "study.toml");
    EXPECT_THAT(pairlight({"check", path()}).err,
                AllOf(HasSubstr("study.toml: Too many levels of symbolic links; see to it"),
                      testing::Not(HasSubstr("filesystem error"))));
}

TEST_F(BadInput, NamesTheLineOfATableOfGroupsThatIsWrong) {
    const auto table = (folder / "votes.csv").string(), groups = (folder / "groups.csv").string();
    write_file(table, "observer,session,trial,scene,left,right,chosen\nP1,1,1,a,x,y,left\n"
                      "P2,1,1,a,x,y,left\n");
    const auto said = [&](const std::string& text) {
        write_file(groups, text);
        return pairlight({"analyze", table, "--groups", groups}).err;
    };
    EXPECT_THAT(said("observer,age\nP1,\xFF\nP2,old\n"),
                HasSubstr("groups.csv:2: a byte that is no UTF-8"));
    EXPECT_THAT(said(std::string("observer,age\nP1,\0\nP2,old\n", 26)),
                HasSubstr("groups.csv:2: a zero byte"));
    EXPECT_THAT(said(""), HasSubstr("groups.csv: there is no observer in it"));
}

TEST_F(BadInput, NamesTheLineOfAVoteTableThatIsWrong) {
    write_file(
        folder / "votes.csv",
        "observer,session,trial,scene,left,right,chosen\nP1,1,1,a,x,y,left\nP1,1,2,a,x,x,left\n");
    const auto outcome = pairlight({"analyze", (folder / "votes.csv").string()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("votes.csv:3: "));
}

TEST_F(BadInput, RefusesANameForAnObserverAndLeavesNoTrace) {
    write_small_study(folder.path());
    const auto outcome = pairlight({"session", path(), "--observer", "Jane Doe", "--simulate", ""});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(HasSubstr("Jane Doe"), HasSubstr("pseudonym")));
    EXPECT_FALSE(fs::exists(folder / "votes.sqlite"));
}

TEST_F(BadInput, WritesNoResultOverAStudyOrOverItsOwnSource) {
    write_small_study(folder.path());
    ASSERT_EQ(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).status, 0);
    const auto store = read_file(folder / "votes.sqlite");
    const auto outcome =
        pairlight({"export", path(), "--format", "long", "--csv", path() + "/votes.sqlite"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("would be written over"));
    EXPECT_TRUE(read_file(folder / "votes.sqlite") == store) << "the store was changed";
    const auto table = path() + "/votes.csv";
    ASSERT_EQ(pairlight({"export", path(), "--format", "long", "--csv", table}).status, 0);
    EXPECT_EQ(pairlight({"analyze", table, "--json", table}).status, 1);
}

/// Runs the words; nothing of the file may have changed, and the complaint has to say why.
void expect_kept(const fs::path& file, const std::vector<std::string>& words) {
    const auto before = read_file(file);
    const auto outcome = pairlight(words);
    EXPECT_EQ(outcome.status, 1) << testing::PrintToString(words);
    EXPECT_THAT(outcome.err, HasSubstr("would be written over and lost; name another file"));
    EXPECT_TRUE(read_file(file) == before)
        << file << " was changed by " << testing::PrintToString(words);
}

TEST_F(BadInput, WritesNoResultOverAnyOfItsSources) {
    const auto at = [&](const char* name) { return (folder / name).string(); };
    ASSERT_EQ(pairlight({"simplify", "torus", "--one-of", "8", "--out", at("tet.off")}).status, 0);
    write_file(folder / "d.csv", "x,y,z\n1,0,0\n");
    for (const auto* name : {"tet.off", "d.csv", "./d.csv"})
        expect_kept(folder / name, {"thickness", at("tet.off"), "--directions", at("d.csv"),
                                    "--exact", "--csv", at(name)});
    expect_kept(folder / "tet.off", {"reference", "furnace", "--model", at("tet.off"), "--paths",
                                     "128", "--json", at("tet.off")});
    write_file(folder / "v.csv", "observer,session,trial,scene,left,right,chosen\n"
                                 "P1,1,1,a,x,y,left\nP2,1,1,a,x,y,left\n");
    write_file(folder / "g.csv", "observer,age\nP1,young\nP2,old\n");
    for (const auto* name : {"v.csv", "g.csv"})
        expect_kept(folder / name,
                    {"analyze", at("v.csv"), "--groups", at("g.csv"), "--json", at(name)});
    write_file(folder / "t.csv", "y,a\n1,p\n2,p\n3,q\n5,q\n");
    expect_kept(folder / "t.csv",
                {"anova", at("t.csv"), "--response", "y", "--factor", "a", "--json", at("t.csv")});
    ASSERT_EQ(pairlight({"export", at("v.csv"), "--format", "matrices"}).status, 0);
    expect_kept(folder / "v.csv",
                {"export", at("v.csv"), "--format", "matrices", "--csv", at("v.csv")});
}

TEST_F(BadInput, WritesNoResultOverAPictureItWasMadeFrom) {
    const auto at = [&](const char* name) { return (folder / name).string(); };
    for (const auto* name : {"a.png", "m.png", "x-flip.png", "x-ssim.png", "x-relative.png"})
        ASSERT_EQ(run({"convert", "-size", "16x16", "xc:yellow", "png24:" + at(name)}).status, 0);
    for (const auto* name : {"a.png", "x-flip.png", "m.png"})
        expect_kept(folder / name, {"compare", at("a.png"), at("x-flip.png"), "--mask", at("m.png"),
                                    "--json", at(name)});
    for (const auto* name : {"x-flip.png", "x-ssim.png", "x-relative.png"}) {
        expect_kept(folder / name, {"compare", at("a.png"), at(name), "--maps", at("x")});
        expect_kept(folder / name, {"compare", at(name), at("a.png"), "--maps", at("x")});
        expect_kept(folder / name,
                    {"compare", at("a.png"), at("a.png"), "--mask", at(name), "--maps", at("x")});
    }
    // nor one result over another
    const auto twice = pairlight(
        {"compare", at("a.png"), at("m.png"), "--maps", at("y"), "--json", at("y-flip.png")});
    EXPECT_THAT(twice.err, HasSubstr("would be written over"));
    EXPECT_FALSE(fs::exists(folder / "y-ssim.png"));
    // a study's own pictures are sources, too
    write_small_study(folder / "study");
    const auto picture = folder / "study" / "stimuli" / "garden" / "first.png";
    expect_kept(picture, {"import", at("study"), "--from", at("study/stimuli")});
}

TEST_F(BadInput, WritesNoResultOverWhatAStudyReads) {
    write_small_study(folder.path());
    ASSERT_EQ(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).status, 0);
    fs::rename(folder / "instructions.md", folder / "words.md");
    auto study = read_file(folder / "study.toml");
    const std::string name = "instructions.md";
    study.replace(study.find(name), name.size(), "words.md");
    write_file(folder / "study.toml", study);
    const auto words = (folder / "words.md").string();
    for (const auto& command : std::vector<std::vector<std::string>>{
             {"export", path(), "--format", "long", "--csv", words},
             {"export", path(), "--format", "matrices", "--csv", words},
             {"schedule", path(), "--observer", "P2", "--csv", words},
             {"analyze", path(), "--json", words}})
        expect_kept(words, command);
}

TEST_F(BadInput, RefusesToAnalyseOrAddToARecordThatIsNotWhole) {
    write_small_study(folder.path());
    ASSERT_EQ(pairlight({"session", path(), "--observer", "P1", "--simulate", ""}).status, 0);
    auto store = read_file(folder / "votes.sqlite");
    const auto observer = store.rfind("garden");
    ASSERT_NE(observer, std::string::npos);
    store.replace(observer, 6, "gorden");
    write_file(folder / "votes.sqlite", store);
    EXPECT_EQ(pairlight({"verify", path()}).status, 1);
    for (const auto& words : std::vector<std::vector<std::string>>{
             {"analyze", path()},
             {"report", path()},
             {"export", path(), "--format", "long"},
             {"session", path(), "--observer", "P2", "--simulate", ""}}) {
        const auto outcome = pairlight(words);
        EXPECT_EQ(outcome.status, 1) << words.front();
        EXPECT_THAT(outcome.err, HasSubstr("not whole")) << words.front();
    }
}

TEST_F(BadInput, SaysThatAStudyHasNoVotesYet) {
    write_small_study(folder.path());
    for (const auto* command : {"analyze", "report"}) {
        const auto outcome = pairlight({command, path()});
        EXPECT_EQ(outcome.status, 1) << command;
        EXPECT_THAT(outcome.err, HasSubstr("no votes yet")) << command;
    }
}

TEST_F(BadInput, DoesNotWriteAStudyOverAnother) {
    write_small_study(folder.path());
    const auto study = read_file(folder / "study.toml");
    const auto outcome = pairlight({"init", path()});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("there is a study already"));
    EXPECT_EQ(read_file(folder / "study.toml"), study);
}

// Somebody simulated may sit without a screen; a display page cannot be simulated.
TEST_F(BadInput, OffersWithoutADisplayOnlyWhatTheCommandCanDo) {
    write_small_study(folder.path());
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
    for (const auto* command : {"display", "timing-check", "photometer"}) {
        const auto outcome = pairlight({command, path()});
        EXPECT_EQ(outcome.status, 1);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("there is no display"), HasSubstr("xvfb-run"),
                                       testing::Not(HasSubstr("simulate"))));
    }
    EXPECT_THAT(pairlight({"session", path(), "--observer", "P1"}).err, HasSubstr("--simulate"));
}

TEST(Program, NamesTheCommandThatThereIsNot) {
    const auto misspelt = pairlight({"anayze", "votes.csv"});
    EXPECT_EQ(misspelt.status, 1);
    EXPECT_EQ(misspelt.err, "pairlight: there is no command 'anayze' (did you mean 'analyze'?); "
                            "`pairlight --help` lists them\n");
    EXPECT_EQ(pairlight({"my-study"}).err,
              "pairlight: there is no command 'my-study'; `pairlight --help` lists them\n");
    EXPECT_EQ(pairlight({"--help"}).status, 0);
}

TEST(Program, SaysWhereOwnPicturesGo) {
    const TemporaryFolder folder;
    const auto made = pairlight({"init", (folder / "own").string(), "--template", "own-images"});
    EXPECT_EQ(made.status, 0);
    EXPECT_THAT(made.err, AllOf(HasSubstr("put the pictures where it says"), HasSubstr("import")));
    EXPECT_THAT(pairlight({"check", (folder / "own").string()}).out,
                HasSubstr("3 scenes, one way to show each: 3 pairs a sitting, one sitting"));
}

} // namespace
