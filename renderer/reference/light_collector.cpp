// Connections weighed against turns, in closed form per light.
#include "renderer/reference/light_collector.h"

#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace renderer::reference {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// How wrong a guess of the light from a sun may be: of the most it could be, anywhere, and of the
// likely, for each mean free path by which the depths nearby differ.  What is asked for by chance
// stays right whatever stands here; the time to equal error is least, and flat, at these.
constexpr double doubt_anywhere = 0.01, doubt_of_spread = 0.02;

/// A direction into a disc may be found by asking for the sun or by turning: each counts in
/// proportion to how likely it was to find it.  [Veach1995]
double share_of_connection(double disc, double turn_density) {
    return 1 / (1 + turn_density * disc);
}

double share_of_turn(double disc, double turn_density) {
    return turn_density == 0 ? 1 : turn_density * disc / (1 + turn_density * disc);
}

/// By how much `likely`, the share of a sun's light that passes the likely depth, may be wrong.
double doubt(double sigma, const DepthGuess& depth, double likely) {
    const double most = depth.least > 0 ? std::exp(-sigma * depth.least) : 1;
    const double apart = sigma * depth.spread;
    // e^apart to first order, twice over: the true depth may lie beyond those nearby.
    const double nearby = std::min(most, likely * (1 + 2 * apart));
    return doubt_anywhere * most + std::min(1.0, doubt_of_spread * apart) * nearby;
}

} // namespace

template <std::size_t N>
LightCollector<N>::LightCollector(const LitBody& lit, BodyTracer& tracer, double light_threshold)
    : medium_(lit.medium), illumination_(lit.illumination),
      kind_(lit.medium.index == 1 ? BoundaryKind::Matched : lit.boundary.kind), tracer_(tracer),
      offset_(lit.body.offset()), threshold_(light_threshold) {
    for (const auto& sun : lit.illumination.suns) {
        Disc disc{sun, solid_angle(sun), {}, sun.irradiance, nullptr};
        if (disc.solid_angle == 0 && kind_ == BoundaryKind::Matched)
            disc.depth = lit.body.sunward_depth(sun.to_light);
        // The irradiance of a facing surface is radiance times pi sin^2: a little less than the
        // disc's solid angle.
        const double sine = std::sin(sun.half_angle.value);
        for (std::size_t k = 0; k < 3 && disc.solid_angle > 0; ++k) {
            disc.radiance[k] = sun.irradiance[k] / (std::numbers::pi * sine * sine);
            disc.power[k] = disc.radiance[k] * disc.solid_angle;
        }
        discs_.push_back(disc);
    }
}

template <std::size_t N>
Spectrum<3> LightCollector<N>::taken() {
    const auto all = light_;
    light_ = {};
    return all;
}

template <std::size_t N>
void LightCollector<N>::collided(const Path<N>& path, const Spectrum<N>&, PathRandom& random) {
    if (kind_ != BoundaryKind::Matched || (discs_.empty() && illumination_.lamps.empty()))
        return;
    const double u = random.next_apart(); // one for all lights: each has its chance
    for (const auto& disc : discs_)
        if (disc.depth)
            collect_guessed(path, disc, u);
        else if (const double asking = drawn_asking(path, u))
            collect_scattered(path, to_disc(disc, random), asking);
    for (const auto& lamp : illumination_.lamps)
        if (const double asking = drawn_asking(path, u))
            if (const auto to = to_lamp(lamp, path.position))
                collect_scattered(path, *to, asking);
}

/// What the likely depth lets through counts always.  A ray is sent by chance, the more likely the
/// more the guess may be wrong, and what it finds to be missing counts for those not sent.
template <std::size_t N>
void LightCollector<N>::collect_guessed(const Path<N>& path, const Disc& disc, double u) {
    const auto depth = disc.depth->at(path.position);
    const double turned =
        henyey_greenstein(glm::dot(path.direction, disc.sun.to_light), medium_.anisotropy);
    Spectrum<N> likely{}, weight{};
    double worth = 0;
    for (std::size_t k = 0; k < N; ++k) {
        const double sigma = extinction(medium_, k);
        likely[k] = std::exp(-sigma * depth.likely);
        worth = std::max(worth, path.weight[k] * doubt(sigma, depth, likely[k]));
        weight[k] = path.weight[k] * turned * likely[k];
    }
    const double asking = worth < threshold_ ? worth / threshold_ : 1;
    if (u < asking) {
        const double length =
            interior_length(tracer_, path.position, disc.sun.to_light, Side::Inside);
        for (std::size_t k = 0; k < N; ++k) {
            const double missing = std::exp(-extinction(medium_, k) * length) - likely[k];
            weight[k] += path.weight[k] * turned * missing / asking;
        }
    }
    collect(weight, disc.power, 1);
}

