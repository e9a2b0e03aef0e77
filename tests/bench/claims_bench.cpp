// What the paper claims of its method, in numbers: 25 coefficients with the light behind and 4 with
// it in front; cost linear in the number of lights; right on concave bodies; a frame rate that does
// not depend on the number of bands.  [SHSS]
//
//   claims_bench FIGURE.svg MODEL...
#include "experiment/report/figure_parts.h"
#include "experiment/report/gnuplot.h"
#include "experiment/text_files.h"
#include "renderer/cost/frame_times.h"
#include "renderer/cost/held_out_thickness.h"
#include "renderer/cost/quantiles.h"
#include "renderer/geometry/bodies.h"
#include "renderer/gpu/context.h"
#include "renderer/harmonics/directions.h"
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/colour.h"
#include "renderer/pictures/picture.h"
#include "tests/bench/workbench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace bench;
namespace report = experiment::report;

constexpr int size = 320;
constexpr int frame_size = 480;

const std::array<std::pair<const char*, glm::dvec3>, 3> lights{
    {{"back", {0, 0.3, -1}}, {"left", {-1, 0.2, 0.2}}, {"front", {0.3, 0.3, 1}}}};

/// Share of the body's pixels in which some channel is off by a code value of an 8-bit display.
double seen_share(const imaging::LinearImage& test,
                  const imaging::LinearImage& truth,
                  const std::vector<std::size_t>& mask) {
    std::size_t off = 0;
    for (const auto i : mask) {
        const auto x = imaging::encode(test.pixels[i]), y = imaging::encode(truth.pixels[i]);
        const float apart =
            std::max({std::abs(x.r - y.r), std::abs(x.g - y.g), std::abs(x.b - y.b)});
        off += apart >= 1.0F / 255 ? 1 : 0;
    }
    return static_cast<double>(off) / static_cast<double>(mask.size());
}

/// Percent of the light, for a figure: model, light, then bands 1 to 6.
struct Line {
    std::string model, light;
    std::vector<double> percent;
};

void coefficients_and_light(const std::string& model,
                            const Workbench& workbench,
                            Scene scene,
                            const std::string& law,
                            std::vector<Line>& lines) {
    const auto exact = workbench.prepare("traced", {{"law", law}});
    std::vector<std::shared_ptr<methods::Method>> shss;
    for (std::int64_t bands = 1; bands <= 6; ++bands)
        shss.push_back(workbench.prepare("shss", {{"bands", bands}, {"law", law}}));
    for (const auto& [name, to_light] : lights) {
        scene.lights.front().place = DirectionalLight{to_light};
        const auto truth = value_or_throw(pictures::render_picture(*exact, scene, size, size, 4));
        const auto mask = imaging::covered_pixels(truth.coverage);
        fmt::print("| {} | {} | {} |", model, law, name);
        Line line{model, name, {}};
        for (const auto& method : shss) {
            const auto image =
                value_or_throw(pictures::render_picture(*method, scene, size, size, 4));
            const double error = 100 * cost::relative_rms(image, truth, mask);
            fmt::print(" {:.1f} % ({:.0f} %) |", error, 100 * seen_share(image, truth, mask));
            line.percent.push_back(error);
        }
        fmt::print("\n");
        std::fflush(stdout); // a run that is cut short leaves what it has
        if (law == "paper")
            lines.push_back(std::move(line));
    }
}

void concave_bodies() {
    struct Body {
        const char* name;
        geometry::Mesh mesh;
    };

    fmt::print(
        "\n| body | SHSS 4 | SHSS 25 | SHSS 36 | Green | Green, peeled |\n|---|---|---|---|---|"
        "---|\n");
    std::vector<Body> bodies;
    bodies.push_back({"sphere (convex)", geometry::sphere(1, 4)});
    bodies.push_back({"torus", geometry::torus(2, 1, 128, 64)});
    bodies.push_back({"shell, cavity half as wide", geometry::shell(1, 0.5, 4)});
    for (const auto& body : bodies) {
        const auto scene = scene_of(body.mesh, size, size);
        const Workbench workbench(body.mesh, scene, 1024);
        const auto exact = workbench.prepare("traced", {});
        const auto held_out = value_or_throw(cost::HeldOutThickness::prepare(
            *exact, shading::Law::Physical, scene, size, size, 8, 2));
        fmt::print("| {} |", body.name);
        const std::vector<std::pair<std::string, methods::Dials>> rivals{
            {"shss", {{"bands", std::int64_t{2}}}},
            {"shss", {}},
            {"shss", {{"bands", std::int64_t{6}}}},
            {"green", {}},
            {"green-peel", {{"layers", std::int64_t{6}}}}};
        for (const auto& [name, dials] : rivals) {
            const auto method = workbench.prepare(name, dials);
            fmt::print(" {:.1f} % |", 100 * value_or_throw(held_out.error_of(*method)));
        }
        fmt::print("\n");
        std::fflush(stdout); // a run that is cut short leaves what it has
    }
}

