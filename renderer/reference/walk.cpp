// The walk.
#include "renderer/reference/walk.h"

#include "renderer/contract.h"
#include "renderer/reference/flight.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace renderer::reference {

namespace {

// Below this optical thickness a flight through it is even to rounding.
constexpr double thin = 1e-12;

/// exp(-sigma length), 1 where nothing is in the way, however long.
double transmittance(double sigma, double length) {
    return sigma == 0 ? 1 : std::exp(-sigma * length);
}

template <std::size_t N>
Side side_of(const Path<N>& path) {
    return path.is_inside ? Side::Inside : Side::Outside;
}

/// The distance from the ray's origin at which `length` of the stretches has been covered.
double along_stretches(std::span<const Stretch> stretches, double length) {
    for (const auto& [begin, end] : stretches) {
        if (length <= end - begin)
            return begin + length;
        length -= end - begin;
    }
    return stretches.back().end; // by rounding
}

} // namespace

template <std::size_t N>
Walk<N>::Walk(const Medium& medium,
              const Boundary& boundary,
              const Body& body,
              BodyTracer& tracer,
              WalkEvents<N>& events,
              const WalkTactics& tactics)
    : medium_(medium), boundary_(boundary), tracer_(tracer), events_(events), tactics_(tactics),
      offset_(body.offset()), index_(boundary.kind == BoundaryKind::Matched ? 1 : medium.index) {
    EXPECTS(N == 3 || is_grey(medium));
    EXPECTS(medium.index > 0);
    EXPECTS(std::abs(medium.anisotropy) <= 0.999);
    for (std::size_t k = 0; k < N; ++k) {
        EXPECTS(medium.sigma_a[k] >= 0 && medium.sigma_s[k] >= 0);
        sigma_a_[k] = medium.sigma_a[k];
        sigma_s_[k] = medium.sigma_s[k];
        sigma_t_[k] = extinction(medium, k);
    }
    if (index_ == 1) // a polished or rough surface between equal indices is none
        boundary_.kind = BoundaryKind::Matched;
}

template <std::size_t N>
void Walk<N>::start(const Path<N>& path) {
    start_ = path;
    forces_first_ =
        boundary_.kind == BoundaryKind::Matched && tactics_.force_first && !path.is_inside;
    if (forces_first_)
        look_ahead();
}

template <std::size_t N>
void Walk<N>::follow(PathRandom& random) {
    Path<N> path = start_;
    if constexpr (N > 1)
        path.hero = std::min(N - 1, static_cast<std::size_t>(random.next() * N));
    const bool is_matched = boundary_.kind == BoundaryKind::Matched;
    Fate fate = Fate::Goes;
    if (forces_first_)
        fate = force_collision(path, random);
    while (fate == Fate::Goes) {
        if (is_matched)
            fate = fly_straight(path, random);
        else
            fate = path.is_inside ? fly_bounded(path, random) : approach(path, random);
    }
}

/// What all paths from the start have in common.
template <std::size_t N>
void Walk<N>::look_ahead() {
    const auto ahead = tracer_.along(start_.position, start_.direction, side_of(start_));
    ahead_.assign(ahead.begin(), ahead.end());
    whole_ = covered_by(ahead_);
    Spectrum<N> passing;
    for (std::size_t k = 0; k < N; ++k) {
        passing[k] = transmittance(sigma_t_[k], whole_);
        colliding_[k] = sigma_t_[k] == 0 ? 0 : -std::expm1(-sigma_t_[k] * whole_);
    }
    passing_ = start_;
    advance(passing_, passing, all_ones<N>(), {}); // the same for any hero
}

template <std::size_t N>
double Walk<N>::flight(const Path<N>& path, PathRandom& random) const {
    return flight_length(random.next(), sigma_t_[path.hero]);
}

