// Both axes are logarithmic: settings differ by factors.
#include "experiment/cost/cost_figures.h"

#include "experiment/cost/choices.h"
#include "experiment/report/figure_parts.h"
#include "experiment/report/gnuplot.h"
#include "renderer/cost/pareto.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace experiment::cost {

using report::Figure;
using report::FigureForm;
using report::gnuplot_string;

namespace {

constexpr int width = 1080, height = 400;
constexpr double legend = 0.77;     // of the width: where the panels end
constexpr double least_shown = 0.1; // percent: logarithms have no zero

constexpr std::array colours{"#2d618c", "#c2571a", "#3f8f4f", "#8a4fa3", "#b08a1e", "#c23b60",
                             "#1f8a8a", "#6b7178", "#7a5230", "#4a4fb5", "#98a13a", "#222222"};
constexpr std::array shapes{7, 5, 9, 11, 13, 15, 6, 4, 8, 10, 12, 14};

/// Methods in the order of the rows.
std::vector<std::string> methods_of(const SceneCost& scene) {
    std::vector<std::string> methods;
    for (const auto& row : scene.rows)
        if (std::ranges::find(methods, row.label) == methods.end())
            methods.push_back(row.label);
    return methods;
}

double shown(double error) {
    return std::max(100 * error, least_shown);
}

std::string look(std::size_t method) {
    return fmt::format("pt {} ps 0.8 lc rgb '{}'", shapes[method % shapes.size()],
                       colours[method % colours.size()]);
}

std::string point(const Row& row, std::size_t light, ErrorKind kind) {
    return fmt::format("{} {}\n", report::number_or_nan(row.frame_ms.median),
                       report::number_or_nan(shown(error_of(row, light, kind))));
}

/// A hair more than the points of a panel need, so that none lies on the frame.
std::string ranges(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    double left = INFINITY, right = 0, low = INFINITY, high = 0;
    for (const auto& row : scene.rows) {
        const double x = row.frame_ms.median, y = shown(error_of(row, light, kind));
        if (std::isnan(error_of(row, light, kind)))
            continue;
        left = std::min(left, x);
        right = std::max(right, x);
        low = std::min(low, y);
        high = std::max(high, y);
    }
    return fmt::format("set xrange [{:.4g}:{:.4g}]\nset yrange [{:.4g}:{:.4g}]\n", left / 1.3,
                       right * 1.5, low / 1.3, high * 1.4);
}

std::string_view title_of(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::Thickness:
        return "thickness";
    case ErrorKind::Law:
        return "picture, same law";
    case ErrorKind::Reference:
        return "picture, path-traced";
    case ErrorKind::Fitted:
        return "path-traced, fitted k";
    }
    return "";
}

/// Settings as points, the front as a staircase, its steps numbered, the chosen one ringed.
std::string panel(const SceneCost& scene, std::size_t light, ErrorKind kind, bool with_choice) {
    const auto methods = methods_of(scene);
    std::string data, plots;
    for (std::size_t m = 0; m < methods.size(); ++m) {
        std::string points;
        for (const auto& row : scene.rows)
            if (row.label == methods[m] && !std::isnan(error_of(row, light, kind)))
                points += point(row, light, kind);
        if (points.empty())
            continue;
        data += fmt::format("$m{} << END\n{}END\n", m, points);
        plots += fmt::format(", $m{} using 1:2 with points {}", m, look(m));
    }
    std::string stairs, labels;
    const auto front = front_of(scene, light, kind);
    for (std::size_t i = 0; i < front.size(); ++i) {
        const auto& row = scene.rows[front[i]];
        stairs += point(row, light, kind);
        labels +=
            fmt::format("set label '{}' at {},{} offset 0.5,0.6 front font ',10' textcolor "
                        "rgb '{}'\n",
                        i + 1, row.frame_ms.median, shown(error_of(row, light, kind)), report::ink);
    }
    data += "$front << END\n" + stairs + "END\n";
    const auto& choice = scene.lights[light].choice;
    if (with_choice && choice) {
        data += "$chosen << END\n" + point(scene.rows[choice->row], light, kind) + "END\n";
        plots += fmt::format(", $chosen using 1:2 with points pt 6 ps 2.2 lw 2 lc rgb '{}'",
                             report::ink);
    }
    return fmt::format("unset label\nset title {}\n", gnuplot_string(title_of(kind))) +
           ranges(scene, light, kind) + data + labels +
           "plot $front using 1:2 with steps lw 1.2 lc rgb '#9aa1a8'" + plots + "\n";
}

std::string legend_script(const SceneCost& scene, bool with_choice) {
    std::string script = "unset label\n";
    const auto methods = methods_of(scene);
    double y = 0.86;
    const auto line = [&](const std::string& text, const std::string& marker) {
        script +=
            fmt::format("set label {} at screen {:.3f},{:.3f} left font ',11' point {} offset "
                        "1,0 front\n",
                        gnuplot_string(text), legend + 0.025, y, marker);
        y -= 0.062;
    };
    for (std::size_t m = 0; m < methods.size(); ++m)
        line(methods[m], look(m));
    if (with_choice)
        line("chosen", fmt::format("pt 6 ps 1.6 lw 2 lc rgb '{}'", report::ink));
    return script;
}

