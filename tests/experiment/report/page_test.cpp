#include "experiment/report/html.h"
#include "experiment/report/numbers.h"
#include "experiment/report/page.h"
#include "tests/experiment/report/shared_experiment.h"

#include <cmath>
#include <regex>

namespace {

using namespace experiment::report;
using testing::HasSubstr;
using testing::Not;

// As draw_figures would make them, without gnuplot.
std::vector<Figure> stand_in_figures() {
    return {{"mean-votes", "Bars.", "numbers of the bars", "<svg></svg>", "%PDF"},
            {"vote-matrix", "Squares.", "numbers of the matrix", "<svg></svg>", "%PDF"}};
}

std::string page_of(const ReportContents& contents) {
    return report_page(contents, stand_in_figures());
}

int count(const std::string& text, const std::string& piece) {
    int found = 0;
    for (auto at = text.find(piece); at != text.npos; at = text.find(piece, at + 1))
        ++found;
    return found;
}

ReportContents with_everything() {
    auto contents = shared_experiment();
    contents.sittings = {{"O01", 1, "2026-11-20", "12 min 5 s", 54, "A", "", "0a", "0b", false}};
    contents.thumbnails = {{{{"Dragon"}, {"back"}, {"SHSS"}}, "not really a PNG", 32, 24}};
    contents.brightness = {{{{"Dragon"}, {"back"}, {"SHSS"}}, 0.1, 0.125, 1.25, 0.0004}};
    contents.facts = {{"Design", {{"Order", "no two neighbours share a scene"}, {"Room", {}}}}};
    return contents;
}

TEST(ReportPage, NeedsNothingButItself) {
    const auto page = page_of(with_everything());
    EXPECT_THAT(page, Not(HasSubstr("http")));
    EXPECT_THAT(page, Not(HasSubstr("<script")));
    EXPECT_THAT(page, Not(HasSubstr("<link")));
    EXPECT_THAT(page, Not(HasSubstr("@import")));
    EXPECT_EQ(count(page, "src=\""), count(page, "src=\"data:image/"));
    EXPECT_GE(count(page, "src=\""), 2);
    EXPECT_THAT(page, Not(HasSubstr("{{")));
}

TEST(ReportPage, EveryPictureHasWords) {
    const auto page = page_of(with_everything());
    EXPECT_EQ(count(page, "<img "), count(page, "alt=\""));
    EXPECT_EQ(count(page, "alt=\"\""), 0);
    EXPECT_THAT(page, HasSubstr("alt=\"Dragon, back, drawn by SHSS\""));
}

// Labels, titles and facts are typed by people.
TEST(ReportPage, TakesNoMarkupFromAnybody) {
    const std::string hostile = "<script>alert(\"x\")</script> & {{body}}'";
    auto contents = with_everything();
    contents.title = contents.question = hostile;
    contents.labels.conditions["SHSS"] = hostile;
    contents.labels.scenes["Dragon"] = hostile;
    contents.sittings[0].observer = hostile;
    contents.facts[0] = {hostile, {{hostile, hostile}}};
    contents.findings.notes.push_back({"within", hostile});
    contents.findings.options.program = contents.findings.options.source = hostile;
    const auto page = page_of(contents);
    EXPECT_EQ(count(page, "<script"), 0);
    EXPECT_GE(count(page, escaped(hostile)), 10);
    EXPECT_EQ(count(page, "<body>"), 1); // "{{body}}" is not a mark once it has been typed
}

TEST(ReportPage, SaysInEveryCaptionThatVotesAreSimulated) {
    auto votes = shared_votes();
    votes.simulated = true;
    auto contents = with_everything();
    contents.findings = contents_of(votes).findings;
    const auto page = page_of(contents);
    EXPECT_THAT(page,
                HasSubstr("<p class=\"banner\" role=\"note\"><strong>SIMULATED VOTES</strong>"));
    EXPECT_THAT(page, HasSubstr("<title>SIMULATED VOTES"));
    const std::regex caption("<figcaption><b>(Table|Figure) [0-9]+\\.</b> ([^<]*)");
    int captions = 0;
    for (auto at = std::sregex_iterator(page.begin(), page.end(), caption);
         at != std::sregex_iterator(); ++at, ++captions)
        EXPECT_THAT((*at)[2].str(), testing::StartsWith("SIMULATED VOTES")) << at->str();
    EXPECT_EQ(captions, count(page, "<figcaption>"));
    EXPECT_GE(captions, 10);
}

TEST(ReportPage, OfPeoplesVotesHasNoSuchMark) {
    EXPECT_THAT(page_of(with_everything()), Not(HasSubstr("SIMULATED")));
}

TEST(ReportPage, IsInformalWithFewerThanFifteenObservers) {
    auto contents = shared_experiment();
    EXPECT_THAT(page_of(contents), HasSubstr("informal study (fewer than 15 observers)"));
    contents.findings.design.observers.resize(15, "one more");
    EXPECT_THAT(page_of(contents),
                HasSubstr("informal study (fewer than 15 observers passed a screening)"));
    contents.screened = 15;
    EXPECT_THAT(page_of(contents), Not(HasSubstr("informal study")));
}

// Known figures of the shared experiment (expected.json), as a reader sees them.
TEST(ReportPage, ShowsTheSharedExperimentsFigures) {
    const auto page = page_of(shared_experiment());
    for (const auto* figure :
         {"585", "540", "336", "159", "2.167", "1.244", "0.589", "59.34",
          "5.2\u00a0\u00d7\u00a010\u207b\u00b9\u00b2", "1.9\u00a0\u00d7\u00a010\u207b\u2078",
          "79.12", "6.5\u00a0\u00d7\u00a010\u207b\u00b9\u2076", "241.8",
          "6.6\u00a0\u00d7\u00a010\u207b\u00b9\u00b2\u2070", "not estimable: scores are ipsative"})
        EXPECT_THAT(page, HasSubstr(figure));
}

TEST(ReportPage, ShowsEveryNumberOfTheTests) {
    const auto contents = shared_experiment();
    const auto page = page_of(contents);
    const auto& findings = contents.findings;
    const auto expect_cell = [&](const std::string& text) {
        EXPECT_THAT(page, HasSubstr("<td>" + text + "</td>"));
    };
    ASSERT_EQ(findings.ranking.size(), 4U);
    for (const auto& place : findings.ranking) {
        expect_cell(votes(place.votes));
        expect_cell(decimal(place.mean_votes, 3));
        expect_cell(decimal(place.lower, 3) + " to " + decimal(place.upper, 3));
        expect_cell(place.letters);
    }
    ASSERT_EQ(findings.within_tukey.pairs.size(), 6U);
    for (const auto& pair : findings.within_tukey.pairs) {
        const bool turned = pair.difference < 0; // the greater mean is shown first
        expect_cell(decimal(std::abs(pair.difference), 3));
        expect_cell(decimal(turned ? -pair.upper : pair.lower, 3) + " to " +
                    decimal(turned ? -pair.lower : pair.upper, 3));
        expect_cell(decimal(pair.q, 2));
        expect_cell(p_value(pair.p));
    }
    ASSERT_FALSE(findings.within.empty());
    for (const auto& effect : findings.within.front().analysis.effects) {
        expect_cell(significant(effect.effect.ss, 6));
        expect_cell(significant(effect.error.ss, 6));
        expect_cell(significant(effect.test.f, 4));
        expect_cell(p_value(effect.sphericity.p_huynh_feldt));
    }
    for (const auto& scoped : findings.matrices)
        if (scoped.scope == "all")
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    if (i != j) {
                        EXPECT_THAT(page, HasSubstr(">" + std::to_string(scoped.matrix.wins(i, j)) +
                                                    "<small>"));
                    }
}

TEST(ReportPage, ShowsTheScaleAndTheObservers) {
    const auto page = page_of(with_everything());
    EXPECT_THAT(page, HasSubstr("How far apart they are"));
    EXPECT_THAT(page, HasSubstr("<td>0.71</td>"));  // SHSS in JOD
    EXPECT_THAT(page, HasSubstr("<td>0.796</td>")); // and in log-odds
    EXPECT_THAT(page, HasSubstr("scales differ by model"));
    EXPECT_THAT(page, HasSubstr("<td>29.53</td>"));
    EXPECT_THAT(page, HasSubstr("How consistent the answers are"));
    EXPECT_EQ(count(page, "in 27</td>"), 10); // circular triads in each observer's rounds
}

TEST(ReportPage, PrintsTheCaveatBesideThePapersTest) {
    const auto page = page_of(shared_experiment());
    const auto heading = page.find("<h2>As in the paper</h2>");
    const auto caveat = page.find("<p class=\"caveat\">Read with care.");
    ASSERT_NE(heading, page.npos);
    EXPECT_LT(heading, caveat);
    EXPECT_LT(caveat, page.find("One-way analysis of variance; one value is one"));
}

TEST(ReportPage, PrintsWhatIsNotOnRecord) {
    const auto page = page_of(with_everything());
    EXPECT_THAT(page, HasSubstr("<dt>Room</dt><dd class=\"absent\">not recorded</dd>"));
    EXPECT_THAT(page, HasSubstr("<dt>Order</dt><dd>no two neighbours share a scene</dd>"));
}

TEST(ReportPage, WithoutAnAnalysisSaysWhy) {
    auto contents = shared_experiment();
    contents.findings.within.clear();
    contents.findings.within_tukey.pairs.clear();
    contents.findings.one_way_observers.reset();
    contents.findings.one_way_rounds.reset();
    contents.findings.two_way.reset();
    contents.findings.why_no_anova = "one observer is not enough";
    const auto page = page_of(contents);
    EXPECT_THAT(page, HasSubstr("There is no analysis of variance: one observer is not enough."));
    EXPECT_THAT(page, Not(HasSubstr("As in the paper")));
}

TEST(Report, IsAPageWithItsFiguresBeside) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "pairlight-report";
    std::filesystem::remove_all(folder);
    const auto page = write_report(folder, shared_experiment());
    ASSERT_TRUE(page.has_value()) << page.error();
    EXPECT_EQ(*page, folder / "report.html");
    for (const auto* name : {"report.html", "figures/mean-votes.svg", "figures/mean-votes.pdf",
                             "figures/vote-matrix.svg", "figures/vote-matrix.pdf"})
        EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
    std::filesystem::remove_all(folder);
}

TEST(Report, NamesTheFileItCannotWrite) {
    const auto page = write_report("/proc/report", shared_experiment());
    ASSERT_FALSE(page.has_value());
    EXPECT_THAT(page.error(), HasSubstr("/proc/report/figures/mean-votes.svg: cannot be written"));
}

} // namespace
