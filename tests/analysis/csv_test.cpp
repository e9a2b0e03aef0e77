#include "analysis/csv.h"

#include <vector>

namespace {

using Rows = std::vector<std::vector<std::string>>;

Rows read(std::string_view text, std::string& error) {
    Rows rows;
    const auto result = analysis::read_csv(
        text, "f.csv", [&](std::int64_t, std::span<const std::string_view> fields) {
            rows.emplace_back(fields.begin(), fields.end());
            return std::string();
        });
    error = result ? "" : result.error();
    return rows;
}

TEST(Csv, ReadsQuotesLineEndsAndTheByteOrderMark) {
    std::string error;
    EXPECT_EQ(read("\xEF\xBB\xBF"
                   "a,\"b,\"\"c\"\"\"\r\n\r\n\"two\nlines\",\n,last",
                   error),
              (Rows{{"a", "b,\"c\""}, {"two\nlines", ""}, {"", "last"}}));
    EXPECT_EQ(error, "");
}

TEST(Csv, NamesTheLineOfAQuoteThatDoesNotEnd) {
    std::string error;
    read("a\n\"x\ny\"\nb,\"c", error);
    EXPECT_EQ(error, "f.csv:4: a quoted field does not end, expected a closing \"");
}

TEST(Csv, RefusesTextAfterAClosingQuote) {
    std::string error;
    read("\"a\"b\n", error);
    EXPECT_EQ(error, "f.csv:1: 'b' after a closing quote, expected a comma or the end of the line");
}

TEST(Csv, WhatIsWrittenIsReadBack) {
    std::string error;
    for (const std::string field : {"plain", "a,b", "say \"x\"", "two\r\nlines", ""})
        EXPECT_EQ(read(analysis::csv_field(field) + ",z", error), (Rows{{field, "z"}}));
}

} // namespace
