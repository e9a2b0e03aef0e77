// gnuplot as a child process: a script goes in, a picture comes out.
#pragma once

#include <tl/expected.hpp>

#include <string>
#include <string_view>

namespace experiment::report {

/// What gnuplot writes to its output when it runs `script` without any start-up file.
/// `program` is looked for on PATH.
/// Errors: the program is not there; it failed, with the first line it said.
tl::expected<std::string, std::string> run_gnuplot(std::string_view script,
                                                   const std::string& program = "gnuplot");

/// `text` as a string of gnuplot's own, in which nothing is executed or interpreted: apostrophes
/// become typographic ones, control characters spaces.
std::string gnuplot_string(std::string_view text);

} // namespace experiment::report
