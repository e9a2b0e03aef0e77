// Paths from the camera, pixels in parallel.
#include "renderer/reference/path_tracer.h"

#include "renderer/contract.h"
#include "renderer/geometry/mesh_report.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/reference/light_collector.h"
#include "renderer/reference/mesh_body.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <numbers>
#include <variant>
#include <vector>

namespace renderer::reference {

namespace {

// Pixels of one task: enough to forget its start, few enough to keep all threads busy to the end.
constexpr std::size_t pixels_in_task = 256;

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
    LightCollector<N> collector(
        {picture.medium, picture.boundary, picture.illumination, *picture.body}, *tracer,
        tactics.light_threshold);
    Walk<N> walk(picture.medium, picture.boundary, *picture.body, *tracer, collector, tactics.walk);
    const Eye eye(picture.camera, film.width, film.height);
    const auto width = static_cast<std::size_t>(film.width);
    const int log2_paths = tactics.share_lines ? (film.log2_batch + 1) / 2 : 0;
    const int log2_lines = film.log2_batch - log2_paths;
    const std::uint32_t samples = 1u << film.log2_batch, paths = 1u << log2_paths;
    Counts counts;
    for (std::size_t pixel = first; pixel < last; ++pixel) {
        const auto number = static_cast<std::uint32_t>(pixel);
        const Strata strata(film.seed, number, film.batches);
        for (std::uint32_t s = 0; s < samples; s += paths) {
            const auto [x, y] = strata.in_pixel(s / paths, log2_lines);
            const auto path = eye.path<N>(static_cast<double>(pixel % width) + x,
                                          static_cast<double>(pixel / width) + y);
            if (tracer->along(path.position, path.direction, Side::Outside).empty())
                continue;
            walk.start(path);
            for (std::uint32_t i = s; i < s + paths; ++i) {
                PathRandom random({film.seed, number, film.batches, i, film.log2_batch}, strata);
                walk.follow(random);
            }
            batches[pixel].covered += paths;
            counts.paths += paths;
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

/// E = pi I_p
Spectrum<3> irradiance_of(LinearRgb intensity) {
    const auto channel = [](float light) { return std::numbers::pi * static_cast<double>(light); };
    return {channel(intensity.r), channel(intensity.g), channel(intensity.b)};
}

Illumination illumination_of(const renderer::Scene& scene, Radians half_angle) {
    Illumination illumination{matching_sky(scene), {}, {}};
    for (const auto& light : scene.lights) {
        const auto irradiance = irradiance_of(light.intensity);
        if (const auto* far = std::get_if<DirectionalLight>(&light.place))
            illumination.suns.push_back({glm::normalize(far->to_light), irradiance, half_angle});
        else if (const auto* near = std::get_if<PointLight>(&light.place))
            illumination.lamps.push_back({near->position, irradiance, near->reference.value});
    }
    return illumination;
}

} // namespace

Expected<Picture> picture_of_scene(const geometry::Mesh& mesh,
                                   const renderer::Scene& scene,
                                   const ReferenceSettings& settings) {
    const auto report = geometry::examine(mesh);
    Picture picture{.medium = medium_from_reduced(scene.material.medium, settings.anisotropy),
                    .boundary = settings.boundary,
                    .illumination = illumination_of(scene, settings.sun_half_angle),
                    .camera = scene.camera,
                    .openings = report.boundary.count > 0 ? describe_openings(report) : ""};
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
