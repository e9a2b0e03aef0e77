// Text for an HTML page: what people typed is text there, never markup.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace experiment::report {

/// `text` with the five characters that mean something to HTML escaped: fit for elements and for
/// quoted attributes.
std::string escaped(std::string_view text);

/// "data:<media type>;base64,..." of any bytes.
std::string data_address(std::string_view media_type, std::string_view bytes);

/// `page` with every "{{name}}" replaced by the value of that name, in one pass: values are never
/// looked into.  EXPECTS a value for every name.
std::string filled(std::string_view page, const std::map<std::string, std::string>& values);

/// Rows of a table: cells are markup already; the first of a row is its head.
std::string html_row(const std::vector<std::string>& cells);
std::string html_head(const std::vector<std::string>& cells);
std::string html_table(std::string_view kind, std::string_view head, std::string_view rows);

} // namespace experiment::report
