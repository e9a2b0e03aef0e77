// Lines and fields of a text file held in memory, with line numbers for messages.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace renderer::geometry {

/// Takes a text apart line by line.  Lines end as the first one does: with \n, \r\n, or \r alone.
class Lines {
  public:
    explicit Lines(std::string_view text);

    /// The next line without its ending; nothing at the end of the text.
    std::optional<std::string_view> next();

    /// Number of the line last returned, from 1.
    std::size_t number() const { return number_; }

    /// What has not been read yet.
    std::string_view rest() const { return rest_; }

  private:
    std::string_view rest_;
    char ending_ = '\n';
    std::size_t number_ = 0;
};

/// Splits at blanks and tabs into `fields`, whose memory is used again from line to line.
void split_fields(std::string_view line, std::vector<std::string_view>& fields);

/// The whole field as a number; a leading + is allowed, nan and inf are numbers too.
std::optional<double> parse_real(std::string_view field);

/// The whole field as a whole number, 0 or above.
std::optional<std::size_t> parse_count(std::string_view field);

/// A field as a message may show it: quoted, short, printable.
std::string shown(std::string_view field);

/// "name:line: what", the form of every message about a text file.
std::string at_line(std::string_view name, std::size_t line, std::string_view what);

} // namespace renderer::geometry