/// Matched: a line may leave the body and come back in; only what it covers inside counts.
template <std::size_t N>
typename Walk<N>::Fate Walk<N>::fly_straight(Path<N>& path, PathRandom& random) {
    const double length = flight(path, random);
    if (path.is_inside && tracer_.is_clear(path.position, path.direction, length)) {
        path.position += length * path.direction;
        return collide(path, length, random);
    }
    const auto stretches = tracer_.along(path.position, path.direction, side_of(path));
    const bool is_outside = stretches.empty() || stretches.front().begin > 0;
    if (path.is_inside && is_outside && is_deep(path)) {
        events_.leaked();
        return Fate::Ends;
    }
    double covered = 0;
    for (const auto& [begin, end] : stretches) {
        if (length < covered + (end - begin)) {
            path.position += (begin + (length - covered)) * path.direction;
            path.is_inside = true;
            return collide(path, length, random);
        }
        covered += end - begin;
    }
    if (std::isinf(covered)) // for ever on, through a half-space
        return Fate::Ends;
    pass(path, covered);
    path.is_inside = false;
    events_.escaped(path);
    return Fate::Ends;
}

/// Matched, from outside: what passes unscattered is known exactly; the rest collides inside.
template <std::size_t N>
typename Walk<N>::Fate Walk<N>::force_collision(Path<N>& path, PathRandom& random) {
    if (!std::isinf(whole_))
        events_.escaped(passing_);
    if (whole_ == 0)
        return Fate::Ends;
    const double u = random.next(), sigma_h = sigma_t_[path.hero];
    if (sigma_h == 0 && std::isinf(whole_))
        return Fate::Ends;
    const double length = sigma_h * whole_ < thin
                              ? u * whole_
                              : std::min(whole_, -std::log1p(-u * colliding_[path.hero]) / sigma_h);
    Spectrum<N> scattered, absorbed, density;
    for (std::size_t k = 0; k < N; ++k) {
        const double reaching = transmittance(sigma_t_[k], length);
        scattered[k] = sigma_s_[k] * reaching;
        absorbed[k] = sigma_a_[k] * reaching;
        density[k] = sigma_t_[k] == 0 && std::isinf(whole_) ? 0
                     : sigma_t_[k] * whole_ < thin          ? 1 / whole_
                                                   : sigma_t_[k] * reaching / colliding_[k];
    }
    const auto stays = advance(path, scattered, density, absorbed);
    path.position += along_stretches(ahead_, length) * path.direction;
    path.is_inside = true;
    return turn(path, stays, random);
}

template <std::size_t N>
typename Walk<N>::Fate Walk<N>::fly_bounded(Path<N>& path, PathRandom& random) {
    const double length = flight(path, random);
    if (tracer_.is_clear(path.position, path.direction, length)) {
        path.position += length * path.direction;
        return collide(path, length, random);
    }
    const auto stretches = tracer_.along(path.position, path.direction, side_of(path));
    if (stretches.empty() || stretches.front().begin > 0) {
        if (is_deep(path)) {
            events_.leaked();
            return Fate::Ends;
        }
        path.is_inside = false;
        return Fate::Goes;
    }
    const double end = stretches.front().end;
    if (length < end) {
        path.position += length * path.direction;
        return collide(path, length, random);
    }
    if (std::isinf(end))
        return Fate::Ends;
    pass(path, end);
    return cross(path, end, random);
}

template <std::size_t N>
typename Walk<N>::Fate Walk<N>::approach(Path<N>& path, PathRandom& random) {
    const auto stretches = tracer_.along(path.position, path.direction, side_of(path));
    if (stretches.empty()) {
        events_.escaped(path);
        return Fate::Ends;
    }
    if (stretches.front().begin == 0 && offset_ > 0) {
        path.is_inside = true;
        return Fate::Goes;
    }
    return cross(path, stretches.front().begin, random);
}

/// Within rounding of the surface, at edges above all, a point may be on either side: the path then
/// goes on from where it is.  Farther in, being outside is a leak.
template <std::size_t N>
bool Walk<N>::is_deep(const Path<N>& path) {
    return tracer_.clearance(path.position) > 4 * offset_;
}

template <std::size_t N>
typename Walk<N>::Fate Walk<N>::cross(Path<N>& path, double distance, PathRandom& random) {
    const glm::dvec3 normal = tracer_.normal(distance);
    path.position += distance * path.direction;
    const glm::dvec3 facing = path.is_inside ? -normal : normal;
    const double index = path.is_inside ? 1 / index_ : index_;
    const bool was_inside = path.is_inside;
    const Fate fate = boundary_.kind == BoundaryKind::Smooth
                          ? cross_smooth(path, facing, index, random)
                          : cross_rough(path, facing, index, random);
    path.position += (path.is_inside == was_inside ? offset_ : -offset_) * facing;
    return fate;
}

