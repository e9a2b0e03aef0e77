#include "experiment/report/html.h"

namespace {

using namespace experiment::report;

TEST(Html, EscapesEverythingThatMeansSomething) {
    EXPECT_EQ(escaped("<script>alert(\"a & b\")</script>'"),
              "&lt;script&gt;alert(&quot;a &amp; b&quot;)&lt;/script&gt;&#39;");
    EXPECT_EQ(escaped("\u03b7\u00b2 of 50\u00a0%"), "\u03b7\u00b2 of 50\u00a0%");
    EXPECT_EQ(escaped(""), "");
}

// The test vectors of RFC 4648, section 10, and a byte with its highest bit set.
TEST(Html, AddressesHoldBytesInBase64) {
    const std::vector<std::pair<std::string, std::string>> vectors{{"", ""},
                                                                   {"f", "Zg=="},
                                                                   {"fo", "Zm8="},
                                                                   {"foo", "Zm9v"},
                                                                   {"foob", "Zm9vYg=="},
                                                                   {"fooba", "Zm9vYmE="},
                                                                   {"foobar", "Zm9vYmFy"},
                                                                   {"\xff\xfe", "//4="}};
    for (const auto& [bytes, text] : vectors)
        EXPECT_EQ(data_address("image/png", bytes), "data:image/png;base64," + text);
}

TEST(Html, MarksAreFilledOnceAndValuesAreNotLookedInto) {
    EXPECT_EQ(filled("a {{x}} b {{y}} {{x}}", {{"x", "{{y}}"}, {"y", "2"}}), "a {{y}} b 2 {{y}}");
    EXPECT_EQ(filled("no marks", {}), "no marks");
}

TEST(HtmlDeathTest, EveryMarkHasAValue) {
    EXPECT_DEATH(filled("{{missing}}", {}), "expected value != values.end");
}

TEST(Html, TheFirstCellOfARowIsItsHead) {
    EXPECT_EQ(html_row({"a", "1"}), "<tr><th scope=\"row\">a</th><td>1</td></tr>\n");
}

} // namespace
