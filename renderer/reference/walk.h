// One path of light through a translucent body: flight, collision, turn, and what the surface does.
#pragma once

#include "renderer/reference/body.h"
#include "renderer/reference/boundary.h"
#include "renderer/reference/medium.h"
#include "renderer/reference/microfacets.h"
#include "renderer/reference/path.h"
#include "renderer/reference/random.h"

#include <glm/vec3.hpp>

#include <vector>

namespace renderer::reference {

/// Who is told what happens on the way.
template <std::size_t N>
class WalkEvents {
  public:
    virtual ~WalkEvents() = default;

    /// The path has been scattered at its position; its weight has the albedo in it, its direction
    /// is still that of arrival.  `absorbed` is what stayed there.
    virtual void collided(const Path<N>& path, const Spectrum<N>& absorbed, PathRandom& random) = 0;

    /// The path is at a rough surface; `surface` faces the side it comes from.
    virtual void
    met_surface(const Path<N>& path, const RoughSurface& surface, PathRandom& random) = 0;

    /// The path has left for good; its weight is what arrives.
    virtual void escaped(const Path<N>& path) = 0;

    /// Roulette has changed the path's weight by `change`, zero on average.
    virtual void gambled(const Spectrum<N>& change) = 0;

    /// An origin inside was found outside: the path has been ended.
    virtual void leaked() = 0;
};

/// What a walk does to be quick; no choice changes what it finds on average.
struct WalkTactics {
    int roulette_after = 32; ///< collisions
    bool force_first =
        true; ///< matched: every first flight from outside collides, what passes is exact
};

template <std::size_t N>
class Walk {
  public:
    /// All must outlive the walk.  For N = 1 the medium is grey (EXPECTS).
    Walk(const Medium& medium,
         const Boundary& boundary,
         const Body& body,
         BodyTracer& tracer,
         WalkEvents<N>& events,
         const WalkTactics& tactics = {});

    /// Where the paths that are followed start, outside or inside, and what they carry.
    void start(const Path<N>& path);

    /// Follows one path from there until it escapes or fades.
    void follow(PathRandom& random);

  private:
    enum class Fate { Goes, Ends };

    void look_ahead();
    double flight(const Path<N>& path, PathRandom& random) const;
    Fate fly_straight(Path<N>& path, PathRandom& random);
    Fate fly_bounded(Path<N>& path, PathRandom& random);
    Fate force_collision(Path<N>& path, PathRandom& random);
    Fate approach(Path<N>& path, PathRandom& random);
    bool is_deep(const Path<N>& path);
    Fate cross(Path<N>& path, double distance, PathRandom& random);
    Fate cross_smooth(Path<N>& path, glm::dvec3 facing, double index, PathRandom& random);
    Fate cross_rough(Path<N>& path, glm::dvec3 facing, double index, PathRandom& random);
    void pass(Path<N>& path, double length) const;
    Fate collide(Path<N>& path, double length, PathRandom& random);
    Fate turn(Path<N>& path, const Spectrum<N>& absorbed, PathRandom& random);
    void choose_direction(Path<N>& path, PathRandom& random) const;

    const Medium& medium_;
    Boundary boundary_;
    BodyTracer& tracer_;
    WalkEvents<N>& events_;
    WalkTactics tactics_;
    double offset_;
    double index_;
    Spectrum<N> sigma_t_{}, sigma_s_{}, sigma_a_{};

    Path<N> start_;
    bool forces_first_ = false;  // matched, and from outside; then of the first line:
    std::vector<Stretch> ahead_; // inside
    double whole_ = 0;           // length of that, the body's units; may be infinite
    Spectrum<N> colliding_{};    // 1 - e^(-sigma whole)
    Path<N> passing_;            // what comes out without a collision
};

extern template class Walk<1>;
extern template class Walk<3>;

} // namespace renderer::reference
