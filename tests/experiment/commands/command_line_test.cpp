// What commands ask for is what they get; what they do not ask for is not done.
#include "experiment/commands/command.h"
#include "experiment/commands/command_line.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace {

using namespace experiment::commands;
using testing::HasSubstr;

enum class Taste { Sweet, Sour };

class GivenWords : public testing::Test {
  protected:
    CommandLine line_{"pairlight", "A program for this test", "pairlight 1.2.3"};
    Command program_ = line_.program();
    Command tea_ = program_.add_command("tea", "Makes tea");

    int run(std::vector<const char*> words) {
        words.insert(words.begin(), "pairlight");
        return line_.run(words);
    }

    /// What is said of words that cannot be understood, on standard error or by an exception.
    std::string complaint(const std::vector<const char*>& words) {
        testing::internal::CaptureStderr();
        std::string thrown;
        try {
            EXPECT_EQ(run(words), 1) << testing::PrintToString(words);
        } catch (const CommandError& error) {
            thrown = error.what();
        }
        return testing::internal::GetCapturedStderr() + thrown;
    }
};

TEST_F(GivenWords, AreReadAsTheirOptionsSay) {
    std::string sort;
    int cups = 1;
    std::uint64_t leaves = 1;
    double litres = 1;
    std::array<int, 2> size{};
    std::array<double, 3> place{};
    std::optional<std::string> guest, nobody;
    std::optional<std::array<double, 3>> way;
    std::vector<std::string> spices;
    std::vector<int> minutes{3};
    bool milk = false, sugar = false;
    tea_.add_option("SORT", sort, "");
    tea_.add_option("--cups", cups, "").within(1, 10);
    tea_.add_option("--leaves", leaves, "");
    tea_.add_option("--litres", litres, "");
    tea_.add_option("--size", size, "");
    tea_.add_option("--place", place, "");
    tea_.add_option("--guest", guest, "");
    tea_.add_option("--nobody", nobody, "");
    tea_.add_option("--way", way, "");
    tea_.add_option("--spices", spices, "").separated_by(',');
    tea_.add_option("--minutes", minutes, "");
    tea_.add_flag("-m,--milk", milk, "");
    tea_.add_flag("--sugar", sugar, "");
    ASSERT_EQ(run({"tea",
                   "oolong",
                   "--cups",
                   "10",
                   "--leaves",
                   "18446744073709551615",
                   "--litres",
                   "0.5",
                   "--size",
                   "3",
                   "4",
                   "--place",
                   "1",
                   "-2",
                   "3e1",
                   "--guest",
                   "Ann",
                   "--way",
                   "0",
                   "0",
                   "-1",
                   "--spices",
                   "clove,cardamom",
                   "--minutes",
                   "4",
                   "5",
                   "-m"}),
              0);
    EXPECT_EQ(sort, "oolong");
    EXPECT_EQ(cups, 10);
    EXPECT_EQ(leaves, 18446744073709551615U);
    EXPECT_EQ(litres, 0.5);
    EXPECT_EQ(size, (std::array{3, 4}));
    EXPECT_EQ(place, (std::array{1.0, -2.0, 30.0}));
    EXPECT_EQ(guest, "Ann");
    EXPECT_FALSE(nobody.has_value());
    EXPECT_EQ(way, (std::array{0.0, 0.0, -1.0}));
    EXPECT_EQ(spices, (std::vector<std::string>{"clove", "cardamom"}));
    EXPECT_EQ(minutes, (std::vector{4, 5}));
    EXPECT_TRUE(milk);
    EXPECT_FALSE(sugar);
}

TEST_F(GivenWords, SpellNumbersInDecimalDigits) {
    int cups = 1;
    std::uint64_t leaves = 1;
    double litres = 1;
    std::array<int, 2> size{};
    tea_.add_option("--cups", cups, "").within(1, 1000);
    tea_.add_option("--leaves", leaves, "");
    tea_.add_option("--litres", litres, "");
    tea_.add_option("--size", size, "");
    ASSERT_EQ(run({"tea", "--cups", "0150", "--leaves", "010", "--litres", "010.5", "--size", "+08",
                   "-09"}),
              0);
    EXPECT_EQ(cups, 150);
    EXPECT_EQ(leaves, 10U);
    EXPECT_EQ(litres, 10.5);
    EXPECT_EQ(size, (std::array{8, -9}));
    EXPECT_THAT(complaint({"tea", "--cups", "0x2"}),
                HasSubstr("--cups: 0x2 is not a whole number from 1 to 1000"));
    EXPECT_THAT(complaint({"tea", "--cups", "t.csv"}),
                HasSubstr("--cups: t.csv is not a whole number from 1 to 1000"));
    EXPECT_THAT(complaint({"tea", "--cups", "0"}),
                HasSubstr("--cups: 0 is not a number from 1 to 1000"));
    EXPECT_THAT(complaint({"tea", "--leaves", "0x2"}), HasSubstr("--leaves: 0x2 is not a whole"));
    for (const auto* litre : {"0x2", "1,5", "nan", "inf", "1e999", "", " 1", "1l"})
        EXPECT_THAT(complaint({"tea", "--litres", litre}),
                    HasSubstr(std::string("--litres: ") + litre + " is not a number"));
}

