// The words of the pages that are not the study's own.
#include "experiment/session/pages.h"

#include <fmt/format.h>

namespace experiment::session {

namespace {

bool is_separator(std::string_view line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == '\t'))
        line.remove_suffix(1);
    return line.size() >= 3 && line.find_first_not_of('-') == std::string_view::npos;
}

std::string trimmed(std::string_view text) {
    constexpr auto blank = " \t\r\n";
    const auto first = text.find_first_not_of(blank);
    if (first == std::string_view::npos)
        return {};
    return std::string(text.substr(first, text.find_last_not_of(blank) - first + 1));
}

/// Headings and list items stand on lines of their own; everything else flows.
bool begins_a_line(std::string_view line) {
    return line.empty() || line.starts_with("# ") || line.starts_with("- ");
}

std::string without_emphasis(std::string_view line) {
    std::string plain(line.starts_with("> ") ? line.substr(2) : line);
    for (auto stars = plain.find("**"); stars != std::string::npos; stars = plain.find("**"))
        plain.erase(stars, 2);
    return plain;
}

/// Markdown as a page of text: the lines of a paragraph are one line, to be wrapped where the
/// column ends; marks of emphasis and quotation are left out.
std::string flowed(std::string_view markdown) {
    std::string page;
    bool may_join = false;
    while (!markdown.empty()) {
        const auto raw = markdown.substr(0, markdown.find('\n'));
        markdown.remove_prefix(std::min(markdown.size(), raw.size() + 1));
        const auto line = trimmed(raw);
        page += page.empty() ? "" : may_join && !begins_a_line(line) ? " " : "\n";
        page += without_emphasis(line);
        may_join = !line.empty() && !line.starts_with("# ");
    }
    return page;
}

} // namespace

std::vector<std::string> split_pages(std::string_view text) {
    std::vector<std::string> pages;
    std::string page;
    const auto turn = [&] {
        if (auto finished = trimmed(page); !finished.empty())
            pages.push_back(std::move(finished));
        page.clear();
    };
    while (!text.empty()) {
        const auto line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        if (is_separator(line))
            turn();
        else
            page.append(line).push_back('\n');
    }
    turn();
    return pages;
}

PageView instruction_page(std::string_view text) {
    return {flowed(text), "Space: next page", Key::Forward};
}

PageView question_page(const std::string& question) {
    return {fmt::format("# Any questions?\n\n"
                        "Please ask them now.\n\n"
                        "In every pair that follows: {}\n\n"
                        "Left arrow, or a click on the left picture: the left one.\n"
                        "Right arrow, or a click on the right picture: the right one.\n\n"
                        "First the screen stays grey for a while, so that your eyes get used to "
                        "it. Then the pairs begin.",
                        question),
            "F9 (the experimenter): begin", Key::Release};
}

PageView break_page() {
    return {"# Time for a break\n\n"
            "Rest your eyes for a minute or more. Go on when you feel like it.",
            "Space: go on (after ten seconds)", Key::Forward};
}

PageView paused_page() {
    return {"# Paused\n\n"
            "The window was left. The last pair will be shown again.",
            "F9 (the experimenter): go on", Key::Release};
}

PageView stop_page() {
    return {"# Do you want to stop here?\n\n"
            "Your answers so far are kept. The session can be taken up again later, with the pair "
            "that was on the screen.",
            "Space: go on      Escape: stop", Key::Forward};
}

PageView thanks_page() {
    return {"# Thank you!\n\n"
            "This session is finished and all your answers are stored.",
            "Space: close", Key::Forward};
}

} // namespace experiment::session
