// How precomputation, frames, the reference, the analysis and memory grow: sizes that double or
// more from point to point, and the exponent of the power law through them.
//
//   scaling_bench [FIGURE.svg]
//
// Times are processor time of all threads; memory is what the heap holds more afterwards.
#include "analysis/findings.h"
#include "analysis/vote_csv.h"
#include "experiment/report/figure_parts.h"
#include "experiment/report/gnuplot.h"
#include "experiment/text_files.h"
#include "protocols/random.h"
#include "renderer/cost/frame_times.h"
#include "renderer/cost/power_law.h"
#include "renderer/cost/quantiles.h"
#include "renderer/geometry/bodies.h"
#include "renderer/gpu/context.h"
#include "renderer/reference/path_tracer.h"
#include "tests/bench/workbench.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace bench;
namespace report = experiment::report;

struct Point {
    double size, value;
};

struct Series {
    std::string what, with, unit;
    std::vector<Point> points;
};

/// The least of three: what others did to the machine only adds.
double seconds_of(const std::function<void()>& work, int repeats = 3) {
    double least = INFINITY;
    for (int i = 0; i < repeats; ++i) {
        const double start = cost::processor_seconds();
        work();
        least = std::min(least, cost::processor_seconds() - start);
    }
    return least;
}

double heap_bytes() {
    const auto info = mallinfo2();
    return static_cast<double>(info.uordblks + info.hblkhd);
}

/// A torus of about so many vertices.
geometry::Mesh ring(int vertices) {
    const int around = static_cast<int>(std::lround(std::sqrt(vertices / 2.0)));
    return geometry::along_morton_curve(geometry::torus(2, 1, 2 * around, around));
}

double vertices_of(const geometry::Mesh& mesh) {
    return static_cast<double>(mesh.positions.size());
}

thickness::ThicknessField traced(const geometry::Mesh& mesh, int directions) {
    return value_or_throw(
        thickness::compute_thickness_field(mesh, {.bands = 5, .directions = directions}));
}

Series precomputation_with_vertices() {
    Series series{"precomputation", "vertices", "s", {}};
    for (const int vertices : {2'000, 8'000, 32'000, 128'000}) {
        const auto mesh = ring(vertices);
        series.points.push_back(
            {vertices_of(mesh), seconds_of([&] { traced(mesh, 64); }, vertices > 9000 ? 1 : 3)});
    }
    return series;
}

