// How fast the reference gets sure: efficiency 1 / (mean variance x seconds of processor) of each
// choice against the plain walk, interleaved in one run; samples per second and scaling.
//
// reference_bench tactics [ARMADILLO.off]   the table of docs/reference.md
// reference_bench scaling [ARMADILLO.off]   one thread against two
// reference_bench furnace ARMADILLO.off PIXELS BATCHES    the greatest deviation of a pixel from 1
// reference_bench scene NAME MODEL PIXELS SAMPLES SEEDS   one scene for a comparison with others:
//                                            sphere-sky, sphere-back or model-back
#include "renderer/camera.h"
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh_files.h"
#include "renderer/geometry/mesh_repair.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/path_tracer.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace renderer::reference;
namespace geometry = renderer::geometry;

struct Named {
    std::string name;
    Picture picture;
};

/// Lengths in mean free paths.
Picture
picture_of(const geometry::Mesh& mesh, double diameter, double turn, const Illumination& light) {
    const renderer::Turntable table{turn, 0};
    const auto placement = renderer::place(geometry::bounding_sphere(mesh), {diameter}, table);
    auto placed = mesh;
    for (auto& p : placed.positions)
        p = glm::dvec3(placement.world_from_model * glm::dvec4(p, 1));
    return {make_mesh_body(placed),
            grey_medium(1, 0.9, 0, 1),
            {},
            light,
            renderer::frame({diameter}, table, 1)};
}

const Illumination sky{.sky = {1, 1, 1}};
const Illumination back{.suns = {{glm::normalize(glm::dvec3(0, 0.3, -1)), {1, 1, 1}}}};

Named scene(const std::string& name, const std::string& model) {
    if (name == "sphere-sky")
        return {name, picture_of(geometry::sphere(1, 5), 10, 0, sky)};
    if (name == "sphere-back")
        return {name, picture_of(geometry::sphere(1, 5), 10, 0, back)};
    auto mesh = geometry::read_mesh(model);
    if (!mesh) {
        fmt::print(stderr, "{}\n", mesh.error());
        std::exit(EXIT_FAILURE);
    }
    auto prepared = geometry::prepare(std::move(*mesh), model);
    if (!prepared) {
        fmt::print(stderr, "{}\n", prepared.error());
        std::exit(EXIT_FAILURE);
    }
    return {name, picture_of(prepared->mesh, 20, 180, back)};
}

/// Seconds of processor time of all threads.
double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Yield {
    double mean = 0, variance = 0, cpu = 0, wall = 0, samples = 0;

    double efficiency() const { return 1 / (variance * cpu); }
};

Yield measure(const Picture& picture,
              int pixels,
              std::uint32_t batches,
              int log2_batch,
              const TracerTactics& tactics,
              std::uint64_t seed) {
    Film film = blank_film(pixels, pixels, seed, log2_batch);
    const auto wall = std::chrono::steady_clock::now();
    const double cpu = cpu_seconds();
    for (std::uint32_t b = 0; b < batches; ++b)
        add_batch(picture, film, tactics);
    Yield yield;
    yield.cpu = cpu_seconds() - cpu;
    yield.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count();
    double n = 0;
    const double samples = std::ldexp(static_cast<double>(batches), log2_batch);
    for (std::size_t i = 0; i < film.sum.size(); ++i)
        if (film.covered[i] == samples) {
            yield.mean += mean(film, i)[0];
            yield.variance += std::pow(standard_error(film, i)[0], 2);
            ++n;
        }
    yield.mean /= n;
    yield.variance /= n;
    yield.samples = samples * static_cast<double>(film.sum.size());
    return yield;
}

struct Choice {
    std::string name;
    TracerTactics tactics;
    int log2_batch;
};

const TracerTactics plain{.walk = {.roulette_after = 32, .force_first = false},
                          .light_threshold = 0};

std::vector<Choice> choices() {
    std::vector<Choice> list{{"plain", plain, 0}};
    list.push_back({"+ stratified, batches of 16", plain, 4});
    list.push_back({"+ stratified, batches of 64", plain, 6});
    auto forced = plain;
    forced.walk.force_first = true;
    list.push_back({"+ forced first collision", forced, 6});
    for (const double threshold : {0.03, 0.1, 0.3, 1.0}) {
        auto t = forced;
        t.light_threshold = threshold;
        list.push_back({fmt::format("+ light asked below {}", threshold), t, 6});
    }
    for (const int after : {4, 8, 16}) {
        auto t = forced;
        t.light_threshold = 0.3;
        t.walk.roulette_after = after;
        list.push_back({fmt::format("+ roulette after {}", after), t, 6});
    }
    for (const double share : {0.25, 0.5}) {
        auto t = forced;
        t.light_threshold = 0.3;
        t.walk.guided_share = share;
        list.push_back({fmt::format("+ guided share {}", share), t, 6});
    }
    auto expected = forced;
    expected.walk.expect_escape = true;
    list.push_back({"forced + expected escape", expected, 6});
    return list;
}

