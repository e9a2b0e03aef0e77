// A step of a key is small enough to aim with and large enough to get somewhere when held.
#include "experiment/viewer/keys.h"

namespace experiment::viewer {

namespace {

constexpr double step_degrees = 5;
constexpr double zoom_step = 1.1;
constexpr double split_step = 0.02;

template <class Turn>
std::vector<std::pair<std::string, Input>> arrows(const std::string& before) {
    return {{before + "Left", Turn{-step_degrees, 0}},
            {before + "Right", Turn{step_degrees, 0}},
            {before + "Up", Turn{0, step_degrees}},
            {before + "Down", Turn{0, -step_degrees}}};
}

std::vector<std::pair<std::string, Input>> digits() {
    std::vector<std::pair<std::string, Input>> strokes;
    for (std::size_t i = 0; i < 9; ++i)
        strokes.emplace_back(std::to_string(i + 1), Choose{i});
    return strokes;
}

std::vector<KeyRow> make_table() {
    return {
        {"arrows", "walk round the model", arrows<WalkEye>("")},
        {"Shift + arrows", "turn the light", arrows<TurnLight>("Shift+")},
        {"+ -", "zoom", {{"+", Zoom{zoom_step}}, {"-", Zoom{1 / zoom_step}}}},
        {"R", "view and light as the scene has them", {{"R", Command::Home}}},
        {"1 to 9", "condition or method of this side", digits()},
        {"M, Shift + M",
         "the next one, the one before",
         {{"M", ChooseNext{1}}, {"Shift+M", ChooseNext{-1}}}},
        {"Tab", "the other side", {{"Tab", Command::OtherSide}}},
        {"S", "both sides, split by a line", {{"S", Command::Split}}},
        {"[ ]", "move the line", {{"[", MoveSplit{-split_step}}, {"]", MoveSplit{split_step}}}},
        {"D, Shift + D",
         "pick the next dial, the one before",
         {{"D", PickDial{1}}, {"Shift+D", PickDial{-1}}}},
        {", .", "turn the dial down, up", {{",", TurnDial{"", -1}}, {".", TurnDial{"", 1}}}},
        {"L", "the other law of attenuation", {{"L", TurnDial{"law", 1}}}},
        {"B, Shift + B",
         "more bands, fewer bands",
         {{"B", TurnDial{"bands", 1}}, {"Shift+B", TurnDial{"bands", -1}}}},
        {"T", "thickness in false colours, and back", {{"T", LookAt{Look::Thickness}}}},
        {"E", "difference of the two sides, and back", {{"E", LookAt{Look::Error}}}},
        {"V, Shift + V",
         "the next variant of light, the one before",
         {{"V", NextVariant{1}}, {"Shift+V", NextVariant{-1}}}},
        {"N, Shift + N",
         "the next scene, the one before",
         {{"N", NextScene{1}}, {"Shift+N", NextScene{-1}}}},
        {"P", "take a picture: the window as PNG, the light as EXR", {{"P", Command::TakePicture}}},
        {"I", "panel away, and back", {{"I", Command::Panel}}},
        {"H, F1", "these keys, and back", {{"H", Command::Help}, {"F1", Command::Help}}},
        {"Esc", "quit", {{"Esc", Command::Quit}}},
    };
}

} // namespace

std::span<const KeyRow> key_table() {
    static const auto table = make_table();
    return table;
}

std::optional<Input> input_of(std::string_view stroke) {
    for (const auto& row : key_table())
        for (const auto& [key, input] : row.strokes)
            if (key == stroke)
                return input;
    return std::nullopt;
}

} // namespace experiment::viewer