TEST_F(GivenWords, AreNotBentIntoWhatANumberCanHold) {
    int cups = 1;
    std::uint64_t leaves = 1;
    tea_.add_option("--cups", cups, "");
    tea_.add_option("--leaves", leaves, "");
    for (const auto* number : {"-1", "-0", "18446744073709551616", "1.0", "1e3", ""})
        EXPECT_THAT(complaint({"tea", "--leaves", number}),
                    HasSubstr(std::string("--leaves: ") + number +
                              " is not a whole number from 0 to 18446744073709551615"));
    EXPECT_THAT(complaint({"tea", "--cups", "2147483648"}),
                HasSubstr("2147483648 is not a whole number from -2147483648 to 2147483647"));
    EXPECT_EQ(run({"tea", "--leaves", "18446744073709551615", "--cups", "-2147483648"}), 0);
    EXPECT_EQ(leaves, 18446744073709551615U);
    EXPECT_EQ(cups, std::numeric_limits<int>::min());
}

TEST_F(GivenWords, SaySomethingUnlessNothingHasAMeaning) {
    std::string sort, guest = "nobody", wish = "none", folder;
    std::optional<std::string> host;
    std::vector<std::string> spices;
    auto taste = Taste::Sour;
    tea_.add_option("SORT", sort, "");
    tea_.add_option("--guest", guest, "");
    tea_.add_option("--wish", wish, "").may_be_empty();
    tea_.add_option("--host", host, "");
    tea_.add_option("--spices", spices, "");
    tea_.add_option("--folder", folder, "").not_blank("a folder");
    tea_.add_choice("--taste", taste, "", {{"sweet", Taste::Sweet}, {"sour", Taste::Sour}});
    for (const auto* option : {"--guest", "--host", "--spices"})
        EXPECT_THAT(complaint({"tea", option, ""}),
                    HasSubstr(std::string(option) + ": \"\" says nothing, expected a text; "
                                                    "`pairlight tea --help` lists the options"));
    EXPECT_THAT(complaint({"tea", ""}), HasSubstr("SORT: \"\" says nothing, expected a text"));
    EXPECT_THAT(complaint({"tea", "--folder", ""}),
                HasSubstr("--folder: \"\" says nothing, expected a folder"));
    EXPECT_THAT(complaint({"tea", "--taste", ""}), HasSubstr("--taste: '', expected one of"));
    EXPECT_THAT(complaint({"tea", "--spices", "clove", ""}), HasSubstr("--spices: \"\" says"));
    EXPECT_EQ(run({"tea", "--wish", ""}), 0);
    EXPECT_EQ(wish, "");
}

TEST_F(GivenWords, BehindAnEqualsSignAreTheFirstValue) {
    std::array<double, 3> place{};
    std::string sort, cup;
    bool milk = false;
    tea_.add_option("SORT", sort, "");
    tea_.add_option("--place", place, "");
    tea_.add_option("--cup", cup, "");
    tea_.add_flag("-m,--milk", milk, "");
    EXPECT_EQ(complaint({"tea", "--cup=", "oolong"}), "--cup=: no value given, expected 1");
    EXPECT_EQ(complaint({"tea", "--place=", "1", "2", "3"}),
              "--place=: no value given, expected 3");
    EXPECT_EQ(complaint({"tea", "--place=0"}), "--place=0: 1 value given, expected 3");
    EXPECT_EQ(complaint({"tea", "--place=0", "1", "--cup", "c"}),
              "--place=0 1: 2 values given before --cup, expected 3");
    EXPECT_EQ(complaint({"tea", "--milk=maybe"}), "--milk=maybe: --milk takes no value");
    EXPECT_EQ(complaint({"tea", "-m=true"}), "-m=true: -m takes no value");
    EXPECT_EQ(complaint({"tea", "--milk="}), "--milk=: --milk takes no value");
    ASSERT_EQ(run({"tea", "--place=0", "1", "2", "--cup=a=b", "oolong"}), 0);
    EXPECT_EQ(place, (std::array{0.0, 1.0, 2.0}));
    EXPECT_EQ(cup, "a=b");
    EXPECT_EQ(sort, "oolong");
}

