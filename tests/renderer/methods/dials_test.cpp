#include "renderer/methods/catalogue.h"

#include <gmock/gmock.h>

#include <cmath>
#include <set>

namespace {

using namespace renderer::methods;

const std::vector<Dial> some{
    {.name = "bands",
     .meaning = "how many",
     .preset = std::int64_t{5},
     .whole = DialRange<std::int64_t>{1, 6},
     .names = {"auto"}},
    {.name = "width_mm", .meaning = "how wide", .preset = 0.5, .number = DialRange<double>{0, 2}},
    {.name = "law", .meaning = "which", .preset = "a", .names = {"a", "b"}}};

std::string problem(const Dials& given) {
    const auto dials = complete(some, given);
    return dials ? "none" : dials.error().dial + " " + dials.error().what;
}

TEST(Dials, HaveTheirPresetsWhereNobodySays) {
    const auto dials = complete(some, {});
    ASSERT_TRUE(dials);
    EXPECT_EQ(whole_in(*dials, "bands"), 5);
    EXPECT_EQ(number_in(*dials, "width_mm"), 0.5);
    EXPECT_EQ(name_in(*dials, "law"), "a");
}

TEST(Dials, TakeNamesBesideNumbers) {
    const auto dials = complete(some, {{"bands", "auto"}});
    ASSERT_TRUE(dials);
    EXPECT_TRUE(is_name(*dials, "bands"));
    EXPECT_FALSE(is_name(*complete(some, {{"bands", std::int64_t{2}}}), "bands"));
}

TEST(Dials, TakeAWholeNumberWhereAnyNumberWillDo) {
    EXPECT_EQ(number_in(*complete(some, {{"width_mm", std::int64_t{2}}}), "width_mm"), 2.0);
}

TEST(Dials, SayWhatTheyCannotBe) {
    EXPECT_EQ(problem({{"bands", std::int64_t{7}}}),
              "bands is 7, expected a whole number from 1 to 6 or \"auto\"");
    EXPECT_EQ(problem({{"bands", 2.5}}),
              "bands is 2.5, expected a whole number from 1 to 6 or \"auto\"");
    EXPECT_EQ(problem({{"width_mm", std::nan("")}}),
              "width_mm is nan, expected a number from 0 to 2");
    EXPECT_EQ(problem({{"law", "c"}}), "law is \"c\", expected one of a, b");
    EXPECT_EQ(problem({{"band", std::int64_t{2}}}),
              "band is no dial of this method, which has bands, width_mm, law");
}

TEST(Catalogue, HasNamesAndPresetsThatItsOwnDialsTake) {
    std::set<std::string> names;
    for (const auto& method : catalogue()) {
        EXPECT_TRUE(names.insert(method.name).second) << method.name;
        EXPECT_FALSE(method.label.empty()) << method.name;
        EXPECT_TRUE(complete_for(method.name, {})) << method.name;
        for (const auto& dial : method.dials)
            EXPECT_FALSE(dial.meaning.empty()) << method.name << ' ' << dial.name;
    }
    EXPECT_GE(names.size(), 4U);
    EXPECT_EQ(find_method("shs"), nullptr);
}

TEST(Dials, AreSweptOneAtATime) {
    const auto settings =
        one_at_a_time({{"bands", {std::int64_t{1}, "auto"}}, {"law", {"b"}}}, {{"width_mm", 2.0}});
    ASSERT_EQ(settings.size(), 3U);
    EXPECT_EQ(settings[0], (Dials{{"bands", std::int64_t{1}}, {"width_mm", 2.0}}));
    EXPECT_EQ(settings[1], (Dials{{"bands", "auto"}, {"width_mm", 2.0}}));
    EXPECT_EQ(settings[2], (Dials{{"law", "b"}, {"width_mm", 2.0}}));
}

TEST(Catalogue, SweepsWhatItsOwnDialsTakeAndOnceOnly) {
    std::size_t swept = 0;
    for (const auto& method : catalogue()) {
        std::set<Dials> seen{*complete_for(method.name, {})};
        for (const auto& changed : method.sweep) {
            const auto dials = complete_for(method.name, changed);
            ASSERT_TRUE(dials) << method.name << ": " << dials.error().dial << ' '
                               << dials.error().what;
            EXPECT_TRUE(seen.insert(*dials).second) << method.name << " twice, or its presets";
            ++swept;
        }
    }
    EXPECT_GE(swept, 40U);
    for (const auto name : {bare_method, exact_method})
        EXPECT_NE(find_method(name), nullptr) << name;
}

TEST(Catalogue, RefusesMoreCoefficientsThanRaysCanCarry) {
    const auto dials = complete_for("shss", {{"directions", std::int64_t{24}}});
    ASSERT_FALSE(dials);
    EXPECT_EQ(dials.error().dial, "directions");
    EXPECT_EQ(dials.error().what,
              "is 24, expected at least 50, two for each coefficient of 5 bands");
}

} // namespace
