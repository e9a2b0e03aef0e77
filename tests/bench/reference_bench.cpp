// How fast the reference gets sure: efficiency 1 / (mean variance x seconds of processor) of each
// choice against the plain walk, interleaved in one run; samples per second, time to a given error
// and scaling.  Names of models are looked for in the working directory.
//
// reference_bench tactics    each choice, on six of the study's scenes and three more
// reference_bench studies    samples per second and time to 1 % and 0.3 %
// reference_bench scaling    one thread against two
// reference_bench furnace MODEL PIXELS BATCHES    the greatest deviation of a pixel from 1
// reference_bench scene NAME MODEL PIXELS SAMPLES SEEDS MASK    one scene, to compare with others:
//     sphere-sky, sphere-exact, sphere-back or model-back; writes its mask
#include "renderer/stopwatch.h"
#include "tests/bench/reference_scenes.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace {

using namespace renderer::reference;
using bench::NamedPicture;

/// Seconds of processor time of all threads.
double cpu_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

struct Yield {
    double mean = 0, variance = 0, cpu = 0, wall = 0, samples = 0;

    double efficiency() const { return 1 / (variance * cpu); }

    /// Root mean square standard error of a pixel's channel over the mean light.
    double relative_error() const { return std::sqrt(variance) / mean; }
};

/// Pixels that every sample has met the body in.
std::vector<std::size_t> whole_pixels(const Film& film) {
    const double samples = std::ldexp(static_cast<double>(film.batches), film.log2_batch);
    std::vector<std::size_t> whole;
    for (std::size_t i = 0; i < film.covered.size(); ++i)
        if (film.covered[i] == samples)
            whole.push_back(i);
    return whole;
}

Yield measure(const Picture& picture,
              Film& film,
              std::uint32_t batches,
              const TracerTactics& tactics,
              const std::vector<std::size_t>& mask = {}) {
    const renderer::Stopwatch watch;
    const double cpu = cpu_seconds();
    for (std::uint32_t b = 0; b < batches; ++b)
        add_batch(picture, film, tactics);
    Yield yield;
    yield.cpu = cpu_seconds() - cpu;
    yield.wall = watch.seconds();
    const auto pixels = mask.empty() ? whole_pixels(film) : mask;
    const double n = 3 * static_cast<double>(pixels.size());
    for (const auto i : pixels)
        for (std::size_t k = 0; k < 3; ++k) {
            yield.mean += mean(film, i)[k] / n;
            yield.variance += std::pow(standard_error(film, i)[k], 2) / n;
        }
    yield.samples = std::ldexp(static_cast<double>(batches), film.log2_batch) *
                    static_cast<double>(film.sum.size());
    return yield;
}

/// The same pixels for whatever is compared: a line of sight for each sample says which.
std::vector<std::size_t> mask_of(const Picture& picture, int pixels) {
    Film outline = blank_film(pixels, pixels, 1, 6);
    measure(picture, outline, 2, {.share_lines = false});
    return whole_pixels(outline);
}

struct Choice {
    std::string name;
    TracerTactics tactics;
    int log2_batch;
};

const TracerTactics plain{.walk = {.roulette_after = 32, .force_first = false},
                          .light_threshold = 0,
                          .share_lines = false};

std::vector<Choice> choices() {
    std::vector<Choice> list{{"plain", plain, 0}};
    list.push_back({"+ stratified, batches of 16", plain, 4});
    list.push_back({"+ stratified, batches of 64", plain, 6});
    auto forced = plain;
    forced.walk.force_first = true;
    list.push_back({"+ forced first collision", forced, 6});
    auto sharing = forced;
    sharing.share_lines = true;
    list.push_back({"+ 8 paths a line of sight", sharing, 6});
    for (const double threshold : {0.03, 0.1, 0.3}) {
        auto t = sharing;
        t.light_threshold = threshold;
        list.push_back({fmt::format("+ light asked below {}", threshold), t, 6});
    }
    for (const int after : {8, 1000}) {
        auto t = sharing;
        t.light_threshold = 0.1;
        t.walk.roulette_after = after;
        list.push_back({fmt::format("+ roulette after {}", after), t, 6});
    }
    auto all = sharing;
    all.light_threshold = 0.1;
    list.push_back({"+ batches of 16, 4 paths a line", all, 4});
    list.push_back({"+ batches of 128, 16 paths a line", all, 7});
    return list;
}

/// Scenes on which a choice has to earn its place.
std::vector<NamedPicture> judging_pictures() {
    auto pictures = bench::study_pictures();
    std::erase_if(pictures, [](const auto& p) { return p.name.ends_with("front"); });
    for (const auto* name : {"sphere-sky", "sphere-back", "model-back"})
        pictures.push_back(bench::comparison_picture(name, "armadillo"));
    return pictures;
}

void tactics_table(int pixels, int samples, int repeats) {
    const auto list = choices();
    std::vector<std::vector<std::string>> cells(list.size());
    std::string names;
    for (const auto& [name, picture] : judging_pictures()) {
        std::vector<std::vector<double>> ratio(list.size());
        const auto mask = mask_of(picture, pixels);
        for (int r = 0; r < repeats; ++r) {
            double of_plain = 0;
            for (std::size_t i = 0; i < list.size(); ++i) {
                Film film = blank_film(pixels, pixels, static_cast<std::uint64_t>(r + 1),
                                       list[i].log2_batch);
                const auto batches = static_cast<std::uint32_t>(samples >> list[i].log2_batch);
                const double efficiency =
                    measure(picture, film, batches, list[i].tactics, mask).efficiency();
                of_plain = i == 0 ? efficiency : of_plain;
                ratio[i].push_back(efficiency / of_plain);
            }
        }
        for (std::size_t i = 0; i < list.size(); ++i) {
            std::ranges::sort(ratio[i]);
            cells[i].push_back(fmt::format("{:.2f} ({:.2f}-{:.2f})", ratio[i][ratio[i].size() / 2],
                                           ratio[i].front(), ratio[i].back()));
        }
        names += " | " + name;
        fmt::print(stderr, "{}\n", name);
    }
    fmt::print("| choice{} |\n|---", names);
    for (std::size_t i = 0; i < cells[0].size(); ++i)
        fmt::print("|---");
    fmt::print("|\n");
    for (std::size_t i = 0; i < list.size(); ++i)
        fmt::print("| {} | {} |\n", list[i].name, fmt::join(cells[i], " | "));
}

