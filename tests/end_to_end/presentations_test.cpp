// Pictures in turn, and beside a reference, in the real window: photographs of the screen against
// the record, which says what was on it from when to when, on the same clock.
#include "experiment/session/clock.h"
#include "experiment/store/sqlite_store.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <vector>

namespace {

using namespace tests;
using experiment::store::Frame;
using renderer::imaging::EncodedImage;

constexpr int screen_width = 800;
constexpr int screen_height = 600;
constexpr int gap = 20;

std::int64_t now() {
    return experiment::session::SystemClock().now().count();
}

/// Which picture stands with its upper left corner at `left` and in the middle of the height:
/// "garden/first", ...; "grey" where all is the surround, "something" where neither is.
std::string picture_at(const EncodedImage& screen, int left) {
    const int top = (screen_height - picture_height) / 2;
    std::vector<std::uint16_t> codes;
    for (int y = top; y < top + picture_height; ++y) {
        const auto row = screen.codes.begin() + 3 * (y * screen.width + left);
        codes.insert(codes.end(), row, row + 3 * picture_width);
    }
    if (std::ranges::all_of(codes, [](std::uint16_t code) { return code == 128; }))
        return "grey";
    for (const std::string scene : {"garden", "harbour"})
        for (const std::string condition : {"first", "second", "third"})
            if (codes == small_picture(scene, condition).codes)
                return scene + "/" + condition;
    return "something";
}

struct Photograph {
    std::int64_t begun = 0, done = 0;
    std::vector<std::string> places; ///< from left to right
};

/// What the record says was on the screen, and that nothing was asked to change it meanwhile.
struct Stay {
    std::string what;
    protocols::Trial trial;
    std::int64_t from = 0, to = 0;
    std::int64_t gone = 0; ///< when the next was to be seen; 0: not known
};

void add_stays(std::vector<Stay>& stays,
               const protocols::Trial& trial,
               const std::vector<Frame>& frames,
               std::int64_t end) {
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (frames[i].what != "stored")
            stays.push_back({frames[i].what, trial, frames[i].done_ns,
                             i + 1 < frames.size() ? frames[i + 1].due_ns : end,
                             i + 1 < frames.size() ? frames[i + 1].done_ns : 0});
}

class Presentations : public testing::Test {
  protected:
    /// A sitting of the small study with `session` in its [session] table, photographed at `lefts`
    /// all the while; `keys` are pressed every second or so.
    void sit(const std::string& session,
             const std::vector<int>& lefts,
             const std::vector<std::string>& keys) {
        write_small_study(study.path());
        auto text = read_file(study / "study.toml");
        const std::string replaced = "warm_ups   = 3\ntraining   = 4\ngrey_ms    = 100\n";
        const auto at = text.find(replaced);
        ASSERT_NE(at, std::string::npos);
        text.replace(at, replaced.size(), "warm_ups = 1\ntraining = 1\ngrey_ms = 400\n" + session);
        write_file(study / "study.toml", text);
        RunningProgram program(
            {PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer", "P1"},
            study / "stderr");
        Typist typist;
        const auto end = now() + 120'000'000'000;
        auto pressed = now();
        while (program.is_running() && now() < end) {
            Photograph taken{now(), 0, {}};
            const auto image = screen.photograph();
            taken.done = now();
            for (const int left : lefts)
                taken.places.push_back(picture_at(image, left));
            photographs.push_back(std::move(taken));
            if (now() - pressed < 900'000'000)
                continue;
            for (const auto& key : keys)
                typist.press(key);
            pressed = now();
        }
        ASSERT_FALSE(program.is_running()) << "the sitting did not end";
        ASSERT_EQ(program.status(), 0) << read_file(study / "stderr");
    }

    std::vector<Stay> stays() const {
        const auto votes = experiment::store::open_votes(study / "votes.sqlite");
        const auto sitting = **(*votes)->sitting({{"P1"}, 1});
        const auto trial = [&](int number) {
            return sitting.plan[static_cast<std::size_t>(number - 1)].trial;
        };
        std::vector<Stay> all;
        for (const auto& vote : sitting.votes)
            add_stays(all, trial(vote.trial), vote.frames, vote.key_ns);
        for (const auto& seen : sitting.frames)
            add_stays(all, trial(seen.trial), seen.frames, 0);
        return all;
    }

    /// How many photographs fell wholly into a stay of each kind; every one of them has to show
    /// what `wanted` says.
    template <class Wanted>
    std::map<std::string, int> compare(Wanted wanted) const {
        std::map<std::string, int> compared;
        for (const auto& stay : stays())
            for (const auto& photograph : photographs)
                if (photograph.begun > stay.from && photograph.done < stay.to) {
                    ++compared[stay.what];
                    EXPECT_EQ(photograph.places, wanted(stay)) << stay.what;
                }
        return compared;
    }

    VirtualScreen screen{screen_width, screen_height};
    TemporaryFolder study;
    std::vector<Photograph> photographs;
};

constexpr int middle = (screen_width - picture_width) / 2;

std::string name_of(const protocols::Trial& trial, const protocols::ConditionId& condition) {
    return trial.scene.value + "/" + condition.value;
}

TEST_F(Presentations, InSequenceShowOnePictureThenGreyThenTheOtherThenGrey) {
    sit("presentation = \"sequential\"\nview_ms = 2400\nbetween_ms = 1400\n", {middle},
        {"space", "F9", "Left"});
    const auto compared = compare([](const Stay& stay) -> std::vector<std::string> {
        if (stay.what == "first")
            return {name_of(stay.trial, stay.trial.left)};
        if (stay.what == "second")
            return {name_of(stay.trial, stay.trial.right)};
        return {"grey"};
    });
    EXPECT_GT(compared.at("first"), 0);
    EXPECT_GT(compared.at("between"), 0);
    EXPECT_GT(compared.at("second"), 0);
    // Each was seen as long as the study says and never shorter; longer by the next drawing, which
    // software does, on a machine that may have other things to do.
    for (const auto& stay : stays())
        if (stay.gone > 0 && (stay.what == "first" || stay.what == "between")) {
            const auto ms = static_cast<double>(stay.gone - stay.from) / 1e6;
            const double asked = stay.what == "first" ? 2400 : 1400;
            EXPECT_GE(ms, asked);
            EXPECT_LE(ms, asked + 1000);
        }
}

TEST_F(Presentations, ThatFlipShowTheOtherPictureInTheSamePlace) {
    sit("presentation = \"flip\"\n", {middle}, {"space", "F9", "Left", "Tab"});
    const auto compared = compare([](const Stay& stay) -> std::vector<std::string> {
        if (stay.what == "grey")
            return {"grey"};
        return {name_of(stay.trial, stay.what == "first" ? stay.trial.left : stay.trial.right)};
    });
    EXPECT_GT(compared.at("first"), 0);
    EXPECT_GT(compared.at("second"), 0);
    const auto votes = *(*experiment::store::open_votes(study / "votes.sqlite"))->votes();
    EXPECT_EQ(votes.size(), static_cast<std::size_t>(pairs_asked));
    for (const auto& vote : votes)
        EXPECT_EQ(vote.chosen, protocols::Choice::Left);
}

TEST_F(Presentations, WithAReferenceShowItBetweenThePairAndNeverCompareIt) {
    const int left = (screen_width - 3 * picture_width - 2 * gap) / 2;
    const int step = picture_width + gap;
    sit("reference = \"third\"\nrepetitions = 2\n", {left, left + step, left + 2 * step},
        {"space", "F9", "Left"});
    const auto compared = compare([](const Stay& stay) -> std::vector<std::string> {
        if (stay.what == "grey")
            return {"grey", "grey", "grey"};
        return {name_of(stay.trial, stay.trial.left), stay.trial.scene.value + "/third",
                name_of(stay.trial, stay.trial.right)};
    });
    EXPECT_GT(compared.at("pair"), 0);
    const auto votes = *(*experiment::store::open_votes(study / "votes.sqlite"))->votes();
    EXPECT_EQ(votes.size(), 4u);
    for (const auto& vote : votes) {
        EXPECT_NE(vote.pair.left.value, "third");
        EXPECT_NE(vote.pair.right.value, "third");
    }
}

TEST_F(Presentations, InSequenceKeepTheReferenceBesideThem) {
    const int left = (screen_width - 2 * picture_width - gap) / 2;
    sit("presentation = \"sequential\"\nview_ms = 2400\nbetween_ms = 500\nreference = \"third\"\n",
        {left, left + picture_width + gap}, {"space", "F9", "Right"});
    const auto compared = compare([](const Stay& stay) -> std::vector<std::string> {
        if (stay.what != "first" && stay.what != "second")
            return {"grey", "grey"};
        return {stay.trial.scene.value + "/third",
                name_of(stay.trial, stay.what == "first" ? stay.trial.left : stay.trial.right)};
    });
    EXPECT_GT(compared.at("first"), 0);
    EXPECT_GT(compared.at("second"), 0);
}

} // namespace
