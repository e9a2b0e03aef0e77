// A golden CSV with a header row: cells by column name, as text or as long double.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace golden {

class Table {
  public:
    explicit Table(const std::string& name) {
        std::ifstream stream(std::string(PAIRLIGHT_TEST_DATA "/golden/") + name);
        for (std::string line; std::getline(stream, line);) {
            std::vector<std::string> cells;
            std::istringstream in(line);
            for (std::string cell; std::getline(in, cell, ',');)
                cells.push_back(cell);
            (columns_.empty() ? columns_ : rows_.emplace_back()) = cells;
        }
    }

    std::size_t rows() const { return rows_.size(); }

    const std::string& text(std::size_t row, const std::string& column) const {
        const auto found = std::find(columns_.begin(), columns_.end(), column);
        if (found == columns_.end())
            throw std::out_of_range("no column " + column);
        return rows_.at(row).at(static_cast<std::size_t>(found - columns_.begin()));
    }

    /// Correctly rounded to the 80-bit format; 20 digits in the files are more than it holds.
    long double number(std::size_t row, const std::string& column) const {
        const auto& cell = text(row, column);
        char* end = nullptr;
        const long double value = std::strtold(cell.c_str(), &end);
        if (end == cell.c_str() || *end != '\0')
            throw std::invalid_argument(column + ": " + cell + " is not a number");
        return value;
    }

    double argument(std::size_t row, const std::string& column) const {
        return std::strtod(text(row, column).c_str(), nullptr);
    }

  private:
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

inline long double relative_error(double value, long double expected) {
    if (expected == 0)
        return std::abs(static_cast<long double>(value));
    return std::abs((static_cast<long double>(value) - expected) / expected);
}

/// The worst relative error seen in each named region; printed when the test ends.
class Worst {
  public:
    explicit Worst(std::string what) : what_(std::move(what)) {}

    Worst(const Worst&) = delete;
    Worst& operator=(const Worst&) = delete;

    ~Worst() {
        for (const auto& [region, entry] : regions_)
            std::printf("    %s, %s: %d values, worst relative error %.1Le\n", what_.c_str(),
                        region.c_str(), entry.count, entry.worst);
    }

    /// Records and returns the error, NaN as NaN.
    long double see(const std::string& region, double value, long double expected) {
        const long double error = relative_error(value, expected);
        auto& entry = regions_[region];
        ++entry.count;
        if (!(error <= entry.worst))
            entry.worst = error;
        return error;
    }

  private:
    struct Entry {
        int count = 0;
        long double worst = 0;
    };

    std::string what_;
    std::map<std::string, Entry> regions_;
};

} // namespace golden
