// How long after a key its vote is on the disk, and how long after that the next pair is on the
// screen: a sitting in the real window under a virtual screen, keys pressed from outside, times
// read from the record.  Prints figures; judges nothing.
#include "experiment/store/sqlite_store.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace tests;
namespace store = experiment::store;

double in_ms(std::int64_t ns) {
    return static_cast<double>(ns) / 1e6;
}

double quantile(const std::vector<double>& sorted, double share) {
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(share * last + 0.5)];
}

void print(const char* what, std::vector<double> values) {
    std::sort(values.begin(), values.end());
    fmt::print("{:<46} n {:>4}  median {:7.2f}  99 % {:7.2f}  greatest {:7.2f} ms\n", what,
               values.size(), quantile(values, 0.5), quantile(values, 0.99), values.back());
}

const store::Frame* frame_of(const store::MainVote& vote, const std::string& what) {
    const auto found = std::ranges::find(vote.frames, what, &store::Frame::what);
    return found == vote.frames.end() ? nullptr : &*found;
}

} // namespace

int main() {
    constexpr int grey_ms = 500;
    const VirtualScreen screen(1280, 800);
    const TemporaryFolder study;
    write_small_study(study.path());
    auto text = read_file(study / "study.toml");
    const auto replace = [&](const std::string& old, const std::string& other) {
        text.replace(text.find(old), old.size(), other);
    };
    replace("grey_ms    = 100", "grey_ms    = 500");
    replace("warm_ups   = 3", "warm_ups   = 3\nrepetitions = 20\nbreak_every = 0");
    write_file(study / "study.toml", text);

    RunningProgram program({PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer", "P1",
                            "--window", "1280x800"},
                           study / "stderr");
    while (program.is_running())
        for (const auto* key : {"space", "F9", "Left"})
            screen.press(key);

    const auto votes = store::open_votes(study / "votes.sqlite");
    if (!votes) {
        fmt::print("{}\n{}\n", votes.error(), read_file(study / "stderr"));
        return 1;
    }
    const auto sitting = **(*votes)->sitting({{"P1"}, 1});
    fmt::print("{}\n", sitting.start.display);
    std::vector<double> key_to_record, record_to_onset, grey_seen, onset_late;
    int too_early = 0, in_time = 0;
    const double refresh_ms = 1000.0 / 60;
    for (const auto& vote : sitting.votes) {
        const auto* pair = frame_of(vote, "pair");
        const auto* grey = frame_of(vote, "grey");
        onset_late.push_back(in_ms(pair->done_ns - pair->due_ns));
        grey_seen.push_back(in_ms(pair->done_ns - grey->done_ns));
        if (const auto* stored = frame_of(vote, "stored")) {
            key_to_record.push_back(in_ms(stored->done_ns - stored->due_ns));
            record_to_onset.push_back(in_ms(pair->done_ns - stored->done_ns));
            too_early += stored->done_ns >= pair->done_ns ? 1 : 0;
            in_time += record_to_onset.back() <= grey_ms + refresh_ms ? 1 : 0;
        }
    }
    print("key to record (10 ms of it for a second answer)", key_to_record);
    print("record to next onset (500 ms of grey in it)", record_to_onset);
    print("grey as seen (500 ms asked for)", grey_seen);
    print("onset after it was due", onset_late);
    fmt::print("pairs shown before the vote before was on disk: {}\n", too_early);
    fmt::print("record to onset within grey and one refresh of 60 Hz: {} of {}\n", in_time,
               record_to_onset.size());
    return 0;
}
