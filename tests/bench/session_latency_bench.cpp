// How long after a key its vote is on the disk, and how long after that the next pair is on the
// screen: a sitting in the real window under a virtual screen, keys pressed from outside, times
// read from the record.  Prints figures; judges nothing.
#include "experiment/session/clock.h"
#include "experiment/store/sqlite_store.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace {

using namespace tests;
using namespace std::chrono_literals;
namespace store = experiment::store;

constexpr int grey_ms = 500;
constexpr double refresh_ms = 1000.0 / 60;

double in_ms(std::int64_t ns) {
    return static_cast<double>(ns) / 1e6;
}

/// The clock that the program under test records by: it is the machine's, the same for all.
std::int64_t now() {
    return experiment::session::SystemClock().now().count();
}

double quantile(const std::vector<double>& sorted, double share) {
    const auto last = static_cast<double>(sorted.size() - 1);
    return sorted[static_cast<std::size_t>(share * last + 0.5)];
}

void print(const char* what, std::vector<double> values) {
    if (values.empty())
        return;
    std::sort(values.begin(), values.end());
    fmt::print("{:<52} n {:>4}  median {:7.2f}  99 % {:7.2f}  greatest {:7.2f} ms\n", what,
               values.size(), quantile(values, 0.5), quantile(values, 0.99), values.back());
}

const store::Frame* frame_of(const store::MainVote& vote, const std::string& what) {
    const auto found = std::ranges::find(vote.frames, what, &store::Frame::what);
    return found == vote.frames.end() ? nullptr : &*found;
}

/// What the disk itself takes: a page added to a file, and synced.
std::vector<double> synced_writes(const std::filesystem::path& file) {
    const std::string page(4096, 'x');
    const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    std::vector<double> times;
    for (int i = 0; i < 120; ++i) {
        const auto begin = now();
        if (write(descriptor, page.data(), page.size()) != 4096 || fdatasync(descriptor) != 0)
            break;
        times.push_back(in_ms(now() - begin));
        std::this_thread::sleep_for(20ms);
    }
    close(descriptor);
    return times;
}

/// A study of 120 pairs, with the grey of a real one.
void write_study(const std::filesystem::path& folder) {
    write_small_study(folder);
    auto text = read_file(folder / "study.toml");
    const auto replace = [&](const std::string& old, const std::string& other) {
        text.replace(text.find(old), old.size(), other);
    };
    replace("grey_ms    = 100", fmt::format("grey_ms    = {}", grey_ms));
    replace("warm_ups   = 3", "warm_ups   = 3\nrepetitions = 20\nbreak_every = 0");
    write_file(folder / "study.toml", text);
}

/// Sits through it, and says when each answer's key was sent.
std::vector<std::int64_t> sit_through(const TemporaryFolder& study) {
    RunningProgram program({PAIRLIGHT_PROGRAM, "session", study.path().string(), "--observer", "P1",
                            "--window", "1280x800"},
                           study / "stderr");
    Typist typist;
    std::vector<std::int64_t> sent;
    while (program.is_running()) {
        sent.push_back(now());
        typist.press("Left");
        std::this_thread::sleep_for(70ms);
        for (const auto* key : {"space", "F9"})
            typist.press(key);
        std::this_thread::sleep_for(30ms);
    }
    return sent;
}

struct Figures {
    std::vector<double> key_sent_to_seen, key_to_record, record_to_onset, grey_seen, onset_late;
    int too_early = 0; ///< pairs on the screen before the vote before was on the disk
    int in_time = 0;   ///< from record to onset within the grey and one refresh
};

Figures figures_of(const store::Sitting& sitting, const std::vector<std::int64_t>& sent) {
    Figures figures;
    for (const auto& vote : sitting.votes) {
        const auto* pair = frame_of(vote, "pair");
        const auto* grey = frame_of(vote, "grey");
        figures.onset_late.push_back(in_ms(pair->done_ns - pair->due_ns));
        figures.grey_seen.push_back(in_ms(pair->done_ns - grey->done_ns));
        const auto after = std::ranges::upper_bound(sent, vote.key_ns);
        if (after != sent.begin())
            figures.key_sent_to_seen.push_back(in_ms(vote.key_ns - *std::prev(after)));
        if (const auto* stored = frame_of(vote, "stored")) {
            figures.key_to_record.push_back(in_ms(stored->done_ns - stored->due_ns));
            figures.record_to_onset.push_back(in_ms(pair->done_ns - stored->done_ns));
            figures.too_early += stored->done_ns >= pair->done_ns ? 1 : 0;
            figures.in_time += figures.record_to_onset.back() <= grey_ms + refresh_ms ? 1 : 0;
        }
    }
    return figures;
}

} // namespace

int main() {
    const VirtualScreen screen(1280, 800);
    const TemporaryFolder study;
    write_study(study.path());
    print("the disk alone: 4 KiB added to a file and synced", synced_writes(study / "probe"));
    const auto sent = sit_through(study);
    const auto votes = store::open_votes(study / "votes.sqlite");
    if (!votes) {
        fmt::print("{}\n{}\n", votes.error(), read_file(study / "stderr"));
        return 1;
    }
    const auto sitting = **(*votes)->sitting({{"P1"}, 1});
    fmt::print("{}\n", sitting.start.display);
    const auto figures = figures_of(sitting, sent);
    const auto within =
        std::ranges::count_if(figures.key_to_record, [](double ms) { return ms <= refresh_ms; });
    print("key sent by xdotool to key seen", figures.key_sent_to_seen);
    print("key seen to record (10 ms of it for a second answer)", figures.key_to_record);
    print("record to next onset (500 ms of grey in it)", figures.record_to_onset);
    print("grey as seen (500 ms asked for)", figures.grey_seen);
    print("onset after it was due", figures.onset_late);
    fmt::print("key to record within one refresh of 60 Hz: {} of {}\n", within,
               figures.key_to_record.size());
    fmt::print("pairs shown before the vote before was on disk: {}\n", figures.too_early);
    fmt::print("record to onset within grey and one refresh of 60 Hz: {} of {}\n", figures.in_time,
               figures.record_to_onset.size());
    return 0;
}
