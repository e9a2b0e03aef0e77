// Paths from the camera, the light they collect, and pixels in parallel.
#include "renderer/reference/path_tracer.h"

#include "renderer/contract.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/reference/phase.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <vector>

namespace renderer::reference {

namespace {

// Pixels of one task: enough to forget its start, few enough to keep all threads busy to the end.
constexpr std::size_t pixels_in_task = 256;

/// Sums the light that finds a path.
template <std::size_t N>
class LightCollector final : public WalkEvents<N> {
  public:
    LightCollector(const Picture& picture, BodyTracer& tracer, double light_threshold)
        : medium_(picture.medium), illumination_(picture.illumination),
          kind_(picture.medium.index == 1 ? BoundaryKind::Matched : picture.boundary.kind),
          tracer_(tracer), offset_(picture.body->offset()), threshold_(light_threshold),
          disc_(solid_angle(picture.illumination.sun)), has_sun_(has_sun(picture.illumination)) {
        // The irradiance of a facing surface is radiance times pi sin^2: a little less than the
        // disc's solid angle.
        const double sine = std::sin(illumination_.sun.half_angle.value);
        for (std::size_t k = 0; k < 3; ++k) {
            const double e = illumination_.sun.irradiance[k];
            sun_radiance_[k] = disc_ > 0 ? e / (std::numbers::pi * sine * sine) : 0;
            sun_power_[k] = disc_ > 0 ? sun_radiance_[k] * disc_ : e;
        }
    }

    void collided(const Path<N>& path, const Spectrum<N>&, PathRandom& random) override {
        if (!has_sun_ || kind_ != BoundaryKind::Matched)
            return;
        const double worth = light_worth(path);
        const double asking = worth >= threshold_ ? 1 : worth / threshold_;
        if (asking <= 0 || (asking < 1 && random.next() >= asking))
            return;
        const glm::dvec3 to_light = toward_sun(random);
        const double turned =
            henyey_greenstein(glm::dot(path.direction, to_light), medium_.anisotropy);
        const double length = interior_length(tracer_, path.position, to_light);
        if (std::isinf(length))
            return;
        Spectrum<N> weight;
        for (std::size_t k = 0; k < N; ++k)
            weight[k] =
                path.weight[k] * turned / asking * std::exp(-extinction(medium_, k) * length);
        collect(weight, sun_power_, share_of_connection(turned));
    }

    void
    met_surface(const Path<N>& path, const RoughSurface& surface, PathRandom& random) override {
        if (!has_sun_)
            return;
        const glm::dvec3 to_light = toward_sun(random);
        const bool is_lit_side = (glm::dot(to_light, surface.normal) > 0) != path.is_inside;
        if (!is_lit_side)
            return;
        const double value = rough_value(surface, -path.direction, to_light);
        const glm::dvec3 outward = path.is_inside ? -surface.normal : surface.normal;
        if (value <= 0 || !tracer_.along(path.position + offset_ * outward, to_light).empty())
            return;
        Spectrum<N> weight = path.weight;
        for (auto& w : weight)
            w *= value;
        collect(weight, sun_power_,
                share_of_connection(rough_density(surface, -path.direction, to_light)));
    }

    void escaped(const Path<N>& path) override {
        collect(path.weight, illumination_.sky, 1);
        if (has_sun_ && is_toward(illumination_.sun, path.direction))
            collect(path.weight, sun_radiance_, share_of_turn(path.turn_density));
    }

    void gambled(const Spectrum<N>&) override {}

    void leaked() override { ++leaks_; }

    Spectrum<3> taken() {
        const auto all = light_;
        light_ = {};
        return all;
    }

    std::uint64_t leaks() const { return leaks_; }

  private:
    /// What a connection could add at most: weight times what the nearest surface lets through.
    double light_worth(const Path<N>& path) const {
        const double clearance = tracer_.clearance(path.position);
        double worth = 0;
        for (std::size_t k = 0; k < N; ++k)
            worth = std::max(worth, path.weight[k] * std::exp(-extinction(medium_, k) * clearance));
        return worth;
    }

    glm::dvec3 toward_sun(PathRandom& random) const {
        if (disc_ == 0)
            return illumination_.sun.to_light;
        const double u1 = random.next();
        return sample(illumination_.sun, u1, random.next());
    }

    /// A direction into the disc may be found by asking for the sun or by turning: each counts in
    /// proportion to how likely it was to find it.  [Veach1995]
    double share_of_connection(double turn_density) const {
        return disc_ == 0 ? 1 : 1 / (1 + turn_density * disc_);
    }

    double share_of_turn(double turn_density) const {
        return turn_density == 0 ? 1 : turn_density * disc_ / (1 + turn_density * disc_);
    }

    void collect(const Spectrum<N>& weight, const Spectrum<3>& light, double share) {
        for (std::size_t k = 0; k < 3; ++k)
            light_[k] += share * weight[N == 1 ? 0 : k] * light[k];
    }

    const Medium& medium_;
    const Illumination& illumination_;
    BoundaryKind kind_;
    BodyTracer& tracer_;
    double offset_, threshold_, disc_;
    bool has_sun_;
    Spectrum<3> sun_radiance_{}, sun_power_{}, light_{};
    std::uint64_t leaks_ = 0;
};

/// The line of sight through any point of the picture.
class Eye {
  public:
    Eye(const Camera& camera, int width, int height)
        : world_from_clip_(glm::inverse(camera.clip_from_view * camera.view_from_world)),
          width_(width), height_(height) {}