/// The error falls with the square root of the samples: what a short run takes says the rest.
void studies(int pixels, std::uint32_t batches) {
    fmt::print("| picture | samples/s | error after {} samples | s to 1 % | s to 0.3 % |\n"
               "|---|---|---|---|---|\n",
               batches << 4);
    for (const auto& [name, picture] : bench::study_pictures()) {
        Film film = blank_film(pixels, pixels, 1);
        const auto y = measure(picture, film, batches, {}, mask_of(picture, pixels));
        const double error = y.relative_error();
        fmt::print("| {} | {:.3g} | {:.2f} % | {:.3g} | {:.3g} |\n", name, y.samples / y.wall,
                   100 * error, y.wall * std::pow(error / 0.01, 2),
                   y.wall * std::pow(error / 0.003, 2));
        std::fflush(stdout);
    }
}

void scaling() {
    constexpr int repeats = 3;
    fmt::print("| scene | samples/s, 1 thread | 2 threads | ratio |\n|---|---|---|---|\n");
    for (const auto& [name, picture] : judging_pictures()) {
        std::vector<double> rate[2];
        for (int r = 0; r < repeats; ++r)
            for (const std::size_t threads : {1, 2}) {
                const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                                threads);
                Film film = blank_film(128, 128, 1);
                const auto y = measure(picture, film, 2, {});
                rate[threads - 1].push_back(y.samples / y.wall);
            }
        for (auto& rates : rate)
            std::ranges::sort(rates);
        fmt::print("| {} | {:.3g} | {:.3g} | {:.2f} |\n", name, rate[0][repeats / 2],
                   rate[1][repeats / 2], rate[1][repeats / 2] / rate[0][repeats / 2]);
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
        auto picture = bench::comparison_picture("model-back", model).picture;
        picture.illumination = bench::even_sky;
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

/// A picture's mask as a line of 0 and 1 for each of its rows, top row first: pixels wholly
/// covered, their neighbours too, so that two renderers agree about what lies in it.
std::vector<std::size_t> write_mask(const Film& film, const std::string& file) {
    const auto whole = whole_pixels(film);
    const auto is_whole = [&](int x, int y) {
        return x >= 0 && y >= 0 && x < film.width && y < film.height &&
               std::ranges::binary_search(whole, static_cast<std::size_t>(y * film.width + x));
    };
    std::vector<std::size_t> mask;
    std::ofstream out(file);
    for (int y = 0; y < film.height; ++y) {
        for (int x = 0; x < film.width; ++x) {
            bool is_in = true;
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u)
                    is_in = is_in && is_whole(u, v);
            if (is_in)
                mask.push_back(static_cast<std::size_t>(y * film.width + x));
            out << (is_in ? '1' : '0');
        }
        out << '\n';
    }
    return mask;
}

/// The mean, how sure it is, and what a run costs; means over several seeds.
void one_scene(const std::string& name,
               const std::string& model,
               int pixels,
               int samples,
               int seeds,
               const std::string& mask_file) {
    const auto picture = bench::comparison_picture(name, model).picture;
    Film outline = blank_film(pixels, pixels, 1, 6);
    measure(picture, outline, 2, {.share_lines = false}); // a line of sight for each sample
    const auto mask = write_mask(outline, mask_file);
    const int log2_batch = static_cast<int>(std::log2(samples)) - 1; // two a seed
    double variance = 0, cpu = 0, average = 0;
    for (int s = 1; s <= seeds; ++s) {
        Film film = blank_film(pixels, pixels, static_cast<std::uint64_t>(s), log2_batch);
        const auto y =
            measure(picture, film, static_cast<std::uint32_t>(samples >> log2_batch), {}, mask);
        variance += y.variance / seeds;
        cpu += y.cpu / seeds;
        average += y.mean / seeds;
    }
    fmt::print("{} pairlight mean {:.6f} +- {:.6f} variance {:.4e} cpu {:.3f} efficiency {:.5g}\n",
               name, average, std::sqrt(variance / seeds / static_cast<double>(mask.size())),
               variance, cpu, 1 / (variance * cpu));
}

int run(const std::vector<std::string>& words) {
    const std::string what = words.empty() ? "" : words[0];
    if (what == "scene" && words.size() == 7)
        one_scene(words[1], words[2], std::stoi(words[3]), std::stoi(words[4]), std::stoi(words[5]),
                  words[6]);
    else if (what == "scaling" && words.size() == 1)
        scaling();
    else if (what == "studies" && words.size() == 1)
        studies(256, 2);
    else if (what == "furnace" && words.size() == 4)
        furnace(words[1], std::stoi(words[2]), static_cast<std::uint32_t>(std::stoi(words[3])));
    else if (what == "tactics" && words.size() == 1)
        tactics_table(48, 256, 3);
    else {
        fmt::print(stderr,
                   "usage: reference_bench tactics|studies|scaling, furnace MODEL PIXELS BATCHES, "
                   "or scene NAME MODEL PIXELS SAMPLES SEEDS MASK\n");
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}

} // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return EXIT_FAILURE;
    }
}
