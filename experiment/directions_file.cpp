// The table is read by analysis' CSV reader; here its fields become numbers.
#include "experiment/directions_file.h"

#include "analysis/csv.h"
#include "analysis/utf8.h"
#include "experiment/text_files.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace experiment {

namespace {

using Fields = std::span<const std::string_view>;

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

/// Where x, y and z stand in a row.
std::optional<std::array<std::size_t, 3>> columns(Fields header) {
    std::array<std::size_t, 3> found{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto place = std::ranges::find(header, axes[axis]);
        if (std::ranges::count(header, axes[axis]) != 1)
            return std::nullopt;
        found[axis] = static_cast<std::size_t>(place - header.begin());
    }
    return found;
}

std::optional<double> number(std::string_view field) {
    double value = 0;
    const auto* end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    return error == std::errc() && stop == end ? std::optional(value) : std::nullopt;
}

class DirectionTable {
  public:
    /// What is wrong with a row; "" when nothing is.
    std::string take(Fields fields) {
        if (!columns_) {
            columns_ = columns(fields);
            in_header_ = fields.size();
            return columns_ ? "" : "the header row has to name the columns x, y and z, each once";
        }
        if (fields.size() != in_header_)
            return fmt::format("{} fields, expected {} as in the header", fields.size(),
                               in_header_);
        glm::dvec3 direction{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto field = fields[(*columns_)[axis]];
            const auto value = number(field);
            if (!value)
                return fmt::format("{} is \"{}\", expected a number", axes[axis], field);
            direction[static_cast<int>(axis)] = *value;
        }
        const double length = glm::length(direction);
        if (!(std::abs(length - 1.0) <= 1e-6))
            return fmt::format("the vector's length is {}, expected 1 (a unit vector)", length);
        directions.push_back(direction);
        return "";
    }

    std::vector<glm::dvec3> directions;

  private:
    std::optional<std::array<std::size_t, 3>> columns_;
    std::size_t in_header_ = 0;
};

} // namespace

tl::expected<std::vector<glm::dvec3>, std::string>
read_directions(const std::filesystem::path& file) {
    const auto text = read_text_file(file);
    if (!text)
        return tl::unexpected(text.error());
    if (const auto fault = analysis::utf8_fault(*text, file.string()); !fault.empty())
        return tl::unexpected(fault);
    DirectionTable table;
    const auto read = analysis::read_csv(
        *text, file.string(), [&](std::int64_t, Fields fields) { return table.take(fields); });
    if (!read)
        return tl::unexpected(read.error());
    if (table.directions.empty())
        return tl::unexpected(
            fmt::format("{}: has no directions, expected a header row x,y,z and a unit vector "
                        "in each row below",
                        file.string()));
    return table.directions;
}

} // namespace experiment
