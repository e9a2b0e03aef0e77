// Setting up Dear ImGui.
#include "experiment/viewer/gui.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <filesystem>

namespace experiment::viewer {

namespace {

constexpr auto font_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";
constexpr float font_size = 15;

// Latin, Greek and Cyrillic letters, dashes, arrows and signs, for titles in a study's own
// language.
constexpr ImWchar letters[] = {0x0020, 0x024F, 0x0370, 0x052F, 0x2010, 0x2044,
                               0x2070, 0x209F, 0x2190, 0x22FF, 0};

void set_style() {
    ImGui::StyleColorsDark();
    auto& style = ImGui::GetStyle();
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.WindowBorderSize = 0;
    style.WindowPadding = {12, 10};
    style.ItemSpacing = {8, 5};
    style.Colors[ImGuiCol_WindowBg] = {0.11F, 0.11F, 0.12F, 1};
    style.Colors[ImGuiCol_Text] = {0.88F, 0.88F, 0.88F, 1};
    for (const auto plain : {ImGuiCol_FrameBg, ImGuiCol_Button})
        style.Colors[plain] = {0.20F, 0.20F, 0.22F, 1};
}

} // namespace

tl::expected<std::unique_ptr<Gui>, std::string> Gui::create() {
    if (!std::filesystem::exists(font_file))
        return tl::unexpected(fmt::format("{}: there is no such font; expected the package "
                                          "fonts-dejavu-core to be installed",
                                          font_file));
    return std::unique_ptr<Gui>(new Gui);
}

Gui::Gui() {
    ImGui::CreateContext();
    auto& io = ImGui::GetIO();
    io.IniFilename = nullptr; // no file of settings beside the model
    io.Fonts->AddFontFromFileTTF(font_file, font_size, nullptr, letters);
    set_style();
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

void draw_controls() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

} // namespace experiment::viewer
