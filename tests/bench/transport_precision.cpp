// The long suite of transport: every anchor to a relative standard error that is asked for, as the
// tables of docs/precision-transport.md.  Ends with failure when any is off by more than 4.
//
// transport_precision RELATIVE_ERROR MOST_SECONDS > docs/precision-transport.md
#include "renderer/imaging/brightness.h"
#include "renderer/imaging/colour.h"
#include "renderer/imaging/errors.h"
#include "tests/renderer/reference/anchors.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace renderer::reference;
using anchors::Anchor;

/// Of the processor, all threads together: what else the machine does is not in it.
double processor_seconds() {
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// Anchors of one body and light: the same paths tell all of them.
using Problem = std::vector<Anchor>;

struct Result {
    EnergyBalance balance;
    double seconds = 0;
};

double worst_excess(const Problem& problem, const EnergyBalance& balance, double relative) {
    double worst = 0;
    for (const auto& anchor : problem)
        worst = std::max(worst, share_of(anchor, balance).standard_error / anchor.exact / relative);
    return worst;
}

/// A pilot says how many paths the error takes, and what they cost; where that is more than
/// `most_seconds`, ten times the error has to do, for a hundredth of it.
Result run(const Problem& problem, double relative, double most_seconds) {
    constexpr std::uint64_t pilot_paths = 1 << 18;
    EnergyRun run{.paths = pilot_paths, .seed = 11};
    double start = processor_seconds();
    const auto pilot = balance_of(problem.front(), run);
    const double pilot_seconds = processor_seconds() - start;
    double excess = 1.1 * std::pow(worst_excess(problem, pilot, relative), 2);
    if (excess * pilot_seconds > most_seconds)
        excess /= 100;
    run.paths =
        static_cast<std::uint64_t>(static_cast<double>(pilot_paths) * std::max(excess, 1.0));
    run.seed = 12;
    start = processor_seconds();
    const auto balance = balance_of(problem.front(), run);
    return {balance, processor_seconds() - start};
}

std::string name_of(const Anchor& anchor) {
    const auto& p = anchor.problem;
    const std::string shape = anchor.shape == anchors::Shape::Sphere
                                  ? fmt::format("sphere, radius {}", p.optical_thickness)
                              : std::isinf(p.optical_thickness)
                                  ? "half-space"
                                  : fmt::format("slab, {}", p.optical_thickness);
    return fmt::format("{} | {} | {} | {} | {}", shape, p.albedo, p.anisotropy, p.index,
                       p.incidence == Incidence::Normal ? "normal" : "diffuse");
}

const char* name_of(anchors::Quantity quantity) {
    return quantity == anchors::Quantity::Back      ? "back"
           : quantity == anchors::Quantity::Through ? "through"
                                                    : "escape";
}

std::vector<Problem> all_problems() {
    std::vector<Problem> problems;
    std::map<std::string, std::size_t> known;
    for (const auto& anchor : anchors::all()) {
        const auto [place, is_new] = known.try_emplace(name_of(anchor), problems.size());
        if (is_new)
            problems.emplace_back();
        problems[place->second].push_back(anchor);
    }
    return problems;
}

renderer::imaging::LinearImage plain(renderer::LinearRgb light) {
    constexpr int edge = 40;
    return {edge, edge, std::vector<renderer::LinearRgb>(edge * edge, light),
            std::vector<float>(edge * edge, 1.0F)};
}

/// Pictures whose errors can be worked out by hand: tests/renderer/imaging/errors_test.cpp does.
void print_image_measures() {
    namespace imaging = renderer::imaging;
    const auto errors = [](const imaging::LinearImage& x, const imaging::LinearImage& y) {
        return imaging::image_errors(x, y, imaging::covered_pixels(y.coverage)).value();
    };
    const auto flip = [](const imaging::LinearImage& x, const imaging::LinearImage& y) {
        return static_cast<double>(
            imaging::ldr_flip(x, y, imaging::default_pixels_per_degree).at(20, 20));
    };
    const auto grey = [](double light) {
        const auto y = static_cast<float>(light);
        return plain({y, y, y});
    };
    const auto lightness = [&](double l) { return grey(std::pow((l + 16) / 116, 3)); };
    const auto e = errors(plain({0.5F, 0.4F, 0.4F}), plain({0.2F, 0.4F, 0.4F}));
    const double d = imaging::srgb_from_linear(0.5) - imaging::srgb_from_linear(0.2);
    const double a = imaging::srgb_from_linear(0.5), b = imaging::srgb_from_linear(0.25);
    fmt::print("\n# Precision of image measures\n\n| measure | case | by hand | computed |\n"
               "|---|---|---|---|\n");
    const auto row = [](const char* measure, const char* what, double exact, double computed) {
        fmt::print("| {} | {} | {:.6g} | {:.6g} |\n", measure, what, exact, computed);
    };
    row("RMSE", "one channel of three off by 0.3", std::sqrt(0.03), e.rmse);
    row("MAE", "the same", 0.1, e.mae);
    row("relMSE", "the same, where the reference is 0.2", 0.6, e.rel_mse);
    row("PSNR", "the same, encoded", -10 * std::log10(d * d / 3), e.psnr);
    row("SSIM", "even greys 0.5 and 0.25", (2 * a * b + 1e-4) / (a * a + b * b + 1e-4),
        errors(grey(0.5), grey(0.25)).ssim);
    row("LDR-FLIP", "green and blue", 1, flip(plain({0, 1, 0}), plain({0, 0, 1})));
    row("LDR-FLIP", "white and black", 0.96739, flip(grey(1), grey(0)));
    row("LDR-FLIP", "lightness 50 and 51", 0.05755, flip(lightness(50), lightness(51)));
    const auto same = errors(grey(0.3), grey(0.3));
    row("HDR-FLIP", "equal pictures", 0, same.hdr_flip);
    row("PSNR", "equal pictures", std::numeric_limits<double>::infinity(), same.psnr);
}

/// What all lines say together.
struct Account {
    int lines = 0, failures = 0, met = 0, met_tenfold = 0;
    double squares = 0, seconds = 0;
};

void print_lines(const Problem& problem, const Result& result, double relative, Account& account) {
    account.seconds += result.seconds;
    for (const auto& anchor : problem) {
        const auto estimate = share_of(anchor, result.balance);
        const double error = estimate.standard_error / anchor.exact;
        const double z = (estimate.value - anchor.exact) /
                         std::hypot(estimate.standard_error, anchor.exact_error);
        fmt::print("| {} | {} | {:.9g} | {:.7f} | {:.1e} | {:.1e} | {:+.2f} | {:.2e} | {:.1f} |\n",
                   name_of(anchor), name_of(anchor.quantity), anchor.exact, estimate.value,
                   estimate.standard_error, error, z, static_cast<double>(result.balance.paths),
                   result.seconds);
        ++account.lines;
        account.failures += std::abs(z) <= 4 ? 0 : 1;
        account.met += error <= relative ? 1 : 0;
        account.met_tenfold += error <= 10 * relative ? 1 : 0;
        account.squares += z * z;
    }
    std::fflush(stdout); // a run that is cut short leaves what it has
}

} // namespace

