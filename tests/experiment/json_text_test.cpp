#include "experiment/json_text.h"

namespace {

using namespace experiment;
using testing::HasSubstr;
using testing::Not;

std::string complaint(std::string_view text) {
    const auto json = read_json(text, "f.json");
    return json ? "" : json.error();
}

/// What reading the outermost value so says.
template <class Read>
std::string misfit(std::string_view text, Read read) {
    const auto value = read_json_as(text, "f.json", "mend it", [&](const JsonPlace& json) {
        read(json);
        return true;
    });
    return value ? "" : value.error();
}

TEST(JsonText, IsReadWithItsLines) {
    const auto json = read_json("\xEF\xBB\xBF{\r\n  \"a\": [1,\r\n    -2.5,\r\n    3\r\n  ],\r\n"
                                "  \"b\": {\"c\": \"text\", \"d\": true}\r\n}\r\n",
                                "f.json");
    ASSERT_TRUE(json) << json.error();
    const JsonPlace place(*json, "");
    const auto a = place.at("a").elements();
    ASSERT_EQ(a.size(), 3U);
    EXPECT_EQ(a[0].count(), 1);
    EXPECT_EQ(a[1].number(), -2.5);
    EXPECT_EQ(place.at("b").at("c").text(), "text");
    EXPECT_TRUE(place.at("b").has("d"));
    EXPECT_FALSE(place.at("b").has("e"));
    const auto& members = std::get<std::vector<JsonMember>>(json->value);
    EXPECT_EQ(members[1].value.line, 6);
    const auto& list = std::get<std::vector<JsonValue>>(members[0].value.value);
    EXPECT_EQ(list[0].line, 2);
    EXPECT_EQ(list[2].line, 4); // the line end behind a number is read with it
}

TEST(JsonText, SaysInItsOwnWordsWhereItIsDamaged) {
    EXPECT_EQ(complaint(""), "f.json:1: the file is empty");
    EXPECT_EQ(complaint(" \r\n"), "f.json:1: the file is empty");
    EXPECT_EQ(complaint("{"), "f.json:1: the JSON ends before it is complete");
    EXPECT_EQ(complaint("{\"a\": 1,\n\"b"), "f.json:2: the JSON ends before it is complete");
    EXPECT_EQ(complaint("{\n\"a\": x}"), "f.json:2: not JSON from 'x}' on, byte 8 of the file");
    EXPECT_EQ(complaint("<html>"), "f.json:1: not JSON from '<html>' on, byte 1 of the file");
    EXPECT_THAT(complaint("{} {}"), HasSubstr("not JSON from '{}' on, byte 4"));
    EXPECT_EQ(complaint("{\n\"a\": 1e999}"), "f.json:2: 1e999 is beyond all numbers that can be "
                                             "held");
    for (const auto* text : {"{", "[1,", "{\"a\"}", "nul", "\"\\q\"", "01", "{\"a\": 1e999}"})
        EXPECT_THAT(complaint(text), Not(HasSubstr("exception"))) << text;
}

TEST(JsonText, RefusesWhatWouldBeMisread) {
    EXPECT_EQ(complaint("{\"a\": 1,\n \"b\": {\"a\": 2},\n \"a\": 3}"),
              "f.json:3: 'a' stands twice in one object, expected it once");
    EXPECT_EQ(complaint(std::string_view("{}\n\0{}", 6)),
              "f.json:2: a zero byte, which no text holds");
    EXPECT_EQ(complaint("{\"a\": \"\xFF\"}"), "f.json:1: a byte that is no UTF-8");
    // so deep that dropping it level by level would end the program
    EXPECT_EQ(complaint(std::string(1000000, '[')),
              "f.json:1: more than 64 levels of lists and objects");
}

TEST(JsonText, NamesTheWayToWhatIsNotWhatIsWanted) {
    const auto* text = "{\"a\": [1,\n {\"b\": -5}]}";
    EXPECT_EQ(misfit(text, [](const JsonPlace& j) { j.at("a").elements()[1].at("b").count(); }),
              "f.json:2: a[1].b is -5, expected a whole number from 0; mend it");
    EXPECT_EQ(misfit(text, [](const JsonPlace& j) { j.at("a").elements()[1].at("c"); }),
              "f.json:2: there is no a[1].c; mend it");
    EXPECT_EQ(misfit(text, [](const JsonPlace& j) { j.at("a").text(); }),
              "f.json:1: a is a list, expected a text in quotes; mend it");
    EXPECT_EQ(misfit("[]", [](const JsonPlace& j) { j.at("a"); }),
              "f.json:1: the outermost value is a list, expected an object in braces; mend it");
    EXPECT_EQ(misfit("{\"a\": 1.5}", [](const JsonPlace& j) { j.at("a").count(); }),
              "f.json:1: a is 1.5, expected a whole number from 0; mend it");
    EXPECT_EQ(misfit("{\"a\": 99999999999}", [](const JsonPlace& j) { j.at("a").count(); }),
              "f.json:1: a is 99999999999, expected a whole number from 0 to 2147483647; mend it");
    EXPECT_EQ(misfit("{\"a\": 99999999999}",
                     [](const JsonPlace& j) { EXPECT_EQ(j.at("a").size(), 99999999999U); }),
              "");
    // with a sign or without, 0 is 0
    EXPECT_EQ(misfit("{\"a\": -0}", [](const JsonPlace& j) { EXPECT_EQ(j.at("a").count(), 0); }),
              "");
    EXPECT_EQ(misfit("{\"a\": -1}", [](const JsonPlace& j) { j.at("a").size(); }),
              "f.json:1: a is -1, expected a whole number from 0; mend it");
    EXPECT_EQ(misfit("{\"a\": null}", [](const JsonPlace& j) { j.at("a").number(); }),
              "f.json:1: a is null, expected a number; mend it");
}

} // namespace
