// The pages an observer reads.
#pragma once

#include "experiment/session/views.h"

#include <string>
#include <string_view>
#include <vector>

namespace experiment::session {

/// The instructions' pages: separated by lines of three or more '-', blank ends cut off, empty
/// pages left out.
std::vector<std::string> split_pages(std::string_view text);

/// A page of the instructions' Markdown: paragraphs flow, headings ("# ") and list items ("- ")
/// keep their lines, emphasis and quotation are shown plain.
PageView instruction_page(std::string_view text);
PageView question_page(const std::string& question);
PageView break_page();
PageView paused_page();
PageView stop_page();
PageView thanks_page();

} // namespace experiment::session
