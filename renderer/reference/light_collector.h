// The light that finds a path: connections to suns and lamps, and the sky where it escapes.
#pragma once

#include "renderer/reference/body.h"
#include "renderer/reference/illumination.h"
#include "renderer/reference/sunward_depth.h"
#include "renderer/reference/walk.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace renderer::reference {

/// What a connection needs of the scene; all of it outlives the collector.
struct LitBody {
    const Medium& medium;
    Boundary boundary;
    const Illumination& illumination;
    const Body& body;
};

/// Sums what arrives along the paths it is told of.
template <std::size_t N>
class LightCollector final : public WalkEvents<N> {
  public:
    /// A collision asks for a lamp or a disc with a probability that falls with what it could add
    /// at most, and for a sun whose depth is guessed with one that falls with what the guess may
    /// miss: below `light_threshold`, in proportion.  0: always.
    LightCollector(const LitBody& lit, BodyTracer& tracer, double light_threshold);

    void collided(const Path<N>& path, const Spectrum<N>& absorbed, PathRandom& random) override;
    void met_surface(const Path<N>& path, const RoughSurface& surface, PathRandom& random) override;
    void escaped(const Path<N>& path) override;

    void gambled(const Spectrum<N>&) override {}

    void leaked() override { ++leaks_; }

    /// The sum since it was last taken.
    Spectrum<3> taken();

    std::uint64_t leaks() const { return leaks_; }

  private:
    /// One way to a light.
    struct Connection {
        glm::dvec3 direction{};
        double distance = 0; ///< infinite to a sun
        Spectrum<3> power{}; ///< irradiance of a facing surface there
        double disc = 0;     ///< solid angle the light was sampled over; 0 for a point
    };

    /// A sun with what is always asked of it.
    struct Disc {
        Sun sun;
        double solid_angle = 0;
        Spectrum<3> radiance{}, power{};
        std::shared_ptr<const SunwardDepth> depth; ///< of a single direction; null when unknown
    };

    double turn_density(const Turn& turn) const;
    double drawn_asking(const Path<N>& path, double u) const;
    Connection to_disc(const Disc& disc, PathRandom& random) const;
    std::optional<Connection> to_lamp(const Lamp& lamp, glm::dvec3 from) const;
    void collect_guessed(const Path<N>& path, const Disc& disc, double u);
    void collect_scattered(const Path<N>& path, const Connection& to, double asking);
    void collect_reflected(const Path<N>& path, const RoughSurface& surface, const Connection& to);
    std::optional<double> length_inside(glm::dvec3 from, Side side, const Connection& to);
    void collect(const Spectrum<N>& weight, const Spectrum<3>& light, double share);

    const Medium& medium_;
    const Illumination& illumination_;
    BoundaryKind kind_;
    BodyTracer& tracer_;
    double offset_, threshold_;
    std::vector<Disc> discs_;
    Spectrum<3> light_{};
    std::uint64_t leaks_ = 0;
};

extern template class LightCollector<1>;
extern template class LightCollector<3>;

} // namespace renderer::reference
