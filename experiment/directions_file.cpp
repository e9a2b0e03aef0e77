// The table is read by analysis' CSV reader; here its fields become numbers.
#include "experiment/directions_file.h"

#include "analysis/csv.h"
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
        if (place == header.end())
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
            return columns_ ? "" : "the header row has to name the columns x, y and z";
        }
        glm::dvec3 direction{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto place = (*columns_)[axis];
            const auto value = place < fields.size() ? number(fields[place]) : std::nullopt;
            if (!value)
                return fmt::format("{} is not a number: \"{}\"", axes[axis],
                                   place < fields.size() ? fields[place] : "");
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
};

} // namespace

tl::expected<std::vector<glm::dvec3>, std::string>
read_directions(const std::filesystem::path& file) {
    const auto text = read_text_file(file);
    if (!text)
        return tl::unexpected(text.error());
    DirectionTable table;
    const auto read = analysis::read_csv(
        *text, file.string(), [&](std::int64_t, Fields fields) { return table.take(fields); });
    if (!read)
        return tl::unexpected(read.error());
    if (table.directions.empty())
        return tl::unexpected(fmt::format("{}: has no directions", file.string()));
    return table.directions;
}

} // namespace experiment
