// Student's half-widths and the loop.
#include "renderer/reference/convergence.h"

#include "renderer/contract.h"
#include "renderer/imaging/brightness.h"
#include "renderer/stopwatch.h"

#include <boost/math/distributions/students_t.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace renderer::reference {

namespace {

constexpr double most_leaks = 1e-6; // of the paths

std::vector<std::size_t> mask_of(const Film& film) {
    const double samples = std::ldexp(static_cast<double>(film.batches), film.log2_batch);
    std::vector<std::size_t> mask;
    for (std::size_t i = 0; i < film.covered.size(); ++i)
        if (film.covered[i] >= 0.999 * samples)
            mask.push_back(i);
    return mask;
}

/// Why no picture, or a wrong one, comes of it: of an open body its openings, else `closed`.
std::string why(const Picture& picture, const char* closed) {
    return picture.openings.empty()
               ? closed
               : fmt::format("its surface is open ({}), and light cannot be followed where nothing "
                             "bounds it; close it in a mesh editor",
                             picture.openings);
}

Expected<void> check_leaks(const Film& film, const Picture& picture) {
    if (static_cast<double>(film.leaks) <= most_leaks * static_cast<double>(film.paths) ||
        film.leaks <= 1)
        return {};
    return tl::unexpected(fmt::format(
        "{} of {} paths leaked out of the body, expected at most one in 10^6: {}", film.leaks,
        film.paths,
        why(picture,
            "its surface is closed; look for triangles that cross or all but touch, and mend them "
            "in a mesh editor")));
}

/// Infinite where nothing is allowed, and for what is no number: such a pixel is never good.
double squared_excess(double half_width, double allowed) {
    if (half_width == 0)
        return 0;
    const double quotient = half_width / allowed;
    return quotient >= 0 ? quotient * quotient : std::numeric_limits<double>::infinity();
}

} // namespace

Convergence judge(const Film& film, const std::vector<std::size_t>& mask, const StopRule& rule) {
    EXPECTS(!mask.empty());
    EXPECTS(film.batches > 1);
    double light = 0, squares = 0;
    for (const auto pixel : mask)
        for (const double channel : mean(film, pixel))
            light += channel / (3 * static_cast<double>(mask.size()));
    const double t = boost::math::quantile(boost::math::students_t(film.batches - 1.0), 0.975);
    std::vector<double> excess; // squared half-width over what is allowed, the worst channel's
    for (const auto pixel : mask) {
        const auto average = mean(film, pixel), error = standard_error(film, pixel);
        double worst = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double allowed = std::max(rule.relative * average[k], rule.of_mean * light);
            worst = std::max(worst, squared_excess(t * error[k], allowed));
            squares += error[k] * error[k] / (3 * static_cast<double>(mask.size()));
        }
        excess.push_back(worst);
    }
    Convergence state;
    const auto good = std::ranges::count_if(excess, [](double e) { return e <= 1; });
    state.good_share = static_cast<double>(good) / static_cast<double>(mask.size());
    const auto last = static_cast<std::size_t>(rule.share * static_cast<double>(mask.size() - 1));
    std::ranges::nth_element(excess, excess.begin() + static_cast<std::ptrdiff_t>(last));
    state.needed_batches = std::max<double>(rule.least_batches, film.batches * excess[last]);
    state.relative_error = squares == 0 ? 0
                           : light > 0  ? std::sqrt(squares) / light
                                        : std::numeric_limits<double>::infinity();
    state.converged = film.batches >= rule.least_batches && state.good_share >= rule.share;
    return state;
}

Expected<Outcome> render(const Picture& picture,
                         Film& film,
                         const StopRule& rule,
                         const TracerTactics& tactics,
                         const std::function<void(const Progress&)>& progress) {
    const Stopwatch watch;
    const auto in_time = [&] {
        return !rule.time_budget || watch.seconds() < rule.time_budget->count();
    };
    Outcome outcome;
    while (true) {
        if (film.batches >= 2) {
            const auto mask = mask_of(film);
            if (mask.empty())
                return tl::unexpected("no pixel is wholly covered by the object, expected some: " +
                                      why(picture, "move the camera nearer"));
            outcome.state = judge(film, mask, rule);
            if (progress)
                progress(
                    {std::min(1.0, film.batches / std::min<double>(outcome.state.needed_batches,
                                                                   rule.most_batches)),
                     outcome.state});
            if (outcome.state.converged || film.batches >= rule.most_batches)
                break;
        }
        // Two batches are the least that has an error: they are made however short the time.
        const bool may_stop = film.batches >= 2;
        if (!add_batch(picture, film, tactics, [&] { return !may_stop || in_time(); })) {
            outcome.out_of_time = true;
            break;
        }
    }
    outcome.seconds = watch.seconds();
    if (const auto sound = check_leaks(film, picture); !sound)
        return tl::unexpected(sound.error());
    return outcome;
}

} // namespace renderer::reference
