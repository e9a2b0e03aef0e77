// The panel from top to bottom, then what lies on the picture.
#include "experiment/viewer/panel.h"

#include "experiment/viewer/false_colours.h"
#include "experiment/viewer/keys.h"
#include "renderer/imaging/colour.h"
#include "renderer/methods/catalogue.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace experiment::viewer {

namespace methods = renderer::methods;

namespace {

const ImVec4 faint{0.60F, 0.60F, 0.60F, 1};
const ImVec4 warning{0.98F, 0.72F, 0.35F, 1};
const ImVec4 picked{0.55F, 0.78F, 1.0F, 1};
constexpr ImU32 label_back = IM_COL32(20, 20, 22, 190);
constexpr ImU32 label_ink = IM_COL32(225, 225, 225, 255);
constexpr float label_margin = 10;

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                   ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoNavFocus;

void say(const std::string& text) {
    ImGui::TextWrapped("%s", text.c_str());
}

void say(const ImVec4& colour, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    say(text);
    ImGui::PopStyleColor();
}

/// 12.3, 123, 1234: as many digits as a glance can use.
std::string short_number(double value) {
    const double size = std::abs(value);
    return size >= 100              ? fmt::format("{:.0f}", value)
           : size >= 10             ? fmt::format("{:.1f}", value)
           : size >= 1 || size == 0 ? fmt::format("{:.2f}", value)
                                    : fmt::format("{:.2g}", value);
}

std::string cost_text(const SideFacts& facts) {
    const auto time = facts.milliseconds ? fmt::format("{} ms", short_number(*facts.milliseconds))
                                         : std::string("not drawn");
    return fmt::format("{}, {} bytes per vertex", time, facts.bytes_per_vertex);
}

class Panel {
  public:
    Panel(const ViewerState& state, const Exhibit& exhibit, const Facts& facts)
        : state_(state), exhibit_(exhibit), facts_(facts) {}

    std::vector<Input> draw() {
        if (facts_.picture.left > 0)
            beside();
        if (state_.help)
            help();
        on_the_picture();
        return std::move(inputs_);
    }

  private:
    void beside() {
        ImGui::SetNextWindowPos({0, 0});
        ImGui::SetNextWindowSize({panel_width, static_cast<float>(facts_.window_height)});
        ImGui::Begin("panel", nullptr, fixed);
        what_is_shown();
        for (std::size_t side = 0; side < state_.sides.size(); ++side)
            if (is_seen(state_, side))
                about(side);
        messages();
        at_the_bottom();
        ImGui::End();
    }

    void what_is_shown() {
        const auto& scene = exhibit_.pieces[state_.scene].scene;
        const auto& variant = exhibit_.variants[state_.variant];
        say(exhibit_.name);
        say(faint, fmt::format("{} triangles, {} vertices", facts_.triangles, facts_.vertices));
        chooser(
            "scene", scene.label.empty() ? scene.id.value : scene.label, state_.scene,
            exhibit_.pieces.size(),
            [&](std::size_t i) {
                const auto& one = exhibit_.pieces[i].scene;
                return one.label.empty() ? one.id.value : one.label;
            },
            [](int by) { return Input{NextScene{by}}; });
        chooser(
            "light", label(variant), state_.variant, exhibit_.variants.size(),
            [&](std::size_t i) { return label(exhibit_.variants[i]); },
            [](int by) { return Input{NextVariant{by}}; });
        say(faint, fmt::format("material {}, {} mm across", scene.material,
                               short_number(facts_.diameter_mm)));
    }

    static std::string label(const protocols::Variant& variant) {
        if (!variant.label.empty())
            return variant.label;
        return variant.id.value.empty() ? "as the scene is lit" : variant.id.value;
    }

    template <class LabelOf, class InputOf>
    void chooser(const char* name,
                 const std::string& shown,
                 std::size_t now,
                 std::size_t count,
                 LabelOf label_of,
                 InputOf input_of_step) {
        ImGui::SetNextItemWidth(panel_width - 100);
        if (!ImGui::BeginCombo(name, shown.c_str()))
            return;
        for (std::size_t i = 0; i < count; ++i)
            if (ImGui::Selectable(fmt::format("{}##{}", label_of(i), i).c_str(), i == now))
                inputs_.push_back(input_of_step(static_cast<int>(i) - static_cast<int>(now)));
        ImGui::EndCombo();
    }

    void about(std::size_t side) {
        ImGui::Separator();
        ImGui::PushID(static_cast<int>(side));
        const bool is_active = side == state_.active;
        const auto* name = side == 0 ? "left side" : "right side";
        ImGui::TextColored(is_active ? picked : faint, "%s%s", name,
                           is_active ? " (keys change this one)" : "");
        method_chooser(side);
        const auto& dials = methods::find_method(state_.sides[side].method)->dials;
        for (std::size_t i = 0; i < dials.size(); ++i)
            turn_knob(side, dials[i], is_active && i == state_.dial);
        const auto& facts = facts_.sides[side];
        if (!facts.problem.empty())
            say(warning, facts.problem);
        else
            say(cost_text(facts));
        if (!facts.decision.empty())
            say(faint, facts.decision);
        ImGui::PopID();
    }

