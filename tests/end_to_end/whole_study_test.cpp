// From a study file to a report, without a display and with bodies of our own for models.
#include "analysis/csv.h"
#include "tests/end_to_end/program.h"

#include <algorithm>
#include <filesystem>

namespace {

namespace fs = std::filesystem;
using namespace tests;
using testing::HasSubstr;

constexpr const char* study_text = R"([study]
id       = "bodies"
title    = "Two bodies"
question = "Which picture looks more realistic?"
seed     = 3
width    = 96
height   = 96
[session]
sessions   = 2
days_apart = 1
[[scene]]
id       = "torus"
model    = "torus"
material = "marble"
[[scene]]
id       = "shell"
model    = "shell"
material = "skin2"
[[variant]]
id       = "back"
to_light = [0, 0.3, -1]
[[variant]]
id       = "left"
to_light = [-1, 0, 0]
[[condition]]
id         = "shss"
method     = "shss"
directions = 256
[[condition]]
id         = "paper-law"
method     = "shss"
bands      = 2
law        = "paper"
directions = 256
[[condition]]
id        = "green"
method    = "green"
depth_map = 512
[[condition]]
id     = "phong"
method = "phong"
)";

long lines(const std::string& text) {
    return std::ranges::count(text, '\n');
}

TEST(WholeStudy, GoesFromItsFileToAReport) {
    const TemporaryFolder folder;
    write_file(folder / "study.toml", study_text);
    write_file(folder / "instructions.md", "Choose.\n");
    const auto study = folder.path().string();

    ASSERT_EQ(pairlight({"check", study}).status, 0) << pairlight({"check", study}).err;
    const auto rendered = pairlight({"render", study, "--quiet"});
    ASSERT_EQ(rendered.status, 0) << rendered.err;
    EXPECT_EQ(rendered.out, "16 pictures rendered, 0 up to date, 0 own images checked\n");
    EXPECT_EQ(rendered.err, "");
    EXPECT_EQ(pairlight({"render", study, "--quiet"}).out,
              "0 pictures rendered, 16 up to date, 0 own images checked\n");

    // A picture that was touched is made again, and with it the others whose brightness it shares.
    write_file(folder.path() / "stimuli" / "torus" / "back" / "green.png", "not the picture");
    EXPECT_EQ(pairlight({"render", study, "--quiet"}).out,
              "4 pictures rendered, 12 up to date, 0 own images checked\n");

    // A study that was changed after rendering is noticed before anyone sits in front of it.
    auto changed = std::string(study_text);
    changed.replace(changed.find("bands      = 2"), 14, "bands      = 3");
    write_file(folder / "study.toml", changed);
    EXPECT_THAT(pairlight({"check", study}).err,
                HasSubstr("rendered before the study was changed"));
    EXPECT_THAT(pairlight({"session", study, "--observer", "P1"}).err,
                HasSubstr("rendered before the study was changed"));
    write_file(folder / "study.toml", study_text);

    ASSERT_EQ(pairlight({"simulate", study, "--observers", "3"}).status, 0);
    const auto exported = pairlight({"export", study, "--format", "long"});
    EXPECT_EQ(lines(exported.out), 1 + 3 * 2 * 4 * 6)
        << "3 observers, 2 sessions, 4 pictures, 6 pairs";
    EXPECT_THAT(
        exported.out,
        HasSubstr("study,observer,session,trial,scene,variant,left,right,chosen,rt_ms,onset_utc"));

    write_file(folder / "votes.csv", exported.out);
    const auto from_store = pairlight({"analyze", study});
    const auto from_table = pairlight({"analyze", (folder / "votes.csv").string()});
    ASSERT_EQ(from_store.status, 0) << from_store.err;
    ASSERT_EQ(from_table.status, 0) << from_table.err;
    EXPECT_THAT(from_store.out, HasSubstr("imulated"));
    EXPECT_THAT(from_table.out, HasSubstr("imulated"));

    const auto report = pairlight({"report", study, "--quiet"});
    ASSERT_EQ(report.status, 0) << report.err;
    const auto page = read_file(fs::path(report.out.substr(0, report.out.size() - 1)));
    EXPECT_THAT(page, HasSubstr("imulated"));
    EXPECT_THAT(page, testing::Not(HasSubstr("src=\"http"))) << "the page may not need a network";
    EXPECT_TRUE(fs::exists(folder.path() / "report" / "findings.json"));
    EXPECT_EQ(pairlight({"verify", study}).status, 0);
}

TEST(WholeStudy, SchedulesAreTheSameEveryTimeAndDifferBetweenSessions) {
    const TemporaryFolder folder;
    write_file(folder / "study.toml", study_text);
    const auto schedule = [&](const std::string& session) {
        return pairlight({"schedule", folder.path().string(), "--observer", "P1", "--session",
                          session, "--quiet"})
            .out;
    };
    EXPECT_EQ(lines(schedule("1")), 1 + 4 + 3 + 24);
    EXPECT_EQ(schedule("1"), schedule("1"));
    EXPECT_NE(schedule("1"), schedule("2"));
}

// The chord of a unit sphere from a vertex along a direction into it; 1 unit is 2 mm here.
TEST(ThicknessCommand, TracesAModelInTheFormScriptsRelyOn) {
    const TemporaryFolder folder;
    write_file(folder / "directions.csv", "x,y,z\n0,0,1\n0,0,-1\n");
    const auto outcome =
        pairlight({"thickness", "sphere", "--directions", (folder / "directions.csv").string(),
                   "--exact", "--mm-per-unit", "2", "--quiet"});
    ASSERT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::StartsWith("vertex,x,y,z,nx,ny,nz,direction,thickness\n"));
    int seen = 0;
    const auto read = analysis::read_csv(
        outcome.out, "out", [&](std::int64_t line, std::span<const std::string_view> fields) {
            if (line == 1)
                return std::string();
            const double z = std::stod(std::string(fields[3]));
            const double toward = fields[7] == "0" ? 1.0 : -1.0;
            const double chord = 2.0 * 2.0 * std::max(0.0, -z * toward);
            // An icosphere's facets (edges of 0.035) lie up to h^2/8 = 1.5e-4 inside the sphere; a
            // chord at height z is off by that over z at each end.  Nearer to grazing, a chord is
            // as short as an edge, and the facets decide.
            if (std::abs(z) <= 0.1)
                return std::string();
            EXPECT_LE(std::abs(std::stod(std::string(fields[8])) - chord), 0.01) << line;
            ++seen;
            return std::string();
        });
    EXPECT_TRUE(read);
    EXPECT_GT(seen, 1000);
}

} // namespace