Series precomputation_with_directions() {
    Series series{"precomputation", "directions", "s", {}};
    const auto mesh = ring(8'000);
    for (const int directions : {64, 256, 1024, 2048})
        series.points.push_back(
            {static_cast<double>(directions),
             seconds_of([&] { traced(mesh, directions); }, directions > 300 ? 1 : 3)});
    return series;
}

Series field_memory_with_vertices() {
    Series series{"memory of a thickness field", "vertices", "MB", {}};
    for (const int vertices : {2'000, 8'000, 32'000, 128'000}) {
        const auto mesh = ring(vertices);
        const double before = heap_bytes();
        const auto field = traced(mesh, 64);
        series.points.push_back({vertices_of(mesh), (heap_bytes() - before) / 1e6});
    }
    return series;
}

double frame_ms(const geometry::Mesh& mesh, int size) {
    const auto scene = scene_of(mesh, size, size);
    const Workbench workbench(mesh, scene, 64);
    const auto method = workbench.prepare("shss", {});
    const auto target = value_or_throw(gpu::Target::create(size, size));
    const std::vector<cost::Turn> turns{{method.get(), true}};
    const auto times = value_or_throw(cost::take_turns(turns, scene, target, {.rounds = 7}));
    return 1000 * cost::quantile(times.front().processor, 0.5);
}

Series frames_with_vertices() {
    Series series{"frame, light moving", "vertices", "ms", {}};
    for (const int vertices : {2'000, 8'000, 32'000, 128'000}) {
        const auto mesh = ring(vertices);
        series.points.push_back({vertices_of(mesh), frame_ms(mesh, 480)});
    }
    return series;
}

Series frames_with_pixels() {
    Series series{"frame, light moving", "pixels", "ms", {}};
    const auto mesh = ring(8'000);
    for (const int size : {120, 240, 480, 960, 1920})
        series.points.push_back({static_cast<double>(size) * size, frame_ms(mesh, size)});
    return series;
}

/// One batch of 16 samples a pixel.
double reference_seconds(const geometry::Mesh& mesh, int size) {
    const auto picture = value_or_throw(
        reference::picture_of_scene(mesh, scene_of(mesh, size, size, Millimetres{20})));
    return seconds_of(
        [&] {
            auto film = reference::blank_film(size, size, 1);
            reference::add_batch(picture, film);
        },
        1);
}

Series reference_with_pixels() {
    Series series{"reference, a batch", "pixels", "s", {}};
    const auto mesh = ring(8'000);
    for (const int size : {16, 32, 64, 128})
        series.points.push_back({static_cast<double>(size) * size, reference_seconds(mesh, size)});
    return series;
}

Series reference_with_vertices() {
    Series series{"reference, a batch", "vertices", "s", {}};
    for (const int vertices : {2'000, 8'000, 32'000, 128'000}) {
        const auto mesh = ring(vertices);
        series.points.push_back({vertices_of(mesh), reference_seconds(mesh, 48)});
    }
    return series;
}

/// Ten observers who compare every pair in every scene.
std::string votes_of(int conditions, int scenes) {
    protocols::Rng rng({2});
    std::string text = "observer,session,scene,left,right,chosen\n";
    for (int o = 0; o < 10; ++o)
        for (int scene = 0; scene < scenes; ++scene)
            for (int i = 0; i < conditions; ++i)
                for (int j = i + 1; j < conditions; ++j)
                    text += fmt::format("O{},1,s{},c{},c{},{}\n", o, scene, i, j,
                                        protocols::draw_coin(rng) ? "left" : "right");
    return text;
}

double analysis_seconds(const std::string& text) {
    return seconds_of(
        [&] { analysis::analyze(value_or_throw(analysis::read_votes_csv(text, "votes"))); }, 1);
}

double lines_of(const std::string& text) {
    return static_cast<double>(std::ranges::count(text, '\n') - 1);
}

Series analysis_with_votes() {
    Series series{"analysis, four conditions", "votes", "s", {}};
    for (const int scenes : {16, 64, 256, 1024}) {
        const auto text = votes_of(4, scenes);
        series.points.push_back({lines_of(text), analysis_seconds(text)});
    }
    return series;
}

Series analysis_with_conditions() {
    Series series{"analysis, nine scenes", "conditions", "s", {}};
    for (const int conditions : {3, 4, 6, 8, 12, 16})
        series.points.push_back(
            {static_cast<double>(conditions), analysis_seconds(votes_of(conditions, 9))});
    return series;
}

Series memory_with_votes() {
    Series series{"memory of a vote table", "votes", "MB", {}};
    for (const int scenes : {64, 256, 1024, 2048}) {
        const auto text = votes_of(4, scenes);
        const double before = heap_bytes();
        const auto table = value_or_throw(analysis::read_votes_csv(text, "votes"));
        series.points.push_back({lines_of(text), (heap_bytes() - before) / 1e6});
    }
    return series;
}

std::optional<cost::PowerLaw> law_of(const Series& series) {
    std::vector<double> x, y;
    for (const auto& point : series.points) {
        x.push_back(point.size);
        y.push_back(point.value);
    }
    return cost::fit_power_law(x, y);
}

void print(const Series& series) {
    const auto law = law_of(series);
    const auto &first = series.points.front(), &last = series.points.back();
    fmt::print("| {} | {} | {:.3g} to {:.3g} | {:.3g} to {:.3g} {} | {} | {} |\n", series.what,
               series.with, first.size, last.size, first.value, last.value, series.unit,
               law ? fmt::format("{:.2f} +- {:.2f}", law->exponent, law->standard_error) : "none",
               law ? fmt::format("{:.2f}", law->worst_ratio) : "");
    std::fflush(stdout);
}

/// A panel for each series, four to a row.
std::string figure_script(const std::vector<Series>& all) {
    const int rows = (static_cast<int>(all.size()) + 3) / 4;
    auto script = report::terminal(report::FigureForm::Svg, 1080, 250 * rows);
    script += fmt::format("set multiplot layout {},4\nset logscale xy\nset format xy "
                          "'10^{{%T}}'\nset termoption enhanced\nset border 3\nset tics out font "
                          "',10'\nset grid lc rgb '#e3e6e8' lt 1 lw 0.5 back\n"
                          "set offsets graph 0.08, graph 0.08, graph 0.08, graph 0.08\n",
                          rows);
    for (const auto& series : all) {
        script += "$points << END\n";
        for (const auto& point : series.points)
            script += fmt::format("{} {}\n", report::number_or_nan(point.size),
                                  report::number_or_nan(point.value));
        const auto law = law_of(series);
        script += fmt::format(
            "END\nset title {} font ',12'\nset xlabel '{}' font ',11'\nset ylabel '{}' font "
            "',11' offset 1,0\nplot {}$points using 1:2 with points pt 7 ps 0.8 lc rgb '{}'\n",
            report::gnuplot_string(law ? fmt::format("{}: {:.2f} \u00b1 {:.2f}", series.what,
                                                     law->exponent, law->standard_error)
                                       : series.what),
            series.with, series.unit,
            law ? fmt::format("{} * x**{} with lines lc rgb '#7fa8c9' lw 1.5, ", law->factor,
                              law->exponent)
                : "",
            report::ink);
    }
    return script + "unset multiplot\n";
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto context = value_or_throw(gpu::Context::surfaceless());
        fmt::print("{}\n\n| what | grows with | from, to | takes | exponent +- standard error | "
                   "farthest point off the line, factor |\n|---|---|---|---|---|---|\n",
                   gpu::description());
        std::vector<Series> all;
        for (const auto measure :
             {precomputation_with_vertices, precomputation_with_directions, frames_with_vertices,
              frames_with_pixels, reference_with_vertices, reference_with_pixels,
              analysis_with_votes, analysis_with_conditions, field_memory_with_vertices,
              memory_with_votes}) {
            all.push_back(measure());
            print(all.back());
        }
        if (argc > 1)
            value_or_throw(report::run_gnuplot(figure_script(all)).and_then([&](const auto& svg) {
                return experiment::write_text_file(argv[1], svg).map([] { return 0; });
            }));
    } catch (const std::exception& error) {
        fmt::print(stderr, "scaling_bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