TEST_F(GivenWords, ThatNobodyExpectsAreNamed) {
    std::string sort, milk;
    int cups = 1;
    bool sugar = false;
    std::vector<std::string> spices;
    tea_.add_option("SORT", sort, "");
    tea_.add_option("--milk-of", milk, "");
    tea_.add_option("--cups", cups, "");
    tea_.add_option("--spices", spices, "");
    tea_.add_flag("--sugar", sugar, "");
    EXPECT_EQ(complaint({"tea", "oolong", "--cusp", "3"}),
              "pairlight: there is no option '--cusp' (did you mean '--cups'?); `pairlight tea "
              "--help` lists the options\n");
    EXPECT_THAT(complaint({"tea", "--milk=some"}), HasSubstr("(did you mean '--milk-of'?)"));
    EXPECT_THAT(complaint({"tea", "--nothing-like-it"}),
                HasSubstr("there is no option '--nothing-like-it'; `"));
    EXPECT_THAT(complaint({"tea", "oolong", "y", "z"}), HasSubstr("'y z': words more than expec"));
    EXPECT_THAT(complaint({"--bogus"}), HasSubstr("there is no option '--bogus'; `pairlight --h"));
    EXPECT_THAT(complaint({"--bogus", "tea"}), HasSubstr("there is no option '--bogus'"));
    EXPECT_EQ(complaint({"tea", "--cups", "1", "--cups", "2"}),
              "--cups: given twice, expected it once");
    EXPECT_EQ(complaint({"tea", "--sugar", "--sugar"}), "--sugar: given twice, expected it once");
    EXPECT_EQ(run({"tea", "--spices", "clove", "--spices", "cardamom"}), 0);
}

TEST_F(GivenWords, AskForTheVersion) {
    testing::internal::CaptureStdout();
    EXPECT_EQ(run({"--version"}), 0);
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "pairlight 1.2.3\n");
}

TEST_F(GivenWords, StandForValues) {
    auto first = Taste::Sour, second = Taste::Sour;
    const std::map<std::string, Taste> tastes{{"sweet", Taste::Sweet}, {"sour", Taste::Sour}};
    tea_.add_choice("--first", first, "", tastes);
    tea_.add_choice("--second", second, "", tastes);
    ASSERT_EQ(run({"tea", "--first", "sweet"}), 0);
    EXPECT_EQ(first, Taste::Sweet);
    EXPECT_EQ(second, Taste::Sour);
}

TEST_F(GivenWords, ThatCannotBeUnderstoodDoNothing) {
    int cups = 1;
    auto taste = Taste::Sweet;
    std::string reason, folder, milk = "none";
    bool black = false, made = false;
    tea_.add_option("--cups", cups, "").within(1, 10);
    tea_.add_choice("--taste", taste, "", {{"sweet", Taste::Sweet}, {"sour", Taste::Sour}});
    tea_.add_option("--reason", reason, "").not_blank("a reason");
    tea_.add_option("--folder", folder, "").not_standard_output().existing_folder();
    const auto flag = tea_.add_flag("--black", black, "");
    tea_.add_option("--milk", milk, "").one_of({"none", "some"}).excludes(flag);
    tea_.runs([&] { made = true; });
    for (const auto& words :
         std::vector<std::vector<const char*>>{{"tea", "--cups", "11"},
                                               {"tea", "--cups", "nan"},
                                               {"tea", "--cups", "1.5"},
                                               {"tea", "--taste", "1"},
                                               {"tea", "--reason", " \t"},
                                               {"tea", "--folder", "-"},
                                               {"tea", "--folder", "/none"},
                                               {"tea", "--milk", "more"},
                                               {"tea", "--milk", "some", "--black"},
                                               {"tea", "--unknown"},
                                               {}}) {
        EXPECT_EQ(run(words), 1) << testing::PrintToString(words);
        EXPECT_FALSE(made) << testing::PrintToString(words);
    }
    EXPECT_THROW(run({"coffee"}), CommandError);
    EXPECT_EQ(run({"tea", "--milk", "some", "--folder", "/"}), 0);
    EXPECT_TRUE(made);
}

TEST_F(GivenWords, ThatAreNeededMayNotBeMissing) {
    std::string sort;
    tea_.add_option("SORT", sort, "").required();
    EXPECT_NE(run({"tea"}), 0);
    EXPECT_EQ(run({"tea", "--help"}), 0);
}

TEST_F(GivenWords, NameTheInnermostCommandToRun) {
    std::vector<std::string> ran;
    std::string sort;
    tea_.add_option("--sort", sort, "");
    tea_.runs([&] { ran.push_back("tea"); });
    auto iced = tea_.add_command("iced", "With ice");
    iced.runs([&, tea = tea_, iced] {
        EXPECT_EQ(tea.given_options(), std::vector<std::string>{"--sort"});
        ran.push_back(iced.name());
    });
    ASSERT_EQ(run({"tea", "--sort", "oolong", "iced"}), 0);
    EXPECT_EQ(ran, std::vector<std::string>{"iced"});
    ASSERT_EQ(run({"tea"}), 0);
    EXPECT_EQ(ran, (std::vector<std::string>{"iced", "tea"}));
}

TEST_F(GivenWords, ThatWouldChangeNothingAreRefused) {
    bool milk = false;
    double litres = 1;
    tea_.add_flag("--milk", milk, "");
    tea_.add_option("--litres", litres, "");
    tea_.runs([&, tea = tea_] { tea.expect_not_given({"--milk", "--litres"}, "there is none"); });
    EXPECT_EQ(run({"tea"}), 0);
    // one that repeats what holds without it is given, too
    try {
        run({"tea", "--litres", "1"});
        FAIL() << "nothing was refused";
    } catch (const CommandError& error) {
        EXPECT_STREQ(error.what(), "--litres: there is none");
    }
}

} // namespace
