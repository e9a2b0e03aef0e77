// Instructions that a piece of work executes: counted by the processor, and where that is refused,
// as it is in many a virtual machine, step by step.
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <optional>

namespace bench {

class InstructionCounter {
  public:
    InstructionCounter() {
        perf_event_attr wanted{};
        wanted.type = PERF_TYPE_HARDWARE;
        wanted.size = sizeof(wanted);
        wanted.config = PERF_COUNT_HW_INSTRUCTIONS;
        wanted.disabled = 1;
        wanted.exclude_kernel = 1;
        wanted.exclude_hv = 1;
        file_ = static_cast<int>(syscall(SYS_perf_event_open, &wanted, 0, -1, -1, 0));
    }

    ~InstructionCounter() {
        if (file_ >= 0)
            close(file_);
    }

    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    /// Of `work`, done once by this thread; nothing where neither way is allowed.
    template <class Work>
    std::optional<std::uint64_t> count(Work work) const {
        const auto all = file_ >= 0 ? counted(work) : stepped(work);
        const auto none = file_ >= 0 ? counted([] {}) : stepped([] {});
        return all && none ? std::optional(*all - *none) : std::nullopt;
    }

    const char* way() const {
        return file_ >= 0 ? "counted by the processor" : "counted step by step";
    }

  private:
    template <class Work>
    std::optional<std::uint64_t> counted(Work work) const {
        std::uint64_t instructions = 0;
        ioctl(file_, PERF_EVENT_IOC_RESET, 0);
        ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
        work();
        ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
        if (read(file_, &instructions, sizeof(instructions)) != sizeof(instructions))
            return std::nullopt;
        return instructions;
    }

    /// A copy of the process does the work between two stops, and is let go one step at a time:
    /// some twenty microseconds an instruction, the same number every time.
    template <class Work>
    static std::optional<std::uint64_t> stepped(Work work) {
        const pid_t copy = fork();
        if (copy == 0) {
            if (ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
                _exit(1);
            raise(SIGSTOP);
            work();
            raise(SIGSTOP);
            _exit(0);
        }
        int status = 0;
        waitpid(copy, &status, 0);
        if (!WIFSTOPPED(status)) // it may not be traced
            return std::nullopt;
        std::uint64_t steps = 0;
        do {
            ++steps;
            ptrace(PTRACE_SINGLESTEP, copy, nullptr, nullptr);
            waitpid(copy, &status, 0);
        } while (WIFSTOPPED(status) && WSTOPSIG(status) == SIGTRAP);
        const bool is_done = WIFSTOPPED(status) && WSTOPSIG(status) == SIGSTOP;
        if (!is_done && !WIFSTOPPED(status))
            return std::nullopt;
        kill(copy, SIGKILL);
        waitpid(copy, nullptr, 0);
        return is_done ? std::optional(steps) : std::nullopt;
    }

    int file_ = -1;
};

} // namespace bench
