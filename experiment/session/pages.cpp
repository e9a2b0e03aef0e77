// The words of the pages that are not the study's own.
#include "experiment/session/pages.h"

#include <fmt/format.h>

#include <algorithm>

namespace experiment::session {

using protocols::Action;

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

template <class... Values>
std::string filled(std::string_view sentence, const Values&... values) {
    return fmt::format(fmt::runtime(sentence), values...);
}

std::string headed(std::string_view heading, std::string_view text) {
    return fmt::format("# {}\n\n{}", heading, text);
}

/// The first key of an action, as people say it.
std::string key(const PageStyle& style, Action action) {
    return spoken_key(style.keys.at(action).front(), *style.words);
}

std::string grades(const PageStyle& style, bool side_by_side) {
    const auto& words = *style.words;
    std::string lines(side_by_side ? words.grades_of_right : words.grades_of_second);
    for (int i = 0; i < 7; ++i) {
        const auto action = static_cast<Action>(static_cast<int>(Action::MuchWorse) + i);
        lines += fmt::format("\n- {}: {}", key(style, action), words.grades[i]);
    }
    return lines;
}

std::string how_to_answer(const PageStyle& style) {
    const auto& words = *style.words;
    const bool side_by_side = style.presentation == protocols::Presentation::SideBySide;
    std::string lines;
    if (style.presentation == protocols::Presentation::Flip)
        lines = filled(words.flip, key(style, Action::Flip)) + "\n";
    if (style.response == protocols::Response::SevenGrades)
        return lines + grades(style, side_by_side);
    lines +=
        filled(side_by_side ? words.answer_left : words.answer_first, key(style, Action::Left)) +
        "\n" +
        filled(side_by_side ? words.answer_right : words.answer_second, key(style, Action::Right));
    if (style.response == protocols::Response::WithNotSure)
        lines += "\n" + filled(words.answer_not_sure, key(style, Action::NotSure));
    return lines;
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

PageView instruction_page(const PageStyle& style, std::string_view text) {
    return {flowed(text), filled(style.words->next_page, key(style, Action::Forward)),
            Key::Forward};
}

PageView question_page(const PageStyle& style, const std::string& question, bool may_repeat) {
    const auto& words = *style.words;
    auto keys = filled(words.questions_keys, key(style, Action::Release));
    if (may_repeat)
        keys += "      " + filled(words.training_again_key, key(style, Action::Again));
    return {fmt::format("# {}\n\n{}\n\n{}\n\n{}\n\n{}", words.questions_heading,
                        words.questions_ask, filled(words.questions_task, question),
                        how_to_answer(style), words.questions_adapt),
            keys, Key::Release};
}

PageView break_page(const PageStyle& style) {
    const auto& words = *style.words;
    return {headed(words.break_heading, words.break_text),
            filled(words.break_keys, key(style, Action::Forward)), Key::Forward};
}

PageView paused_page(const PageStyle& style, PauseReason reason) {
    const auto& words = *style.words;
    return {headed(words.paused_heading,
                   reason == PauseReason::WindowLeft ? words.paused_left : words.paused_changed),
            filled(words.paused_keys, key(style, Action::Release)), Key::Release};
}

PageView stop_page(const PageStyle& style) {
    const auto& words = *style.words;
    return {headed(words.stop_heading, words.stop_text),
            filled(words.stop_keys, key(style, Action::Forward), key(style, Action::Stop)),
            Key::Forward};
}

PageView limit_page(const PageStyle& style) {
    const auto& words = *style.words;
    return {headed(words.limit_heading, words.limit_text),
            filled(words.limit_keys, key(style, Action::Release), key(style, Action::Stop)),
            Key::Release};
}

PageView thanks_page(const PageStyle& style) {
    const auto& words = *style.words;
    return {headed(words.thanks_heading, words.thanks_text),
            filled(words.thanks_keys, key(style, Action::Forward)), Key::Forward};
}

PageView display_page(const PageStyle& style, std::string_view facts) {
    std::string lines;
    while (!facts.empty()) {
        const auto fact = facts.substr(0, facts.find(';'));
        facts.remove_prefix(std::min(facts.size(), fact.size() + 1));
        lines += "- " + trimmed(fact) + "\n";
    }
    const auto& words = *style.words;
    return {headed(words.display_heading, trimmed(lines)),
            filled(words.display_keys, key(style, Action::Release)), Key::Release};
}

PageView contrast_page(const PageStyle& style) {
    const auto grey = [](double left, double width, std::uint8_t code) {
        return Patch{left, 0.5, width, 0.3, code, code, code};
    };
    const auto& words = *style.words;
    return {headed(words.contrast_heading, words.contrast_text),
            filled(words.contrast_keys, key(style, Action::Release)),
            Key::Release,
            {grey(0.1, 0.35, 0), grey(0.17, 0.06, 2), grey(0.32, 0.06, 12), grey(0.55, 0.35, 235),
             grey(0.62, 0.06, 245), grey(0.77, 0.06, 255)}};
}

PageView
photometer_page(const PageStyle& style, std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    return {fmt::format("{},{},{}", red, green, blue),
            filled(style.words->patch_keys, key(style, Action::Forward)),
            Key::Forward,
            {{0.25, 0.25, 0.5, 0.5, red, green, blue}}};
}

} // namespace experiment::session
