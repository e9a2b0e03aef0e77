// What a frame costs, by every method: processor time at 1280 x 800, under a moving light and with
// the light at rest, against Phong's model with a constant translucency.
//
//   frame_bench [--rounds N] [--width W --height H] [--law paper|physical] [--only METHOD]...
//               MODEL...
//
// With --only, those methods beside the floor and Phong, and more rounds in the same time.
// Variants take turns in every round, so that the machine's moods meet all of them; a ratio is
// taken within a round, and its median over the rounds is printed with the interval that holds the
// true one in 95 of 100 runs (of the order statistics: nothing is assumed of the noise), then the
// geometric mean of the medians over the models.  Processor time counts all threads of the
// rasteriser.
#include "renderer/cost/frame_times.h"
#include "renderer/cost/quantiles.h"
#include "renderer/gpu/context.h"
#include "renderer/gpu/target.h"
#include "renderer/methods/catalogue.h"
#include "tests/bench/workbench.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace renderer;
using namespace bench;
using methods::Dials;

struct Options {
    int rounds = 15;
    int width = 1280, height = 800;
    std::string law = "physical";
    std::vector<std::string> only;
    std::vector<std::string> models;

    bool wants(const std::string& method) const {
        return only.empty() || std::find(only.begin(), only.end(), method) != only.end();
    }
};

Options options_of(int argc, char** argv) {
    Options options;
    const std::vector<std::string> words(argv + 1, argv + argc);
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto next = [&] {
            if (i + 1 == words.size())
                throw std::runtime_error(words[i] + " without a value");
            return words[++i];
        };
        if (words[i] == "--rounds")
            options.rounds = std::stoi(next());
        else if (words[i] == "--width")
            options.width = std::stoi(next());
        else if (words[i] == "--height")
            options.height = std::stoi(next());
        else if (words[i] == "--law")
            options.law = next();
        else if (words[i] == "--only")
            options.only.push_back(next());
        else
            options.models.push_back(words[i]);
    }
    if (options.models.empty())
        throw std::runtime_error(
            "frame_bench [--rounds N] [--width W --height H] [--law paper|physical] "
            "[--only METHOD]... MODEL...");
    return options;
}

/// A method and how it is asked to draw.
struct Variant {
    std::string name;
    std::shared_ptr<methods::Method> method;
    bool light_moves;
};

constexpr int frames_per_turn = 4;

std::vector<Variant> variants_for(const geometry::Mesh& mesh, const Options& options) {
    const auto scene = scene_of(mesh, options.width, options.height);
    const Workbench workbench(mesh, scene);
    std::vector<Variant> variants;
    const auto add = [&](const std::string& label, const std::string& name, Dials dials) {
        const auto* method = methods::find_method(name);
        for (const auto& dial : method->dials)
            if (dial.name == "law")
                dials["law"] = options.law;
        const std::shared_ptr<methods::Method> made = workbench.prepare(name, dials);
        variants.push_back({label + ", light moves", made, true});
        variants.push_back({label + ", light rests", made, false});
    };
    add("constant", "constant", {});
    add("phong", "phong", {});
    for (const int bands : {5, 2})
        if (options.wants("shss"))
            add(fmt::format("shss, {} coefficients", bands * bands), "shss",
                {{"bands", std::int64_t{bands}}});
    for (const auto& method : methods::catalogue())
        if (method.name != "constant" && method.name != "phong" && method.name != "shss" &&
            method.name != "jensen" && // seconds a light, and no frame rate at all
            options.wants(method.name))
            add(method.name, method.name, {});
    return variants;
}

struct Median {
    double value, low, high;
};

std::string text_of(const Median& median) {
    return fmt::format("{:.3f} ({:.3f}-{:.3f})", median.value, median.low, median.high);
}

/// The median, and the order statistics that enclose the true one with 95 %: the number of values
/// below it is binomial, here to its normal approximation (10 rounds or more).
Median median_of(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const auto n = static_cast<double>(values.size());
    const double half = 0.98 * std::sqrt(n); // 1.96 / 2
    const auto at = [&](double place) {
        return values[static_cast<std::size_t>(std::clamp(place, 0.0, n - 1))];
    };
    return {cost::quantile(values, 0.5), at(std::floor(n / 2 - half)), at(std::ceil(n / 2 + half))};
}

/// Of the ratios to the floor and to Phong, variant by variant.
struct Ratios {
    Median to_floor, to_phong;
};

/// Of the models' medians; their intervals are added as independent errors.
Median geometric_mean(const std::vector<Median>& medians) {
    double sum = 0, below = 0, above = 0;
    for (const auto& [value, low, high] : medians) {
        sum += std::log(value);
        below += std::pow(std::log(value / low), 2);
        above += std::pow(std::log(high / value), 2);
    }
    const auto n = static_cast<double>(medians.size());
    return {std::exp(sum / n), std::exp((sum - std::sqrt(below)) / n),
            std::exp((sum + std::sqrt(above)) / n)};
}

std::map<std::string, Ratios> measure(const std::string& name, const Options& options) {
    const auto mesh = load_drawn_mesh(name);
    const auto target = value_or_throw(gpu::Target::create(options.width, options.height));
    const auto variants = variants_for(mesh, options);
    std::vector<cost::Turn> turns;
    for (const auto& variant : variants)
        turns.push_back({variant.method.get(), variant.light_moves});
    const auto times = value_or_throw(cost::take_turns(
        turns, scene_of(mesh, options.width, options.height), target,
        {.rounds = options.rounds, .frames = frames_per_turn, .slow_rounds = options.rounds}));
    fmt::print("\n{}: {} vertices, {} triangles, law {}, {} rounds of {} frames\n\n", name,
               mesh.positions.size(), mesh.triangles.size(), options.law, options.rounds,
               frames_per_turn);
    fmt::print(
        "| variant | ms of processor time | ratio to the floor (95 %) | ratio to Phong (95 %) | "
        "bytes a vertex |\n|---|---|---|---|---|\n");
    std::map<std::string, Ratios> medians;
    for (std::size_t i = 0; i < variants.size(); ++i) {
        const auto& seconds = times[i].processor;
        const Ratios both{median_of(cost::ratios(seconds, times[1].processor)),
                          median_of(cost::ratios(seconds, times[3].processor))};
        fmt::print("| {} | {:.2f} | {} | {} | {} |\n", variants[i].name,
                   1000 * cost::quantile(seconds, 0.5), text_of(both.to_floor),
                   text_of(both.to_phong), variants[i].method->cost().bytes_per_vertex);
        medians[variants[i].name] = both;
    }
    return medians;
}

} // namespace

int main(int argc, char** argv) {
    try {
        const auto options = options_of(argc, argv);
        const auto context = value_or_throw(gpu::Context::surfaceless());
        fmt::print("{}, {} x {}\n", gpu::description(), options.width, options.height);
        std::map<std::string, std::vector<Ratios>> all;
        for (const auto& model : options.models)
            for (const auto& [variant, medians] : measure(model, options))
                all[variant].push_back(medians);
        fmt::print("\nGeometric mean over {} models\n\n| variant | to the floor | to Phong |\n"
                   "|---|---|---|\n",
                   options.models.size());
        for (const auto& [variant, each] : all) {
            std::vector<Median> floor, phong;
            for (const auto& one : each) {
                floor.push_back(one.to_floor);
                phong.push_back(one.to_phong);
            }
            fmt::print("| {} | {} | {} |\n", variant, text_of(geometric_mean(floor)),
                       text_of(geometric_mean(phong)));
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "frame_bench: {}\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
