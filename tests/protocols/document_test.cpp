#include "protocols/document.h"

namespace {

using namespace protocols;
using testing::HasSubstr;
using testing::StartsWith;

std::string complaint(std::string_view text) {
    const auto table = read_document(text, "s.toml");
    return table ? "" : table.error();
}

std::string many(const std::string& part, int times) {
    std::string text;
    for (int i = 0; i < times; ++i)
        text += part;
    return text;
}

TEST(Document, SaysWhereItIsNoTomlAndWhatToDo) {
    EXPECT_THAT(complaint("a = 1\nb = = 2\n"), AllOf(StartsWith("s.toml:2: not TOML: "),
                                                     HasSubstr("; mend this line, expected ")));
    EXPECT_THAT(complaint("a = 1\na = 2\n"), StartsWith("s.toml:2: not TOML: "));
    EXPECT_THAT(complaint("[a]\n[a]\n"), StartsWith("s.toml:2: not TOML: "));
    EXPECT_THAT(complaint("a = 99999999999999999999\n"), StartsWith("s.toml:1: not TOML: "));
    EXPECT_THAT(complaint("a = 1e999\n"), StartsWith("s.toml:1: not TOML: "));
    EXPECT_THAT(complaint(std::string_view("a = 1\n\0", 7)), StartsWith("s.toml:2: not TOML: "));
    EXPECT_THAT(complaint("a = \"\xFF\"\n"), StartsWith("s.toml:1: not TOML: "));
}

TEST(Document, ReadsByteOrderMarksAndOtherLineEnds) {
    const auto table = read_document("\xEF\xBB\xBF"
                                     "a = 1\r\nb = 2\r\n",
                                     "s.toml");
    ASSERT_TRUE(table) << table.error();
    ASSERT_EQ(table->size(), 2U);
    EXPECT_EQ(table->at(0).key, "a");
    EXPECT_EQ(table->at(1).line, 2);
}

// Tables in tables are dropped one within the other: enough of them would end the program.
TEST(Document, RefusesKeysOfAnyNumberOfParts) {
    constexpr const char* why = ": a key of more than 64 parts, expected key = value";
    EXPECT_EQ(complaint("b = 1\na" + many(".a", 30000) + " = 1\n"), std::string("s.toml:2") + why);
    EXPECT_EQ(complaint("[a" + many(" . \"a\"", 30000) + "]\n"), std::string("s.toml:1") + why);
    EXPECT_EQ(complaint("b = { a" + many(".a", 30000) + " = 1 }\n"), std::string("s.toml:1") + why);
    EXPECT_EQ(complaint("a" + many(".a", 60) + " = 1\n"), "");
    EXPECT_THAT(complaint("a = " + many("[", 100000)), HasSubstr("not TOML"));
    // dots that part nothing
    EXPECT_EQ(complaint("a = \"" + many(".", 100) + "\\\"" + many(".", 100) + "\"\n# " +
                        many(".", 100) + "\nb = '" + many(".", 100) + "'\n"),
              "");
}

} // namespace