    void method_chooser(std::size_t side) {
        const auto now = title(state_.sides[side], exhibit_);
        ImGui::SetNextItemWidth(-1);
        if (!ImGui::BeginCombo("##method", now.c_str()))
            return;
        for (std::size_t i = 0; i < exhibit_.choices.size(); ++i) {
            const auto text = fmt::format("{}  {}##{}", i + 1, exhibit_.choices[i].label, i);
            if (ImGui::Selectable(text.c_str(), exhibit_.choices[i].label == now)) {
                inputs_.push_back(Activate{side});
                inputs_.push_back(Choose{i});
            }
        }
        ImGui::EndCombo();
    }

    void turn_knob(std::size_t side, const methods::Dial& dial, bool is_picked) {
        ImGui::PushID(dial.name.c_str());
        const auto& value = state_.sides[side].dials.at(dial.name);
        if (ImGui::ArrowButton("##down", ImGuiDir_Left))
            turned(side, dial, -1);
        ImGui::SameLine(0, 2);
        if (ImGui::ArrowButton("##up", ImGuiDir_Right))
            turned(side, dial, 1);
        ImGui::SameLine(0, 2);
        ImGui::SetNextItemWidth(96);
        if (const auto* name = std::get_if<std::string>(&value))
            name_chooser(side, dial, *name);
        else
            number_entry(side, dial, value);
        ImGui::SameLine();
        ImGui::TextColored(is_picked ? picked : ImGui::GetStyle().Colors[ImGuiCol_Text], "%s",
                           dial.name.c_str());
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", dial.meaning.c_str());
        ImGui::SameLine();
        ImGui::TextColored(faint, "%s", range_text(dial).c_str());
        ImGui::PopID();
    }

    void name_chooser(std::size_t side, const methods::Dial& dial, const std::string& now) {
        if (!ImGui::BeginCombo("##name", now.c_str()))
            return;
        for (const auto& name : dial.names)
            if (ImGui::Selectable(name.c_str(), name == now))
                inputs_.push_back(SetDial{side, dial.name, name});
        ImGui::EndCombo();
    }

    void number_entry(std::size_t side, const methods::Dial& dial, methods::DialValue value) {
        constexpr auto when_entered = ImGuiInputTextFlags_EnterReturnsTrue;
        if (auto* whole = std::get_if<std::int64_t>(&value)) {
            if (ImGui::InputScalar("##whole", ImGuiDataType_S64, whole, nullptr, nullptr, "%lld",
                                   when_entered))
                inputs_.push_back(SetDial{side, dial.name, *whole});
        } else if (auto& number = std::get<double>(value);
                   ImGui::InputDouble("##number", &number, 0, 0, "%.4g", when_entered)) {
            inputs_.push_back(SetDial{side, dial.name, number});
        }
    }

    static std::string range_text(const methods::Dial& dial) {
        if (dial.whole)
            return fmt::format("{}..{}", dial.whole->least, dial.whole->most);
        return dial.number ? fmt::format("{:g}..{:g}", dial.number->least, dial.number->most) : "";
    }

    void turned(std::size_t side, const methods::Dial& dial, int by) {
        if (side != state_.active)
            inputs_.push_back(Activate{side});
        inputs_.push_back(TurnDial{dial.name, by});
    }

    void messages() {
        ImGui::Separator();
        if (!state_.refusal.empty())
            say(warning, state_.refusal);
        if (!facts_.notice.empty())
            say(facts_.notice);
        for (const auto& remark : facts_.remarks)
            say(faint, remark);
    }

    void at_the_bottom() {
        const auto whole = facts_.milliseconds ? short_number(*facts_.milliseconds) : "-";
        const auto text =
            fmt::format("{} ms a picture with its controls, {} x {} pixels\n{}", whole,
                        facts_.picture.width, facts_.picture.height, facts_.renderer);
        const float width = panel_width - 2 * ImGui::GetStyle().WindowPadding.x;
        const float height = ImGui::CalcTextSize(text.c_str(), nullptr, false, width).y +
                             2.5F * ImGui::GetTextLineHeightWithSpacing();
        const float top = static_cast<float>(facts_.window_height) - height;
        if (top > ImGui::GetCursorPosY())
            ImGui::SetCursorPosY(top);
        ImGui::Separator();
        say(faint, text);
        say(picked, "H or F1: all keys");
    }