std::vector<ErrorKind> known_errors(const SceneCost& scene, std::size_t light) {
    std::vector<ErrorKind> kinds;
    for (const auto kind : all_errors)
        if (has_error(scene, light, kind))
            kinds.push_back(kind);
    if (kinds.size() == all_errors.size()) // a method's best tells more than its preset
        std::erase(kinds, ErrorKind::Reference);
    return kinds;
}

std::string caption(const SceneCost& scene, const LightCase& light, const Wish& wish) {
    auto text = fmt::format(
        "{}, {}: error (percent of the truth, root mean square) against the time of a frame of {} "
        "x "
        "{} pixels under a moving light. Lines join the settings that no other beats, numbered as "
        "in the tables; errors below {} % are drawn there.",
        scene.label, light.label, scene.frame_width, scene.frame_height, least_shown);
    if (light.choice)
        text += fmt::format(" Ringed: {}, chosen by the error of {}.",
                            full_name(scene.rows[light.choice->row]), name_of(wish.error));
    if (light.noise_floor)
        text += fmt::format(" The path-traced picture is itself unsure by {}.",
                            as_percent(*light.noise_floor));
    return text;
}

std::string in_words(const SceneCost& scene, std::size_t light) {
    std::string text;
    for (const auto kind : known_errors(scene, light)) {
        text += fmt::format("{}{}:", text.empty() ? "" : ". ", title_of(kind));
        for (const auto r : front_of(scene, light, kind))
            text += fmt::format(" {} {:.3g} ms {};", full_name(scene.rows[r]),
                                scene.rows[r].frame_ms.median,
                                as_percent(error_of(scene.rows[r], light, kind)));
    }
    return text;
}

} // namespace

std::vector<std::size_t> front_of(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    std::vector<renderer::cost::Tradeoff> all;
    for (const auto& row : scene.rows)
        all.push_back({row.frame_ms.median, error_of(row, light, kind)});
    return renderer::cost::pareto_front(all);
}

std::string
front_script(const SceneCost& scene, std::size_t light, const Wish& wish, FigureForm form) {
    const auto kinds = known_errors(scene, light);
    std::string script = report::terminal(form, width, height);
    script += fmt::format("set multiplot title {}\n",
                          gnuplot_string(scene.label + ", " + scene.lights[light].label));
    script += "set logscale xy\nset format xy '%g'\nset border 3\nset tics out font ',11'\n"
              "set grid xtics ytics lc rgb '#e3e6e8' lt 1 lw 0.5 back\n"
              "set tmargin at screen 0.80\nset bmargin at screen 0.22\n"
              "set xlabel 'ms a frame' font ',11'\nset title font ',12'\n";
    // a panel may lie within a decade: 1, 2, 5 leave a number in any
    script += "set xtics (1, 3, 10, 30, 100, 300, 1000, 3000, 10000)\n"
              "set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500)\n";
    const double step = legend / static_cast<double>(kinds.size());
    for (std::size_t p = 0; p < kinds.size(); ++p) {
        const double left = step * static_cast<double>(p);
        script += fmt::format("set lmargin at screen {:.3f}\nset rmargin at screen {:.3f}\n",
                              left + 0.07, left + step - 0.012);
        script += p == 0 ? "set ylabel 'error, %' offset 2,0 font ',11'\n" : "unset ylabel\n";
        script += panel(scene, light, kinds[p], kinds[p] == wish.error);
    }
    return script + legend_script(scene, scene.lights[light].choice.has_value()) +
           "unset border\nunset tics\nunset title\nunset xlabel\nunset ylabel\nunset "
           "logscale\nset xrange [0:1]\nset yrange [0:1]\nplot NaN notitle\nunset multiplot\n";
}

std::string figure_name(const SceneCost& scene, const LightCase& light) {
    return light.id.empty() ? "cost-" + scene.id : "cost-" + scene.id + "-" + light.id;
}

tl::expected<std::vector<Figure>, std::string> draw_cost_figures(const CostReport& report) {
    std::vector<Figure> figures;
    for (const auto& scene : report.scenes)
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (known_errors(scene, i).empty())
                continue;
            Figure figure{figure_name(scene, scene.lights[i]),
                          caption(scene, scene.lights[i], report.wish), in_words(scene, i), "", ""};
            for (const auto form : {FigureForm::Svg, FigureForm::Pdf}) {
                auto drawn = report::run_gnuplot(front_script(scene, i, report.wish, form));
                if (!drawn)
                    return tl::unexpected(drawn.error());
                (form == FigureForm::Svg ? figure.svg : figure.pdf) = std::move(*drawn);
            }
            figures.push_back(std::move(figure));
        }
    return figures;
}

} // namespace experiment::cost
