#include "analysis/formats/literals.h"

#include <string>

namespace {

using analysis::formats::Literal;
using analysis::formats::read_literal;
using analysis::formats::read_literal_file;

std::string error_of(const std::string& text) {
    const auto value = read_literal(text, "d.py");
    return value ? "no error" : value.error();
}

TEST(Literals, PythonAndJsonMeanTheSame) {
    for (const auto* text :
         {"{'a': [1, -2.5e3, (True, None)], 'b': 'x\\ty'}",
          "{\"a\": [1, -2500, [true, null]], \"b\": \"x\\ty\"}",
          "\xEF\xBB\xBF{ # who\r\n 'a':[+1,-2.5e3,(True,None,),],'b':'x\\ty',}"}) {
        const auto value = read_literal(text, "d.py");
        ASSERT_TRUE(value) << value.error();
        const auto* list = value->find("a");
        ASSERT_NE(list, nullptr);
        EXPECT_EQ(list->items[0].number, 1);
        EXPECT_EQ(list->items[1].number, -2500);
        EXPECT_EQ(list->items[2].items[0].kind, Literal::Kind::Truth);
        EXPECT_EQ(list->items[2].items[1].kind, Literal::Kind::None);
        EXPECT_EQ(value->find("b")->text, "x\ty");
    }
}

TEST(Literals, SignsBeyondLatinAreUtf8) {
    EXPECT_EQ(read_literal("'caf\\u00e9 \\u65e5 \\uD83D\\uDE00 \\U0001F600 \\x41'", "d")->text,
              "caf\u00e9 \u65e5 \U0001F600 \U0001F600 A");
}

TEST(Literals, AScriptIsItsAssignments) {
    const auto file = read_literal_file("# data\nname = 'n'\n\nlist = [1,\n 2]\n", "d.py");
    ASSERT_TRUE(file) << file.error();
    EXPECT_EQ(file->find("name")->text, "n");
    EXPECT_EQ(file->find("list")->items[1].line, 5);
    EXPECT_EQ(read_literal_file("import os\nname = 1\n", "d.py").error(),
              "d.py:1: 'o' after 'import', expected =");
    EXPECT_EQ(read_literal_file("name = open('x')\n", "d.py").error(),
              "d.py:1: 'open', expected a value: a number, a text in quotes, a list or a map");
}

TEST(Literals, FaultsAreNamedByTheirLine) {
    EXPECT_EQ(error_of(""), "d.py:1: the file ends, expected a value");
    EXPECT_EQ(error_of("[1,\n2"), "d.py:2: the file ends, expected a comma or ]");
    EXPECT_EQ(error_of("{'a'\n 1}"), "d.py:2: '1', expected a colon after a key");
    EXPECT_EQ(error_of("[1 2]"), "d.py:1: '2', expected a comma or ]");
    EXPECT_EQ(error_of("'a\nb'"), "d.py:1: a text that does not close its quotes on its line");
    EXPECT_EQ(error_of("'\\q'"), "d.py:1: a backslash before what is no sign");
    EXPECT_EQ(error_of("'\\uD83D'"), "d.py:1: a backslash before what is no sign");
    EXPECT_EQ(error_of("1.2.3"), "d.py:1: a number that cannot be read");
    EXPECT_EQ(error_of("1e999"), "d.py:1: a number that cannot be read");
    EXPECT_EQ(error_of("[1]\n]"), "d.py:2: ']' after the end");
    EXPECT_EQ(error_of(std::string("\x01", 1)), "d.py:1: byte 1, expected a value");
    EXPECT_EQ(error_of(std::string(100000, '[')), "d.py:1: more than 100 brackets in one another");
}

} // namespace
