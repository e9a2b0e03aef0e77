// What kernel_bench measures, as Markdown.
#pragma once

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace bench {

/// Three cycles; nothing else that is measured waits so plainly for the clock.
inline constexpr const char* clock_row = "a multiplication that waits for the last";

/// What a bare kernel took on an Ice Lake of 2.8 GHz with AVX2, in ns per direction.
inline const std::map<std::string, double> targets{
    {"double, 2 bands", 0.8}, {"double, 3 bands", 1.1}, {"double, 5 bands", 6.5},
    {"double, 10 bands", 21}, {"float, 2 bands", 0.3},  {"float, 3 bands", 0.6},
    {"float, 5 bands", 1.7},  {"float, 10 bands", 11.5}};
inline constexpr double target_clock = 2.8;

/// Medians and spreads over repetitions, as Markdown.
class KernelTable : public benchmark::BenchmarkReporter {
  public:
    /// `counting`: how the instructions come to be known.
    explicit KernelTable(std::string counting) : counting_(std::move(counting)) {}

    /// Rows are printed in the order in which they are added; they run in any.
    void add_row(const std::string& name) { order_.push_back(name); }

    bool has_instructions(const std::string& row) const { return instructions_.contains(row); }

    void set_instructions(const std::string& row, double of_an_item) {
        instructions_[row] = of_an_item;
    }

    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const auto& run : runs) {
            if (run.run_type != Run::RT_Iteration || run.error_occurred)
                continue;
            const auto name = run.run_name.function_name;
            nanoseconds_[name].push_back(1e9 / run.counters.at("items_per_second"));
        }
    }

    void Finalize() override {
        const auto clock = gigahertz();
        fmt::print(
            "{}; {}; medians of {} runs in turns, spread is the largest less the smallest.\n",
            machine(), clock ? fmt::format("{:.2f} GHz while it ran", *clock) : "clock unknown",
            nanoseconds_.empty() ? 0 : nanoseconds_.begin()->second.size());
        fmt::print("Instructions: {}.\n\n", counting_);
        fmt::print("| row | ns | spread | cycles | instructions | cycles aimed at | ratio |\n"
                   "|---|---|---|---|---|---|---|\n");
        for (const auto& name : order_)
            if (nanoseconds_.contains(name))
                print_row(name, clock);
    }

  private:
    static double median(std::vector<double> values) {
        std::sort(values.begin(), values.end());
        return values[values.size() / 2];
    }

    std::optional<double> gigahertz() const {
        if (const auto found = nanoseconds_.find(clock_row); found != nanoseconds_.end())
            return 3 / median(found->second);
        return std::nullopt;
    }

    static std::string machine() {
        std::ifstream file("/proc/cpuinfo");
        for (std::string line; std::getline(file, line);)
            if (line.starts_with("model name"))
                return line.substr(line.find(':') + 2);
        return "processor unknown";
    }

    void print_row(const std::string& name, std::optional<double> clock) const {
        auto values = nanoseconds_.at(name);
        const double middle = median(values);
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        std::string cycles, aimed, ratio, instructions;
        if (clock)
            cycles = fmt::format("{:.3g}", middle * *clock);
        for (const auto& [what, ns] : targets)
            if (clock && name.ends_with(what)) {
                aimed = fmt::format("{:.3g}", ns * target_clock);
                ratio = fmt::format("{:.2f}", middle * *clock / (ns * target_clock));
            }
        if (const auto found = instructions_.find(name); found != instructions_.end())
            instructions = fmt::format("{:.3g}", found->second);
        fmt::print("| {} | {:.3g} | {:.2g} | {} | {} | {} | {} |\n", name, middle, *high - *low,
                   cycles, instructions, aimed, ratio);
    }

    std::string counting_;
    std::vector<std::string> order_;
    std::map<std::string, std::vector<double>> nanoseconds_;
    std::map<std::string, double> instructions_;
};

} // namespace bench
