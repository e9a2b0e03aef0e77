// Instructions that this thread executes, where the machine lets them be counted.
#pragma once

#include <linux/perf_event.h>
#include <sys/ioctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

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
        if (file_ < 0)
            refusal_ = std::strerror(errno);
    }

    ~InstructionCounter() {
        if (file_ >= 0)
            close(file_);
    }

    InstructionCounter(const InstructionCounter&) = delete;
    InstructionCounter& operator=(const InstructionCounter&) = delete;

    void start() const {
        if (file_ < 0)
            return;
        ioctl(file_, PERF_EVENT_IOC_RESET, 0);
        ioctl(file_, PERF_EVENT_IOC_ENABLE, 0);
    }

    /// Since the start; nothing where they are not counted.
    std::optional<std::uint64_t> stop() const {
        std::uint64_t counted = 0;
        if (file_ < 0)
            return std::nullopt;
        ioctl(file_, PERF_EVENT_IOC_DISABLE, 0);
        if (read(file_, &counted, sizeof(counted)) != sizeof(counted))
            return std::nullopt;
        return counted;
    }

    std::string what_it_says() const {
        return file_ >= 0 ? "counted by the processor (perf_event_open)"
                          : "not counted: perf_event_open was refused (" + refusal_ + ")";
    }

  private:
    int file_ = -1;
    std::string refusal_;
};

} // namespace bench
