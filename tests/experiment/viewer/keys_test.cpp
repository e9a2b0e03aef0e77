#include "experiment/viewer/keys.h"

#include <fstream>
#include <set>
#include <string>

namespace {

using namespace experiment::viewer;

TEST(KeyTable, GivesNoStrokeTwoMeanings) {
    std::set<std::string> seen;
    for (const auto& row : key_table())
        for (const auto& [stroke, input] : row.strokes)
            EXPECT_TRUE(seen.insert(stroke).second) << stroke;
    EXPECT_GT(seen.size(), 30U);
}

TEST(KeyTable, FindsAStrokeAndNothingForOthers) {
    const auto walk = input_of("Left");
    ASSERT_TRUE(walk);
    EXPECT_LT(std::get<WalkEye>(*walk).right_degrees, 0);
    const auto light = input_of("Shift+Up");
    ASSERT_TRUE(light);
    EXPECT_GT(std::get<TurnLight>(*light).up_degrees, 0);
    EXPECT_EQ(std::get<Choose>(*input_of("9")).choice, 8U);
    EXPECT_FALSE(input_of("Q"));
    EXPECT_FALSE(input_of(""));
}

// A kind of input without a key would be out of reach for who has no mouse.  Setting a dial to a
// value and activating a side are what the panel's controls do in one step; keys get there by
// steps.
TEST(KeyTable, ReachesEveryKindOfInputAndEveryCommand) {
    std::set<std::size_t> kinds;
    std::set<Command> commands;
    for (const auto& row : key_table())
        for (const auto& [stroke, input] : row.strokes) {
            kinds.insert(input.index());
            if (const auto* command = std::get_if<Command>(&input))
                commands.insert(*command);
        }
    EXPECT_EQ(kinds.size(), std::variant_size_v<Input> - 2);
    for (const auto command : {Command::OtherSide, Command::Split, Command::Home, Command::Help,
                               Command::Panel, Command::TakePicture, Command::Quit})
        EXPECT_TRUE(commands.contains(command));
}

TEST(KeyTable, IsTheOneInTheManual) {
    std::ifstream manual(PAIRLIGHT_SOURCE_DIR "/docs/view.md");
    std::vector<std::string> rows;
    for (std::string line; std::getline(manual, line);)
        if (line.starts_with("| `"))
            rows.push_back(line);
    std::vector<std::string> expected;
    for (const auto& row : key_table())
        expected.push_back("| `" + row.keys + "` | " + row.does + " |");
    EXPECT_EQ(rows, expected);
}

} // namespace