/// Milliseconds of processor time of a frame with 1 to 8 lights, of each method.
struct Growth {
    std::string name;
    std::vector<double> ms;
};

/// Intercept and slope by least squares, and the share of the variance they explain.
std::array<double, 3> straight_line(const std::vector<double>& y) {
    const auto n = static_cast<double>(y.size());
    double mean_x = (n + 1) / 2, mean_y = 0, xx = 0, xy = 0, yy = 0;
    for (const double value : y)
        mean_y += value / n;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double dx = static_cast<double>(i + 1) - mean_x, dy = y[i] - mean_y;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
    return {mean_y - xy / xx * mean_x, xy / xx, xy * xy / (xx * yy)};
}

std::vector<Growth> lights_in_numbers(const std::string& model, const geometry::Mesh& mesh) {
    auto scene = scene_of(mesh, frame_size, frame_size);
    const Workbench workbench(mesh, scene, 256);
    const auto target = value_or_throw(gpu::Target::create(frame_size, frame_size));
    std::vector<Growth> all{{"SHSS, 25", {}}, {"SHSS, 4", {}}, {"Phong", {}}};
    const std::vector<std::shared_ptr<methods::Method>> methods{
        workbench.prepare("shss", {}), workbench.prepare("shss", {{"bands", std::int64_t{2}}}),
        workbench.prepare("phong", {})};
    std::vector<cost::Turn> turns;
    for (const auto& method : methods)
        turns.push_back({method.get(), true});
    const auto around = harmonics::fibonacci_directions(8, 3).directions;
    scene.lights.clear();
    for (const auto& direction : around) {
        scene.lights.push_back({DirectionalLight{direction}, {0.2F, 0.2F, 0.2F}});
        const auto times = value_or_throw(cost::take_turns(turns, scene, target, {.rounds = 5}));
        for (std::size_t k = 0; k < all.size(); ++k)
            all[k].ms.push_back(1000 * cost::quantile(times[k].processor, 0.5));
    }
    for (const auto& growth : all) {
        const auto [start, slope, explained] = straight_line(growth.ms);
        fmt::print("| {} | {} |", model, growth.name);
        for (const double ms : growth.ms)
            fmt::print(" {:.2f} |", ms);
        fmt::print(" {:.2f} + {:.2f} k | {:.3f} |\n", start, slope, explained);
        std::fflush(stdout);
    }
    return all;
}

void bands_and_frames(const std::string& model, const geometry::Mesh& mesh) {
    const auto scene = scene_of(mesh, frame_size, frame_size);
    const Workbench workbench(mesh, scene, 256);
    const auto target = value_or_throw(gpu::Target::create(frame_size, frame_size));
    std::vector<std::shared_ptr<methods::Method>> methods;
    std::vector<cost::Turn> turns;
    for (const bool moves : {true, false})
        for (std::int64_t bands = 1; bands <= 6; ++bands) {
            methods.push_back(workbench.prepare("shss", {{"bands", bands}}));
            turns.push_back({methods.back().get(), moves});
        }
    const auto times = value_or_throw(cost::take_turns(turns, scene, target, {.rounds = 11}));
    for (const std::size_t first : {std::size_t{0}, std::size_t{6}}) {
        fmt::print("| {} | {} | {:.2f} |", model, first == 0 ? "moves" : "rests",
                   1000 * cost::quantile(times[first].processor, 0.5));
        for (std::size_t k = first; k < first + 6; ++k) {
            const auto ratio =
                cost::spread_of(cost::ratios(times[k].processor, times[first].processor));
            fmt::print(" {:.3f} ({:.3f}-{:.3f}) |", ratio.median, ratio.lower, ratio.upper);
        }
        fmt::print("\n");
        std::fflush(stdout); // a run that is cut short leaves what it has
    }
}