template <std::size_t N>
typename Walk<N>::Fate
Walk<N>::cross_smooth(Path<N>& path, glm::dvec3 facing, double index, PathRandom& random) {
    const double reflectance = fresnel(-glm::dot(path.direction, facing), index);
    const auto behind = refracted(path.direction, facing, index);
    if (!behind || random.next() < reflectance) {
        path.direction = reflected(path.direction, facing);
    } else {
        path.direction = *behind;
        path.is_inside = !path.is_inside;
    }
    path.turn = {}; // nobody connects through a polished surface
    return Fate::Goes;
}

template <std::size_t N>
typename Walk<N>::Fate
Walk<N>::cross_rough(Path<N>& path, glm::dvec3 facing, double index, PathRandom& random) {
    const RoughSurface surface{facing, boundary_.roughness, index};
    while (true) {
        events_.met_surface(path, surface, random);
        const double u1 = random.next(), u2 = random.next(), u3 = random.next();
        const auto scattered = sample_rough(surface, -path.direction, u1, u2, u3);
        if (scattered && random.next() < scattered->unhidden) {
            path.turn = {.by = Turn::By::Surface,
                         .density = rough_density(surface, -path.direction, scattered->direction)};
            path.direction = scattered->direction;
            if (glm::dot(path.direction, facing) < 0)
                path.is_inside = !path.is_inside;
            return Fate::Goes;
        }
        // Hidden by other facets: it meets the surface again, from anywhere on its side.
        const double cosine = std::sqrt(1 - random.next());
        path.direction = -around(facing, cosine, random.next());
    }
}

/// The path has covered `length` without colliding.
template <std::size_t N>
void Walk<N>::pass(Path<N>& path, double length) const {
    if (N == 1) // what one channel loses is just what collided
        return;
    Spectrum<N> passing;
    for (std::size_t k = 0; k < N; ++k)
        passing[k] = transmittance(sigma_t_[k], length);
    advance(path, passing, passing, {});
}

/// The path, already there, has collided after `length`.
template <std::size_t N>
typename Walk<N>::Fate Walk<N>::collide(Path<N>& path, double length, PathRandom& random) {
    Spectrum<N> scattered, absorbed, density;
    const double sigma_h = sigma_t_[path.hero];
    for (std::size_t k = 0; k < N; ++k) {
        // relative to the hero's, so that nothing underflows over long flights
        const double reaching =
            (k == path.hero ? 1 : std::exp((sigma_h - sigma_t_[k]) * length)) / sigma_h;
        density[k] = sigma_t_[k] * reaching;
        scattered[k] = sigma_s_[k] * reaching;
        absorbed[k] = sigma_a_[k] * reaching;
    }
    const auto stays = advance(path, scattered, density, absorbed);
    return turn(path, stays, random);
}

/// The path has its weight after the collision: who looks on is told, chance decides whether it
/// goes on and whither.
template <std::size_t N>
typename Walk<N>::Fate
Walk<N>::turn(Path<N>& path, const Spectrum<N>& absorbed, PathRandom& random) {
    ++path.collisions;
    events_.collided(path, absorbed, random);
    const double greatest = *std::ranges::max_element(path.weight);
    if (!(greatest > 0))
        return Fate::Ends;
    if (path.collisions > tactics_.roulette_after && greatest < 1) {
        const bool survives = random.next() < greatest;
        Spectrum<N> change;
        for (std::size_t k = 0; k < N; ++k) {
            const double after = survives ? path.weight[k] / greatest : 0;
            change[k] = after - path.weight[k];
            path.weight[k] = after;
        }
        events_.gambled(change);
        if (!survives)
            return Fate::Ends;
    }
    choose_direction(path, random);
    return Fate::Goes;
}

template <std::size_t N>
void Walk<N>::choose_direction(Path<N>& path, PathRandom& random) const {
    const double g = medium_.anisotropy;
    const double u = random.next(), v = random.next();
    path.turn = {.by = Turn::By::Medium};
    if (g == 0) { // whither does not depend on whence
        path.direction = on_sphere(u, v);
        return;
    }
    path.turn.cosine = sample_henyey_greenstein(u, g);
    path.direction = around(path.direction, path.turn.cosine, v);
}

template class Walk<1>;
template class Walk<3>;

} // namespace renderer::reference
