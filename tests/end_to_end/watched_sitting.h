// A sitting of the small study in the real window, its keys pressed from outside and its record
// read meanwhile.
#pragma once

#include "experiment/store/records.h"
#include "tests/end_to_end/program.h"
#include "tests/end_to_end/small_study.h"
#include "tests/end_to_end/virtual_screen.h"

#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>

namespace tests {

class WatchedSitting : public testing::Test {
  protected:
    void SetUp() override { write_small_study(study.path()); }

    RunningProgram sitting(const std::string& err = "stderr") const;

    /// What is on record so far; empty before the beginning.
    std::optional<experiment::store::Sitting> record() const;
    std::size_t votes() const;
    bool has_event(const std::string& kind) const;

    /// Presses what a sitting waits for until `done`, two minutes at most.
    template <class Done>
    bool press_on(RunningProgram& program, Done done) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (program.is_running() && !done() && std::chrono::steady_clock::now() < end)
            for (const auto* key : {"space", "F9", "Left"})
                screen.press(key);
        return done() || !program.is_running();
    }

    bool press_to_the_end(RunningProgram& program) {
        return press_on(program, [] { return false; });
    }

    /// Finished, every pair answered once, and the record whole.
    void expect_whole_sitting() const;

    VirtualScreen screen{800, 600};
    TemporaryFolder study;
};

} // namespace tests
