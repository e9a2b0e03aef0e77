// What commands ask for is what they get; what they do not ask for is not done.
#include "experiment/commands/command.h"
#include "experiment/commands/command_line.h"

#include <gtest/gtest.h>

namespace {

using namespace experiment::commands;

enum class Taste { Sweet, Sour };

class GivenWords : public testing::Test {
  protected:
    CommandLine line_{"pairlight", "A program for this test"};
    Command program_ = line_.program();
    Command tea_ = program_.add_command("tea", "Makes tea");

    int run(std::vector<const char*> words) {
        words.insert(words.begin(), "pairlight");
        return line_.run(words);
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
        EXPECT_NE(run(words), 0) << testing::PrintToString(words);
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