template <std::size_t N>
void LightCollector<N>::met_surface(const Path<N>& path,
                                    const RoughSurface& surface,
                                    PathRandom& random) {
    for (const auto& disc : discs_)
        collect_reflected(path, surface, to_disc(disc, random));
    for (const auto& lamp : illumination_.lamps)
        if (const auto to = to_lamp(lamp, path.position))
            collect_reflected(path, surface, *to);
}

/// Per steradian; 0 where a connection was not possible.
template <std::size_t N>
double LightCollector<N>::turn_density(const Turn& turn) const {
    return turn.by == Turn::By::Medium ? henyey_greenstein(turn.cosine, medium_.anisotropy)
                                       : turn.density;
}

template <std::size_t N>
void LightCollector<N>::escaped(const Path<N>& path) {
    collect(path.weight, illumination_.sky, 1);
    for (const auto& disc : discs_)
        if (is_toward(disc.sun, path.direction))
            collect(path.weight, disc.radiance,
                    share_of_turn(disc.solid_angle, turn_density(path.turn)));
}

/// The probability of asking for a light, by what it could add at most; 0 where chance decides not
/// to.
template <std::size_t N>
double LightCollector<N>::drawn_asking(const Path<N>& path, double u) const {
    const double least_length = tracer_.clearance(path.position);
    double worth = 0;
    for (std::size_t k = 0; k < N; ++k)
        worth = std::max(worth, path.weight[k] * std::exp(-extinction(medium_, k) * least_length));
    if (worth >= threshold_)
        return worth > 0 ? 1 : 0;
    const double asking = worth / threshold_;
    return u < asking ? asking : 0;
}

template <std::size_t N>
typename LightCollector<N>::Connection LightCollector<N>::to_disc(const Disc& disc,
                                                                  PathRandom& random) const {
    glm::dvec3 direction = disc.sun.to_light;
    if (disc.solid_angle > 0) {
        const double u = random.next();
        direction = sample(disc.sun, u, random.next());
    }
    return {direction, infinity, disc.power, disc.solid_angle};
}

/// Nothing from where the lamp itself is.
template <std::size_t N>
std::optional<typename LightCollector<N>::Connection>
LightCollector<N>::to_lamp(const Lamp& lamp, glm::dvec3 from) const {
    const glm::dvec3 way = lamp.position - from;
    const double distance = glm::length(way);
    if (distance == 0)
        return std::nullopt;
    const double falloff = lamp.reference * lamp.reference / (distance * distance);
    const auto& [r, g, b] = lamp.irradiance;
    return Connection{way / distance, distance, {falloff * r, falloff * g, falloff * b}, 0};
}

/// What the medium turns from the light into the path at its collision.
template <std::size_t N>
void LightCollector<N>::collect_scattered(const Path<N>& path,
                                          const Connection& to,
                                          double asking) {
    const auto length = length_inside(path.position, Side::Inside, to);
    if (!length)
        return;
    const double turned =
        henyey_greenstein(glm::dot(path.direction, to.direction), medium_.anisotropy);
    Spectrum<N> weight;
    for (std::size_t k = 0; k < N; ++k)
        weight[k] = path.weight[k] * turned / asking * std::exp(-extinction(medium_, k) * *length);
    collect(weight, to.power, share_of_connection(to.disc, turned));
}

/// What a rough surface turns from the light into the path.
template <std::size_t N>
void LightCollector<N>::collect_reflected(const Path<N>& path,
                                          const RoughSurface& surface,
                                          const Connection& to) {
    const glm::dvec3 outward = path.is_inside ? -surface.normal : surface.normal;
    const glm::dvec3 from = path.position + offset_ * outward;
    if (glm::dot(to.direction, outward) <= 0)
        return;
    const double value = rough_value(surface, -path.direction, to.direction);
    if (value <= 0 || length_inside(from, Side::Outside, to).value_or(1) > 0)
        return;
    Spectrum<N> weight = path.weight;
    for (auto& w : weight)
        w *= value;
    collect(weight, to.power,
            share_of_connection(to.disc, rough_density(surface, -path.direction, to.direction)));
}

/// The length inside on the way; nothing when it has no end.
template <std::size_t N>
std::optional<double>
LightCollector<N>::length_inside(glm::dvec3 from, Side side, const Connection& to) {
    double length = 0;
    for (const auto& [begin, end] : tracer_.along(from, to.direction, side))
        if (begin < to.distance)
            length += std::min(end, to.distance) - begin;
    return std::isinf(length) ? std::nullopt : std::optional(length);
}

template <std::size_t N>
void LightCollector<N>::collect(const Spectrum<N>& weight, const Spectrum<3>& light, double share) {
    for (std::size_t k = 0; k < 3; ++k)
        light_[k] += share * weight[N == 1 ? 0 : k] * light[k];
}

template class LightCollector<1>;
template class LightCollector<3>;

} // namespace renderer::reference
