// The pages an observer reads.
#pragma once

#include "experiment/session/views.h"
#include "experiment/session/words.h"
#include "protocols/study.h"

#include <string>
#include <string_view>
#include <vector>

namespace experiment::session {

/// The instructions' pages: separated by lines of three or more '-', blank ends cut off, empty
/// pages left out.
std::vector<std::string> split_pages(std::string_view text);

/// How a sitting's pages speak, and which keys they name.
struct PageStyle {
    const Words* words = &words_in("en");
    protocols::KeyMap keys = protocols::standard_keys();
    protocols::Response response{};
    protocols::Presentation presentation{};
};

/// A page of the instructions' Markdown: paragraphs flow, headings ("# ") and list items ("- ")
/// keep their lines, emphasis and quotation are shown plain.
PageView instruction_page(const PageStyle& style, std::string_view text);

/// `may_repeat`: there is a training that can be had again.
PageView question_page(const PageStyle& style, const std::string& question, bool may_repeat);
PageView break_page(const PageStyle& style);

enum class PauseReason { WindowLeft, ScreenChanged };
PageView paused_page(const PageStyle& style, PauseReason reason);
PageView stop_page(const PageStyle& style);
PageView limit_page(const PageStyle& style);
PageView thanks_page(const PageStyle& style);

/// What is known of the display, "name=value; name=value", one line each.
PageView display_page(const PageStyle& style, std::string_view facts);

/// Bars near black and near white, to set brightness and contrast by.  After [BT814].
PageView contrast_page(const PageStyle& style);

/// One patch for a photometer, half as wide and high as the screen.
PageView
photometer_page(const PageStyle& style, std::uint8_t red, std::uint8_t green, std::uint8_t blue);

} // namespace experiment::session
