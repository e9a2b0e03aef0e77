// What all figures share: paper, ink, and numbers as gnuplot reads them.
#pragma once

#include "experiment/report/figures.h"

#include <string>

namespace experiment::report {

inline constexpr const char* ink = "#22262b";
inline constexpr int bar_width = 720;
inline constexpr const char* bar_blue = "#7fa8c9";

/// The lines of a script that make the paper.  Sizes in points (1/72 inch).
std::string terminal(FigureForm form, int width, int height);

/// All digits, or "NaN".
std::string number_or_nan(double value);

/// Characters, not bytes, of UTF-8 text.
std::size_t characters(const std::string& text);

/// The share of a figure's width that names of so many characters need at its left.
double margin_of(std::size_t longest, int width);

} // namespace experiment::report
