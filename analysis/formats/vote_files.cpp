#include "analysis/formats/vote_files.h"

#include "analysis/csv.h"
#include "analysis/formats/count_files.h"
#include "analysis/formats/sureal_file.h"
#include "analysis/formats/wide_files.h"
#include "analysis/twin_names.h"
#include "analysis/utf8.h"
#include "analysis/vote_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace analysis::formats {

namespace {

// What shows of a file's form: its first row, and how many rows and kinds of cell it has.
struct Shape {
    std::vector<std::string> first;
    std::size_t rows = 0;
    bool first_row_numbers = false;
    bool minus_one = false;
};

bool is_number(std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
}

Expected<Shape> shape_of(std::string_view text, const std::string& name) {
    Shape shape;
    const auto records =
        read_csv(text, name, [&](std::int64_t, std::span<const std::string_view> fields) {
            if (shape.rows++ == 0) {
                shape.first.assign(fields.begin(), fields.end());
                shape.first_row_numbers = std::all_of(fields.begin(), fields.end(), is_number);
            }
            shape.minus_one =
                shape.minus_one || std::find(fields.begin(), fields.end(), "-1") != fields.end();
            return std::string();
        });
    if (!records)
        return tl::unexpected(records.error());
    return shape;
}

bool has(const Shape& shape, std::string_view column) {
    return std::find(shape.first.begin(), shape.first.end(), column) != shape.first.end();
}

bool is_square(std::size_t n) {
    const auto root = static_cast<std::size_t>(std::lround(std::sqrt(n)));
    return n >= 4 && root * root == n;
}

Expected<VoteFormat> format_of_numbers(const Shape& shape, const std::string& name) {
    const auto columns = shape.first.size();
    const bool matrix = columns == shape.rows, pairs = columns == 2;
    const bool observers = is_square(columns);
    if (int(matrix) + int(pairs) + int(observers) != 1)
        return tl::unexpected(
            fmt::format("{}:1: {} rows of {} numbers without a header do not say what they are; "
                        "say --format matrix, pairs or observer-matrices",
                        name, shape.rows, columns));
    return matrix ? VoteFormat::Matrix : pairs ? VoteFormat::Pairs : VoteFormat::ObserverMatrices;
}

// Without a walk through the whole file, which may hold millions of votes.
bool header_of_votes(std::string_view text, const std::string& name) {
    const auto shape = shape_of(text.substr(0, text.find_first_of("\r\n")), name);
    if (!shape)
        return false;
    for (const auto* column : {"left", "left_method", "condition_A", "right", "chosen"})
        if (has(*shape, column))
            return true;
    return false;
}

// A named matrix has the names of its columns again in front of its rows.
Expected<VoteFormat> detect(std::string_view text, const std::string& name) {
    if (header_of_votes(text, name))
        return VoteFormat::Long;
    if (looks_like_sureal(text))
        return VoteFormat::Sureal;
    const auto shape = shape_of(text, name);
    if (!shape)
        return tl::unexpected(shape.error());
    if (shape->rows == 0)
        return VoteFormat::Long; // whose reader says what is wrong
    if (shape->first_row_numbers)
        return format_of_numbers(*shape, name);
    if (has(*shape, "winner") || has(*shape, "player1"))
        return VoteFormat::Pairs;
    if (has(*shape, "max_votes") && has(*shape, "share"))
        return tl::unexpected(
            fmt::format("{}:1: scores do not say who was chosen over whom; export "
                        "the votes with --format long or matrices",
                        name));
    const std::vector<std::string_view> header(shape->first.begin(), shape->first.end());
    if (has_pair_columns(header)) {
        if (shape->minus_one)
            return VoteFormat::PairedComparison;
        return tl::unexpected(
            fmt::format("{}:1: columns of pairs, but no -1 says what 0 means; say "
                        "--format wide (0: the second was chosen) or "
                        "paired-comparison (0: undecided)",
                        name));
    }
    const bool square = shape->rows >= 3 && shape->first.size() == shape->rows;
    return square && !has(*shape, "observer") ? VoteFormat::Matrix : VoteFormat::Long;
}

Expected<VoteTable>
read_as(VoteFormat format, std::string_view text, const std::string& name, Repeats repeats) {
    switch (format) {
    case VoteFormat::Detect:
    case VoteFormat::Long:
        return read_votes_csv(text, name, repeats);
    case VoteFormat::Pairs:
        return read_pair_counts(text, name);
    case VoteFormat::Matrix:
        return read_count_matrix(text, name);
    case VoteFormat::ObserverMatrices:
        return read_observer_matrices(text, name);
    case VoteFormat::Wide:
        return read_wide_votes(text, name, SecondChosen::Zero);
    case VoteFormat::PairedComparison:
        return read_wide_votes(text, name, SecondChosen::MinusOne);
    case VoteFormat::Sureal:
        return read_sureal_data_set(text, name);
    }
    return read_votes_csv(text, name, repeats);
}

} // namespace

Expected<VoteTable>
read_vote_file(std::string_view text, const std::string& name, VoteFormat format, Repeats repeats) {
    if (auto fault = utf8_fault(text, name); !fault.empty())
        return tl::unexpected(std::move(fault));
    if (format == VoteFormat::Detect) {
        const auto detected = detect(text, name);
        if (!detected)
            return tl::unexpected(detected.error());
        format = *detected;
    }
    auto table = read_as(format, text, name, repeats);
    if (!table)
        return table;
    auto twins = twins_but_for_blanks(table->conditions, "conditions");
    if (twins.empty())
        twins = twins_but_for_blanks(table->observers, "observers");
    if (!twins.empty())
        return tl::unexpected(fmt::format("{}: {}", name, twins));
    return table;
}

} // namespace analysis::formats