void tactics_table(const std::string& model) {
    constexpr int pixels = 32, repeats = 3;
    constexpr int samples = 512;
    for (const auto& name : {"sphere-sky", "sphere-back", "model-back"}) {
        const auto [label, picture] = scene(name, model);
        auto list = choices();
        for (auto& choice : list)
            choice.tactics.walk.guide_axis = back.suns[0].to_light;
        std::vector<std::vector<double>> efficiency(list.size());
        std::vector<double> means(list.size());
        for (int r = 0; r < repeats; ++r)
            for (std::size_t i = 0; i < list.size(); ++i) {
                const auto batches = static_cast<std::uint32_t>(samples >> list[i].log2_batch);
                const auto y = measure(picture, pixels, batches, list[i].log2_batch,
                                       list[i].tactics, static_cast<std::uint64_t>(r + 1));
                efficiency[i].push_back(y.efficiency());
                means[i] = y.mean;
            }
        fmt::print(
            "\n| {} | mean | efficiency over plain (least, middle, most of {}) |\n|---|---|---|\n",
            label, repeats);
        for (std::size_t i = 0; i < list.size(); ++i) {
            std::vector<double> ratio;
            for (int r = 0; r < repeats; ++r)
                ratio.push_back(efficiency[i][static_cast<std::size_t>(r)] /
                                efficiency[0][static_cast<std::size_t>(r)]);
            std::ranges::sort(ratio);
            fmt::print("| {} | {:.6f} | {:.2f}, {:.2f}, {:.2f} |\n", list[i].name, means[i],
                       ratio[0], ratio[1], ratio[2]);
        }
        std::fflush(stdout);
    }
}

void scaling(const std::string& model) {
    fmt::print("| scene | samples/s, 1 thread | 2 threads | ratio |\n|---|---|---|---|\n");
    for (const auto& name : {"sphere-sky", "sphere-back", "model-back"}) {
        const auto [label, picture] = scene(name, model);
        std::vector<double> rate[2];
        for (int r = 0; r < 3; ++r)
            for (const std::size_t threads : {1, 2}) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                                threads);
                const auto y = measure(picture, 128, 4, 4, {}, 1);
                rate[threads - 1].push_back(y.samples / y.wall);
            }
        for (auto& rates : rate)
            std::ranges::sort(rates);
        fmt::print("| {} | {:.3g} | {:.3g} | {:.2f} |\n", label, rate[0][1], rate[1][1],
                   rate[1][1] / rate[0][1]);
        std::fflush(stdout);
    }
}

/// The deviation that the greatest of `count` normal ones exceeds as rarely as one exceeds 4.
double corrected_limit(double count) {
    const double rare = std::erfc(4 / std::numbers::sqrt2);
    double low = 4, high = 12;
    for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (count * std::erfc(middle / std::numbers::sqrt2) > rare ? low : high) = middle;
    }
    return low;
}

/// An even sky through a body that only scatters, each channel otherwise: every pixel is 1.
void furnace(const std::string& model, int pixels, std::uint32_t batches) {
    for (const auto kind : {BoundaryKind::Matched, BoundaryKind::Smooth}) {
        auto picture = scene("model-back", model).picture;
        picture.illumination = sky;
        picture.medium = {{0, 0, 0}, {0.2, 1, 0}, 0.5, 1.4};
        picture.boundary = {kind};
        Film film = blank_film(pixels, pixels, 1, 4);
        for (std::uint32_t b = 0; b < batches; ++b)
            add_batch(picture, film);
        double worst = 0, count = 0, error = 0;
        for (std::size_t i = 0; i < film.sum.size(); ++i)
            if (film.covered[i] == 16.0 * batches)
                for (std::size_t k = 0; k < 3; ++k) {
                    const double se = standard_error(film, i)[k];
                    if (se > 1e-12) // where a channel never scatters, a pixel is 1 to rounding
                        worst = std::max(worst, std::abs(mean(film, i)[k] - 1) / se);
                    else if (!(std::abs(mean(film, i)[k] - 1) < 1e-9))
                        worst = std::numeric_limits<double>::infinity();
                    error += se;
                    ++count;
                }
        fmt::print(
            "{}: {} pixels and channels, mean standard error {:.2e}, greatest deviation {:.2f} "
            "standard errors, limit {:.2f}; {} leaks in {} paths\n",
            name_of(kind), count, error / count, worst, corrected_limit(count), film.leaks,
            film.paths);
    }
}

/// The variance between independent runs, as it has to be measured of a program that keeps none.
void one_scene(
    const std::string& name, const std::string& model, int pixels, int samples, int seeds) {
    const auto [label, picture] = scene(name, model);
    double variance = 0, cpu = 0, average = 0;
    for (int s = 1; s <= seeds; ++s) {
        const auto y = measure(picture, pixels, static_cast<std::uint32_t>(samples / 64), 6, {},
                               static_cast<std::uint64_t>(s));
        variance += y.variance / seeds;
        cpu += y.cpu / seeds;
        average += y.mean / seeds;
    }
    fmt::print("{} mean {:.6f} variance {:.4e} cpu {:.3f} efficiency {:.5g}\n", label, average,
               variance, cpu, 1 / (variance * cpu));
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    const std::string what = words.empty() ? "tactics" : words[0];
    if (what == "scene" && words.size() == 6)
        one_scene(words[1], words[2], std::stoi(words[3]), std::stoi(words[4]),
                  std::stoi(words[5]));
    else if (what == "scaling" && words.size() == 2)
        scaling(words[1]);
    else if (what == "furnace" && words.size() == 4)
        furnace(words[1], std::stoi(words[2]), static_cast<std::uint32_t>(std::stoi(words[3])));
    else if (what == "tactics" && words.size() == 2)
        tactics_table(words[1]);
    else
        fmt::print(stderr, "usage: reference_bench tactics|scaling MODEL, furnace MODEL PIXELS "
                           "BATCHES, or scene NAME MODEL PIXELS "
                           "SAMPLES SEEDS\n");
}