    void help() {
        auto& io = ImGui::GetIO();
        const auto& place = facts_.picture;
        ImGui::SetNextWindowPos(
            {static_cast<float>(place.left) + 0.5F * static_cast<float>(place.width),
             0.5F * io.DisplaySize.y},
            ImGuiCond_Always, {0.5F, 0.5F});
        ImGui::SetNextWindowBgAlpha(0.94F);
        ImGui::Begin("keys", nullptr, fixed | ImGuiWindowFlags_AlwaysAutoResize);
        if (ImGui::BeginTable("rows", 2, ImGuiTableFlags_SizingFixedFit)) {
            for (const auto& row : key_table()) {
                ImGui::TableNextColumn();
                ImGui::TextColored(picked, "%s   ", row.keys.c_str());
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(row.does.c_str());
            }
            ImGui::EndTable();
        }
        ImGui::Separator();
        ImGui::TextColored(faint, "Mouse: drag walks round the model, with Shift or the other\n"
                                  "button it turns the light, the wheel zooms.");
        ImGui::End();
    }

    void on_the_picture() {
        const auto& place = facts_.picture;
        const auto left = static_cast<float>(place.left);
        const auto right = left + static_cast<float>(place.width);
        if (state_.split || state_.look == Look::Error) {
            side_label(0, left, false);
            side_label(1, right, true);
        } else {
            side_label(state_.active, left, false);
        }
        if (facts_.legend)
            legend(*facts_.legend);
    }

    // At the picture's upper corner on its own side.
    void side_label(std::size_t side, float edge, bool ends_there) {
        const auto& facts = facts_.sides[side];
        auto text = title(state_.sides[side], exhibit_);
        if (facts.milliseconds && facts.problem.empty())
            text += fmt::format("   {} ms", short_number(*facts.milliseconds));
        if (!facts.problem.empty())
            text += "\n" + facts.problem;
        const float widest = 0.46F * static_cast<float>(facts_.picture.width);
        const auto size = ImGui::CalcTextSize(text.c_str(), nullptr, false, widest);
        const float x = ends_there ? edge - size.x - 2 * label_margin : edge + label_margin;
        box({x, label_margin}, size, text, widest);
    }

    static void box(ImVec2 place, ImVec2 size, const std::string& text, float widest) {
        auto* list = ImGui::GetBackgroundDrawList();
        list->AddRectFilled({place.x - 6, place.y - 4},
                            {place.x + size.x + 6, place.y + size.y + 4}, label_back, 3);
        list->AddText(ImGui::GetFont(), ImGui::GetFontSize(), place, label_ink, text.c_str(),
                      nullptr, widest);
    }

    void legend(const Legend& legend) {
        constexpr float bar_width = 380, bar_height = 14;
        constexpr int steps = 95;
        const float line = ImGui::GetTextLineHeightWithSpacing();
        const float x = std::floor(static_cast<float>(facts_.picture.left) +
                                   0.5F * (static_cast<float>(facts_.picture.width) - bar_width));
        const float y = static_cast<float>(facts_.window_height) - 3 * line - bar_height - 16;
        auto* list = ImGui::GetBackgroundDrawList();
        list->AddRectFilled({x - 24, y - 8}, {x + bar_width + 24, y + 3 * line + bar_height + 8},
                            label_back, 3);
        list->AddText({x, y}, label_ink, legend.meaning.c_str());
        for (int i = 0; i < steps; ++i) {
            const float from = x + bar_width * static_cast<float>(i) / steps;
            list->AddRectFilled({from, y + line}, {from + bar_width / steps, y + line + bar_height},
                                colour((i + 0.5) / steps));
        }
        for (int i = 0; i <= 4; ++i) {
            const auto number = short_number(legend.whole * i / 4);
            const auto text = i == 4 ? number + " " + legend.unit : number;
            const float at = x + bar_width * static_cast<float>(i) / 4;
            const float half = 0.5F * ImGui::CalcTextSize(number.c_str()).x;
            list->AddText({std::floor(at - half), y + line + bar_height + 2}, label_ink,
                          text.c_str());
        }
        list->AddText({x, y + 2 * line + bar_height}, label_ink, legend.reading.c_str());
    }

    static ImU32 colour(double t) {
        const auto code = [](float light) {
            return static_cast<int>(renderer::imaging::code_8bit(
                renderer::imaging::srgb_from_linear(static_cast<double>(light))));
        };
        const auto light = false_colour(t);
        return IM_COL32(code(light.r), code(light.g), code(light.b), 255);
    }

    const ViewerState& state_;
    const Exhibit& exhibit_;
    const Facts& facts_;
    std::vector<Input> inputs_;
};

} // namespace

std::vector<Input>
draw_panel(const ViewerState& state, const Exhibit& exhibit, const Facts& facts) {
    return Panel(state, exhibit, facts).draw();
}

void draw_progress(const std::string& what, double fraction, double seconds_left) {
    const auto& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({0.5F * io.DisplaySize.x, 0.5F * io.DisplaySize.y}, ImGuiCond_Always,
                            {0.5F, 0.5F});
    ImGui::SetNextWindowSize({420, 0});
    ImGui::Begin("progress", nullptr, fixed);
    say(what);
    ImGui::ProgressBar(static_cast<float>(fraction), {-1, 0});
    say(faint, fmt::format("about {:.0f} s left; Esc quits", std::ceil(seconds_left)));
    ImGui::End();
}

} // namespace experiment::viewer
