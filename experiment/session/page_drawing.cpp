// Pages of text, drawn by Dear ImGui.
#include "experiment/session/page_drawing.h"

#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <vector>

namespace experiment::session {

namespace {

constexpr auto font_file = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

// DejaVu Sans: x-height 1120, ascent 1901 and descent 483 of 2048 units; ImGui's size is ascent +
// descent.  20 px of x-height are 20 * (1901 + 483) / 1120 = 42.6 px.
constexpr float size_at_1080_lines = 43.0f;
constexpr float heading_scale = 1.35f;

constexpr ImU32 ink = IM_COL32(20, 20, 20, 255);
constexpr ImU32 black = IM_COL32(0, 0, 0, 255);
constexpr ImU32 white = IM_COL32(255, 255, 255, 255);
constexpr ImU32 faint_ink = IM_COL32(52, 52, 52, 255);

struct Line {
    std::string_view text;
    bool heading = false;
};

std::vector<Line> lines_of(std::string_view text) {
    std::vector<Line> lines;
    while (true) {
        const auto line = text.substr(0, text.find('\n'));
        const bool heading = line.starts_with("# ");
        lines.push_back({heading ? line.substr(2) : line, heading});
        if (line.size() == text.size())
            return lines;
        text.remove_prefix(line.size() + 1);
    }
}

// Both fonts of the atlas, in the order they were added.
ImFont* font_of(const Line& line) {
    return ImGui::GetIO().Fonts->Fonts[line.heading ? 1 : 0];
}

float height_of(const Line& line, float column) {
    const auto* font = font_of(line);
    if (line.text.empty())
        return 0.6f * font->FontSize; // a paragraph's distance
    return font
        ->CalcTextSizeA(font->FontSize, column, column, line.text.data(),
                        line.text.data() + line.text.size())
        .y;
}

void draw_line(const Line& line, ImVec2 place, float column, ImU32 colour) {
    const auto* font = font_of(line);
    ImGui::GetBackgroundDrawList()->AddText(font, font->FontSize, place, colour, line.text.data(),
                                            line.text.data() + line.text.size(), column);
}

} // namespace

protocols::Expected<std::unique_ptr<PageDrawing>>
PageDrawing::create(int width, int height, TextStyle style) {
    if (!std::filesystem::exists(font_file))
        return tl::unexpected(fmt::format("{}: there is no such font; expected the package "
                                          "fonts-dejavu-core to be installed",
                                          font_file));
    return std::unique_ptr<PageDrawing>(new PageDrawing(width, height, style));
}

PageDrawing::PageDrawing(int width, int height, TextStyle style)
    : width_(width), height_(height), style_(style) {
    ImGui::CreateContext();
    auto& io = ImGui::GetIO();
    io.IniFilename = nullptr; // no file of settings beside the study
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = 1.0f / 60.0f; // nothing moves, but it has to be above 0
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

PageDrawing::~PageDrawing() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext();
}

// Rasterises the letters of this page, so that any alphabet of the font can be used.
protocols::Expected<void> PageDrawing::make_letters(const PageView& page, double scale) {
    auto& fonts = *ImGui::GetIO().Fonts;
    ImFontGlyphRangesBuilder letters;
    letters.AddText("?");
    for (const auto& text : {page.text, page.keys})
        letters.AddText(text.data(), text.data() + text.size());
    ImVector<ImWchar> ranges;
    letters.BuildRanges(&ranges);
    const float size =
        size_at_1080_lines * static_cast<float>(scale * static_cast<double>(height_) / 1080);
    fonts.Clear();
    fonts.AddFontFromFileTTF(font_file, std::round(size), nullptr, ranges.Data);
    fonts.AddFontFromFileTTF(font_file, std::round(heading_scale * size), nullptr, ranges.Data);
    fonts.Build(); // reads `ranges`, which end with this function
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    for (const auto& text : {page.text, page.keys})
        for (const char* at = text.c_str(); *at != 0;) {
            unsigned code = 0;
            at += ImTextCharFromUtf8(&code, at, text.c_str() + text.size());
            if (code != '\n' && (code == IM_UNICODE_CODEPOINT_INVALID || code > 0xffff ||
                                 !fonts.Fonts[0]->FindGlyphNoFallback(static_cast<ImWchar>(code))))
                return tl::unexpected(
                    fmt::format("a page that begins with \"{}\" has the letter U+{:04X}, expected "
                                "UTF-8 text in the letters of DejaVu Sans",
                                page.text.substr(0, page.text.find('\n')), code));
        }
    return {};
}

void PageDrawing::resize(int width, int height) {
    width_ = width;
    height_ = height;
    ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
}

void PageDrawing::begin_frame() {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
}

void PageDrawing::end_frame() {
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

protocols::Expected<void> PageDrawing::draw(const PageView& page) {
    const auto width = static_cast<float>(width_);
    // Text ends where patches begin.
    const auto text_height =
        static_cast<float>(page.patches.empty() ? 1.0 : page.patches.front().top) *
        static_cast<float>(height_);
    const auto lines = lines_of(page.text);
    float em = 0, column = 0, total = 0, bottom = 0;
    for (double scale = style_.scale; scale > 0.2; scale *= 0.9) {
        if (auto made = make_letters(page, scale); !made)
            return made;
        em = font_of({})->FontSize;
        column = std::min(0.86f * width, 28.0f * em);
        total = 0;
        for (const auto& line : lines)
            total += height_of(line, column);
        // The keys lie below the text.
        bottom = page.patches.empty() ? static_cast<float>(height_) - 2.5f * em : text_height;
        if (total + em <= bottom)
            break;
    }
    begin_frame();
    const float left = std::floor((width - column) / 2);
    float top = std::floor(std::max(0.5f * em, (bottom - total) / 2));
    const float keys_top = std::floor(static_cast<float>(height_) - 2.0f * em);
    const auto field = [&](float from, float to) {
        if (style_.high_contrast)
            ImGui::GetBackgroundDrawList()->AddRectFilled(
                {left - 0.5f * em, from - 0.25f * em}, {left + column + 0.5f * em, to + 0.25f * em},
                white);
    };
    field(top, top + total);
    field(keys_top, keys_top + em);
    for (const auto& line : lines) {
        draw_line(line, {left, std::floor(top)}, column, style_.high_contrast ? black : ink);
        top += height_of(line, column);
    }
    draw_line({page.keys}, {left, keys_top}, column, style_.high_contrast ? black : faint_ink);
    end_frame();
    return {};
}

protocols::Expected<void> PageDrawing::draw_mark(const std::string& text, int x, int y) {
    if (auto made = make_letters({text, "", Key::Forward, {}}, style_.scale); !made)
        return made;
    begin_frame();
    const auto* font = font_of({});
    const auto size = font->CalcTextSizeA(font->FontSize, 1e6f, 0, text.c_str());
    draw_line(
        {text},
        {std::floor(static_cast<float>(x) - size.x / 2), static_cast<float>(y) + 0.2f * size.y}, 0,
        ink);
    end_frame();
    return {};
}

} // namespace experiment::session
