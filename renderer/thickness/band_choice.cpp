// Predicted changes from the moments of the bins.
#include "renderer/thickness/band_choice.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::thickness {

namespace {

constexpr double spare = 0.05;          // of the tolerance, before fewer bands are taken again
constexpr double dead_zone = 0.05;      // of L.V, before the paper's preset changes
constexpr int behind = 5, in_front = 2; // the paper's 25 and 4 coefficients

bool is_unit(glm::dvec3 direction) {
    return std::abs(glm::dot(direction, direction) - 1) <= 2e-6;
}

/// Y = sum over lights of per_length y(L): the picture is affine in it.
std::vector<double> together(int bands, std::span<const SeenLight> lights) {
    std::vector<double> sum(static_cast<std::size_t>(harmonics::coefficient_count(bands))),
        y(sum.size());
    for (const auto& light : lights) {
        EXPECTS(is_unit(light.to_light));
        harmonics::evaluate(bands, light.to_light, y);
        for (std::size_t i = 0; i < y.size(); ++i)
            sum[i] += light.per_length * y[i];
    }
    return sum;
}

double seen_rms(const NormalBins& bins, std::span<const double> y, glm::dvec3 to_eye) {
    double squares = 0, share = 0;
    for (const auto& bin : bins.bins)
        if (glm::dot(bin.normal, to_eye) > 0) {
            squares += bin.share * mean_square(bin, y);
            share += bin.share;
        }
    return share > 0 ? std::sqrt(std::max(0.0, squares / share)) : 0; // below 0 by rounding only
}

double without_first(const NormalBins& bins, std::vector<double> y, glm::dvec3 to_eye, int bands) {
    std::fill_n(y.begin(), harmonics::coefficient_count(bands), 0.0);
    return seen_rms(bins, y, to_eye);
}

int fewest_within(std::span<const double> predicted, double tolerance) {
    const auto found = std::find_if(predicted.begin(), predicted.end(),
                                    [&](double change) { return change <= tolerance; });
    return static_cast<int>(found - predicted.begin()) + 1; // the last is 0
}

} // namespace

double dropped_rms(const NormalBins& bins,
                   std::span<const SeenLight> lights,
                   glm::dvec3 to_eye,
                   int bands) {
    EXPECTS(bands >= 0 && bands <= bins.bands);
    EXPECTS(is_unit(to_eye));
    return without_first(bins, together(bins.bands, lights), to_eye, bands);
}

BandChoice choose_bands(const NormalBins& bins,
                        std::span<const SeenLight> lights,
                        glm::dvec3 to_eye,
                        double tolerance,
                        int previous) {
    EXPECTS(bins.bands >= 1);
    EXPECTS(is_unit(to_eye));
    const auto y = together(bins.bands, lights);
    std::vector<double> predicted;
    for (int n = 1; n < bins.bands; ++n)
        predicted.push_back(without_first(bins, y, to_eye, n));
    predicted.push_back(0);
    return choose_bands(std::move(predicted), tolerance, previous);
}

BandChoice choose_bands(std::vector<double> predicted, double tolerance, int previous) {
    EXPECTS(tolerance >= 0);
    EXPECTS(!predicted.empty() && predicted.back() == 0);
    BandChoice choice{.predicted = std::move(predicted)};
    const int available = static_cast<int>(choice.predicted.size());
    const int fewest = fewest_within(choice.predicted, tolerance);
    const int with_spare = fewest_within(choice.predicted, (1 - spare) * tolerance);
    choice.bands = fewest;
    choice.rule = fewest == available ? BandRule::Everything : BandRule::WithinTolerance;
    if (previous > fewest && with_spare > fewest) {
        choice.bands = std::min(previous, with_spare);
        choice.rule = BandRule::Held;
    }
    return choice;
}

BandChoice paper_bands(glm::dvec3 to_light, glm::dvec3 to_eye, int available, int previous) {
    EXPECTS(is_unit(to_light) && is_unit(to_eye));
    EXPECTS(available >= 1);
    const double cosine = glm::dot(to_light, to_eye);
    bool is_behind = cosine < 0;
    if (previous > 0 && std::abs(cosine) <= dead_zone)
        is_behind = previous > in_front;
    return {std::min(available, is_behind ? behind : in_front),
            is_behind ? BandRule::PaperBehind : BandRule::PaperInFront,
            {}};
}

std::string describe(const BandChoice& choice, double tolerance) {
    const std::string bands = choice.bands == 1 ? "1 band" : fmt::format("{} bands", choice.bands);
    if (choice.rule == BandRule::PaperBehind)
        return bands + ": the light is behind the object";
    if (choice.rule == BandRule::PaperInFront)
        return bands + ": the light is in front of the object";
    const auto n = static_cast<std::size_t>(choice.bands);
    EXPECTS(n >= 1 && n <= choice.predicted.size());
    if (choice.rule == BandRule::Everything)
        return n == 1 ? bands + ": there are no more"
                      : fmt::format("all {}: one less changes the picture by {:.2g}, {:.2g} is "
                                    "allowed",
                                    bands, choice.predicted[n - 2], tolerance);
    return fmt::format("{} of {} bands: the others change the picture by {:.2g}, {:.2g} is "
                       "allowed{}",
                       n, choice.predicted.size(), choice.predicted[n - 1], tolerance,
                       choice.rule == BandRule::Held ? " (kept from before)" : "");
}

} // namespace renderer::thickness