int main(int argc, char** argv) {
    const double relative = argc > 1 ? std::atof(argv[1]) : 1e-4;
    const double most_seconds = argc > 2 ? std::atof(argv[2]) : 600;
    fmt::print(
        "# Precision of transport\n\n"
        "Written by `transport_precision {0:g} {1:g}` on {2:%Y-%m-%d}: a relative standard error "
        "of "
        "{0:g} for every body and light where that takes at most {1:g} s of the processor, ten "
        "times "
        "as much for the others. z is the deviation in standard errors of estimate and exact value "
        "together.\n\n"
        "| body | albedo | g | index | incidence | light | exact | estimate | standard error "
        "| relative | z | paths | s |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
        relative, most_seconds, fmt::gmtime(std::time(nullptr)));
    Account account;
    for (const auto& problem : all_problems())
        print_lines(problem, run(problem, relative, most_seconds), relative, account);
    fmt::print("\n{} of {} within 4 standard errors; root mean square of z {:.2f}; {} to {:g}, {} "
               "to {:g}; "
               "{:.0f} s of the processor in all.\n",
               account.lines - account.failures, account.lines,
               std::sqrt(account.squares / account.lines), account.met, relative,
               account.met_tenfold, 10 * relative, account.seconds);
    print_image_measures();
    return account.failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