std::string figure_script(const std::vector<Line>& lines,
                          const std::vector<Growth>& growths,
                          const std::vector<std::string>& models) {
    const auto panels = models.size() + 1;
    auto script = report::terminal(report::FigureForm::Svg, 1080, 360);
    script += fmt::format("set multiplot layout 1,{}\nset border 3\nset tics out font ',11'\nset "
                          "grid lc rgb '#e3e6e8' lt 1 lw 0.5 back\nset key top right font ',11' "
                          "samplen 1.5\nset title font ',12'\n",
                          panels);
    constexpr std::array colours{"#2d618c", "#c2571a", "#3f8f4f"};
    script += "set logscale y\nset xrange [0.7:6.3]\nset xlabel 'bands' font ',11'\nset ylabel "
              "'error of the light, %' font ',11'\n";
    for (const auto& model : models) {
        std::string plots;
        std::size_t k = 0;
        for (const auto& line : lines) {
            if (line.model != model)
                continue;
            script += fmt::format("$l{} << END\n", k);
            for (std::size_t n = 0; n < line.percent.size(); ++n)
                script += fmt::format("{} {}\n", n + 1, line.percent[n]);
            script += "END\n";
            plots += fmt::format("{}$l{} using 1:2 with linespoints pt 7 ps 0.7 lw 1.5 lc rgb '{}' "
                                 "title 'light {}'",
                                 plots.empty() ? "" : ", ", k, colours[k % 3], line.light);
            ++k;
        }
        script += fmt::format("set title {}\nplot {}\n",
                              report::gnuplot_string(model + ", paper's law"), plots);
    }
    script +=
        "unset logscale\nset xrange [0.5:8.5]\nset yrange [0:*]\nset key right bottom\nset xlabel "
        "'lights' font ',11'\nset ylabel 'ms of processor time a frame' font ',11'\nset "
        "title 'lights'\n";
    std::string plots;
    for (std::size_t k = 0; k < growths.size(); ++k) {
        script += fmt::format("$g{} << END\n", k);
        for (std::size_t n = 0; n < growths[k].ms.size(); ++n)
            script += fmt::format("{} {}\n", n + 1, growths[k].ms[n]);
        script += "END\n";
        const auto [start, slope, explained] = straight_line(growths[k].ms);
        plots += fmt::format("{}{} + {} * x with lines lw 1 lc rgb '{}' notitle, $g{} using 1:2 "
                             "with points pt 7 ps 0.7 lc rgb '{}' title '{}'",
                             plots.empty() ? "" : ", ", start, slope, colours[k % 3], k,
                             colours[k % 3], growths[k].name);
    }
    return script + "plot " + plots + "\nunset multiplot\n";
}

void run(const std::string& figure, const std::vector<std::string>& models) {
    std::vector<geometry::Mesh> meshes;
    for (const auto& model : models)
        meshes.push_back(load_drawn_mesh(model));
    std::vector<Line> lines;
    fmt::print(
        "{}\n\n| model | law | light | 1 band | 2 | 3 | 4 | 5 | 6 |\n|---|---|---|---|---|---|"
        "---|---|---|\n",
        gpu::description());
    for (std::size_t i = 0; i < models.size(); ++i) {
        const auto scene = scene_of(meshes[i], size, size);
        const Workbench workbench(meshes[i], scene, 512);
        for (const std::string law : {"paper", "physical"})
            coefficients_and_light(models[i], workbench, scene, law, lines);
    }
    concave_bodies();
    fmt::print("\n| model | method | 1 light | 2 | 3 | 4 | 5 | 6 | 7 | 8 | line, ms | variance "
               "explained |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    std::vector<Growth> growths;
    for (std::size_t i = 0; i < models.size(); ++i) {
        const auto here = lights_in_numbers(models[i], meshes[i]);
        growths = i == 0 ? here : growths;
    }
    fmt::print(
        "\n| model | light | 1 band, ms | ratio 1 | 2 | 3 | 4 | 5 | 6 |\n|---|---|---|---|---|"
        "---|---|---|---|\n");
    for (std::size_t i = 0; i < models.size(); ++i)
        bands_and_frames(models[i], meshes[i]);
    value_or_throw(
        report::run_gnuplot(figure_script(lines, growths, models)).and_then([&](const auto& svg) {
            return experiment::write_text_file(figure, svg).map([] { return 0; });
        }));
}

} // namespace

int main(int argc, char** argv) {
    try {
        if (argc < 3)
            throw std::runtime_error("claims_bench FIGURE.svg MODEL...");
        const auto context = value_or_throw(gpu::Context::surfaceless());
        run(argv[1], {argv + 2, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "claims_bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
