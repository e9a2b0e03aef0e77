#include "experiment/report/figure_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace experiment::report {

// Sizes in points (1/72 inch), which SVG viewers show as pixels.  pdfcairo's letters come out a
// third larger than SVG's at the same size: 0.75 makes both figures alike.
std::string terminal(FigureForm form, int width, int height) {
    const std::string common =
        form == FigureForm::Svg
            ? fmt::format("set terminal svg size {},{} dynamic noenhanced font 'sans-serif,14' "
                          "background '#ffffff'\n",
                          width, height)
            : fmt::format("set terminal pdfcairo size {:.4f}in,{:.4f}in noenhanced font "
                          "'sans-serif,14' fontscale 0.75\n",
                          width / 72.0, height / 72.0);
    return "set encoding utf8\n" + common +
           fmt::format("set border lc rgb '{0}'\nset key off\nset tics nomirror textcolor rgb "
                       "'{0}'\nset title textcolor rgb '{0}'\nset xlabel textcolor rgb '{0}'\n",
                       ink);
}

std::string number_or_nan(double value) {
    return std::isnan(value) ? "NaN" : fmt::format("{:.17g}", value);
}

std::size_t characters(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char byte) { return (byte & 0xc0) != 0x80; }));
}

// gnuplot does not know how wide letters are in SVG and leaves far too much room for them.  So the
// names' share of the width is set here: 0.56 em is wide for a mean letter of a sans serif face.
double margin_of(std::size_t longest, int width) {
    return std::min(0.5, (0.56 * 14 * static_cast<double>(longest + 3) + 12) / width);
}

} // namespace experiment::report