    /// `x` and `y` in pixels from the upper left corner; starts on the near plane.
    template <std::size_t N>
    Path<N> path(double x, double y) const {
        const double u = 2 * x / width_ - 1, v = 1 - 2 * y / height_;
        const glm::dvec4 near = world_from_clip_ * glm::dvec4(u, v, -1, 1);
        const glm::dvec4 far = world_from_clip_ * glm::dvec4(u, v, 1, 1);
        Path<N> path;
        path.position = glm::dvec3(near) / near.w;
        path.direction = glm::normalize(glm::dvec3(far) / far.w - path.position);
        return path;
    }

  private:
    glm::dmat4 world_from_clip_;
    double width_, height_;
};

struct Counts {
    std::uint64_t paths = 0, leaks = 0;
};

/// One batch of the pixels first..last-1.
template <std::size_t N>
Counts trace_pixels(const Picture& picture,
                    const Film& film,
                    const TracerTactics& tactics,
                    std::size_t first,
                    std::size_t last,
                    std::vector<PixelBatch>& batches) {
    const geometry::DenormalsAreZero guard;
    const auto tracer = picture.body->tracer();
    LightCollector<N> collector(picture, *tracer, tactics.light_threshold);
    Walk<N> walk(picture.medium, picture.boundary, *picture.body, *tracer, collector, tactics.walk);
    const Eye eye(picture.camera, film.width, film.height);
    const auto width = static_cast<std::size_t>(film.width);
    const std::uint32_t samples = 1u << film.log2_batch;
    Counts counts;
    for (std::size_t pixel = first; pixel < last; ++pixel) {
        for (std::uint32_t s = 0; s < samples; ++s) {
            PathRandom random(
                {film.seed, static_cast<std::uint32_t>(pixel), film.batches, s, film.log2_batch});
            const double x = static_cast<double>(pixel % width) + random.next();
            const double y = static_cast<double>(pixel / width) + random.next();
            const auto path = eye.path<N>(x, y);
            if (tracer->along(path.position, path.direction).empty())
                continue;
            walk.follow(path, random);
            batches[pixel].covered += 1;
            ++counts.paths;
        }
        batches[pixel].mean = collector.taken();
        for (auto& light : batches[pixel].mean)
            light /= samples;
    }
    counts.leaks = collector.leaks();
    return counts;
}

geometry::Mesh in_world(const geometry::Mesh& mesh, const Placement& placement) {
    geometry::Mesh placed = mesh;
    for (auto& position : placed.positions)
        position = glm::dvec3(placement.world_from_model * glm::dvec4(position, 1));
    return placed;
}

Spectrum<3> matching_sky(const renderer::Scene& scene) {
    const auto& k = scene.material.reflectance;
    const auto radiance = [](float light, float ambient, float body) {
        return body > 0 ? static_cast<double>(light * ambient / body) : 0.0;
    };
    return {radiance(scene.ambient.r, k.ambient.r, k.diffuse.r + k.scatter.r),
            radiance(scene.ambient.g, k.ambient.g, k.diffuse.g + k.scatter.g),
            radiance(scene.ambient.b, k.ambient.b, k.diffuse.b + k.scatter.b)};
}

} // namespace

Expected<Picture> picture_of_scene(const geometry::Mesh& mesh,
                                   const renderer::Scene& scene,
                                   const ReferenceSettings& settings) {
    const auto& i = scene.light.intensity;
    const auto irradiance = [](float intensity) {
        return std::numbers::pi * static_cast<double>(intensity);
    };
    Picture picture{.medium = medium_from_reduced(scene.material.medium, settings.anisotropy),
                    .boundary = settings.boundary,
                    .illumination = {.sky = matching_sky(scene),
                                     .sun = {glm::normalize(scene.light.to_light),
                                             {irradiance(i.r), irradiance(i.g), irradiance(i.b)},
                                             settings.sun_half_angle}},
                    .camera = scene.camera};
    if (const auto reachable = check_reachable(picture.illumination, picture.boundary); !reachable)
        return tl::unexpected(reachable.error());
    picture.body = make_mesh_body(in_world(mesh, scene.placement));
    return picture;
}

bool add_batch(const Picture& picture,
               Film& film,
               const TracerTactics& tactics,
               const std::function<bool()>& go_on) {
    EXPECTS(check_reachable(picture.illumination, picture.boundary).has_value());
    const std::size_t pixels = film.sum.size();
    const std::size_t tasks = (pixels + pixels_in_task - 1) / pixels_in_task;
    std::vector<PixelBatch> batches(pixels);
    std::vector<Counts> counts(tasks);
    std::atomic<bool> stopped = false;
    const bool grey = is_grey(picture.medium);
    tbb::parallel_for(std::size_t{0}, tasks, [&](std::size_t task) {
        if (stopped || !go_on()) {
            stopped = true;
            return;
        }
        const std::size_t first = task * pixels_in_task;
        const std::size_t last = std::min(first + pixels_in_task, pixels);
        counts[task] = grey ? trace_pixels<1>(picture, film, tactics, first, last, batches)
                            : trace_pixels<3>(picture, film, tactics, first, last, batches);
    });
    if (stopped)
        return false;
    for (std::size_t pixel = 0; pixel < pixels; ++pixel)
        add(film, pixel, batches[pixel]);
    for (const auto& count : counts) {
        film.paths += count.paths;
        film.leaks += count.leaks;
    }
    ++film.batches;
    return true;
}

} // namespace renderer::reference
