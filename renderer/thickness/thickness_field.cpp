// Thickness by tracing every vertex toward every direction, projected as it is traced.
#include "renderer/thickness/thickness_field.h"

#include "renderer/contract.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/harmonics/projection.h"
#include "renderer/thickness/percentile.h"
#include "renderer/thickness/solid.h"
#include "renderer/thickness/surface_shares.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <tbb/combinable.h>
#include <tbb/parallel_for.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>

namespace renderer::thickness {

namespace {

using geometry::InteriorTracer;
using geometry::Mesh;
using geometry::RayScene;
using geometry::RayStatistics;
using geometry::Segment;

// Neighbouring vertices traced together in one direction find the same part of the tree in the
// cache: twice as fast as all directions of one vertex after another.
constexpr std::size_t vertices_per_block = 512;

// Thickness of one block toward so many directions waits to be projected: 64 kB.
constexpr std::size_t directions_per_chunk = 32;

constexpr double most_unresolved = 1e-4; // of all rays

double length_of(Kind kind, std::span<const Segment> segments) {
    if (segments.empty())
        return 0;
    switch (kind) {
    case Kind::Sum:
        return std::accumulate(
            segments.begin(), segments.end(), 0.0,
            [](double sum, const Segment& segment) { return sum + segment.end - segment.begin; });
    case Kind::First:
        return segments.front().begin == 0 ? segments.front().end : 0;
    case Kind::Span:
        return segments.back().end;
    }
    return 0;
}

/// Work on the vertices of one block at a time, on all threads.  `work(block)` gets positions in
/// `order`; blocks share nothing, so their sequence does not matter.
template <class Work>
void for_each_block(std::span<const std::uint32_t> order, Work work) {
    const std::size_t blocks = (order.size() + vertices_per_block - 1) / vertices_per_block;
    tbb::parallel_for(std::size_t{0}, blocks, [&](std::size_t block) {
        const geometry::DenormalsAreZero guard;
        const std::size_t begin = block * vertices_per_block;
        work(order.subspan(begin, std::min(vertices_per_block, order.size() - begin)));
    });
}

/// Whether all threads should go on: nobody asked to stop, and not too many rays found no
/// consistent answer.  Too many fail the whole computation: then there is no sense in going on, for
/// each costs a sum over all triangles.
class Proceedings {
  public:
    Proceedings(double rays, std::stop_token stop) : rays_(rays), stop_(std::move(stop)) {}

    void report_unresolved(std::uint64_t more) { unresolved_ += more; }

    bool go_on() const { return !stop_.stop_requested() && !are_too_many(); }

    /// Why they did not.
    Expected<void> outcome() const {
        if (stop_.stop_requested())
            return tl::unexpected<std::string>("cancelled before all rays were traced");
        if (are_too_many())
            return tl::unexpected(fmt::format(
                "more than {:.0f} of {:.0f} rays could not be resolved: their crossings do not add "
                "up to inside and outside; expected at most 1 in 10,000 on a closed mesh (is there "
                "a sheet without thickness?)",
                std::floor(most_unresolved * rays_), rays_));
        return {};
    }

  private:
    bool are_too_many() const {
        return static_cast<double>(unresolved_.load()) > most_unresolved * rays_;
    }

    double rays_;
    std::stop_token stop_;
    std::atomic<std::uint64_t> unresolved_{0};
};

/// What all threads fill together; everything in it adds up the same in every order.
struct Totals {
    tbb::combinable<LengthHistogram> lengths;
    tbb::combinable<RayStatistics> statistics;
};

/// Thickness of every vertex of a block in one direction; handed to `take(position in block, d)`.
template <class Take>
void trace_block(InteriorTracer& tracer,
                 Kind kind,
                 std::span<const std::uint32_t> block,
                 glm::dvec3 direction,
                 Proceedings& proceedings,
                 Take take) {
    const auto before = tracer.statistics().fallbacks;
    tracer.from_vertices(block, direction, [&](std::size_t i, std::span<const Segment> segments) {
        take(i, length_of(kind, segments));
    });
    if (const auto more = tracer.statistics().fallbacks - before; more > 0)
        proceedings.report_unresolved(more);
}

/// The same rule with neighbouring directions one after the other: what the last direction brought
/// into the cache serves the next, 4 % of the whole.
harmonics::DirectionSet in_morton_order(const harmonics::DirectionSet& set) {
    std::vector<glm::vec3> halves;
    for (const auto& direction : set.directions)
        halves.emplace_back(0.5 * direction);
    harmonics::DirectionSet ordered;
    for (const auto j : geometry::morton_order(halves)) {
        ordered.directions.push_back(set.directions[j]);
        ordered.weights.push_back(set.weights[j]);
    }
    return ordered;
}

struct Projection {
    harmonics::DirectionSet set;
    std::vector<double> rows; ///< of harmonics::projection_rows
};

/// What every block needs to know.
struct Task {
    const Solid& solid;
    Kind kind;
    Projection projection;
    std::vector<std::uint64_t> shares; ///< of the vertices
};

/// Traces one block toward all directions and writes the coefficients and energies of its vertices.
void project_block(const Task& task,
                   std::span<const std::uint32_t> block,
                   Proceedings& proceedings,
                   Totals& totals,
                   ThicknessField& field) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    InteriorTracer tracer = task.solid.tracer();
    const double model_per_scene = task.solid.scene().model_per_scene();
    LengthHistogram& lengths = totals.lengths.local();
    std::vector<double> coefficients(block.size() * n), values;
    const auto& [directions, weights] = task.projection.set;
    for (std::size_t first = 0; first < directions.size(); first += directions_per_chunk) {
        const std::size_t count = std::min(directions_per_chunk, directions.size() - first);
        values.assign(block.size() * count, 0);
        for (std::size_t j = 0; j < count && proceedings.go_on(); ++j) {
            const double weight = weights[first + j];
            const auto take = [&](std::size_t i, double d) {
                if (d == 0)
                    return; // half of all: the light stands on this side
                const auto v = block[i];
                values[i * count + j] = d;
                field.energy[v] += weight * d * d;
                lengths.add(static_cast<float>(d / model_per_scene), task.shares[v]);
            };
            trace_block(tracer, task.kind, block, directions[first + j], proceedings, take);
        }
        harmonics::accumulate(values, count,
                              std::span(task.projection.rows).subspan(first * n, count * n),
                              coefficients);
    }
    for (std::size_t i = 0; i < block.size(); ++i)
        for (std::size_t k = 0; k < n; ++k)
            field.coefficients[block[i] * n + k] = static_cast<float>(coefficients[i * n + k]);
    totals.statistics.local() += tracer.statistics();
}

Projection projection_of(const FieldOptions& options) {
    const auto set =
        in_morton_order(harmonics::fibonacci_directions(options.directions, options.rotation_seed));
    return {set, harmonics::projection_rows(options.bands, set)};
}

/// Coefficients, energies and what adds up over all rays.
Expected<void> trace_field(const Task& task,
                           const Progress& progress,
                           const std::stop_token& stop,
                           ThicknessField& field) {
    const std::size_t vertices = task.solid.vertices().size();
    const double model_per_scene = task.solid.scene().model_per_scene();
    Proceedings proceedings(static_cast<double>(vertices) *
                                static_cast<double>(task.projection.set.directions.size()),
                            stop);
    Totals totals;
    std::mutex progress_mutex;
    std::size_t finished = 0;
    for_each_block(geometry::morton_order(task.solid.vertices()),
                   [&](std::span<const std::uint32_t> block) {
                       if (!proceedings.go_on())
                           return;
                       project_block(task, block, proceedings, totals, field);
                       const std::lock_guard lock(progress_mutex);
                       finished += block.size();
                       if (progress && proceedings.go_on())
                           progress(static_cast<double>(finished) / static_cast<double>(vertices));
                   });
    if (auto outcome = proceedings.outcome(); !outcome)
        return outcome;

    LengthHistogram lengths;
    totals.lengths.combine_each([&](const LengthHistogram& part) { lengths += part; });
    totals.statistics.combine_each([&](const RayStatistics& part) { field.statistics += part; });
    for (const double fraction : {0.5, 0.9, 0.95, 0.99, 0.995, 0.999})
        field.percentiles.push_back({fraction, lengths.percentile(fraction) * model_per_scene});
    field.d_n = lengths.percentile(0.995) * model_per_scene;
    return {};
}

} // namespace

Expected<ThicknessField> compute_thickness_field(const geometry::Mesh& mesh,
                                                 const FieldOptions& options,
                                                 const Progress& progress,
                                                 const std::stop_token& stop) {
    EXPECTS(options.bands >= 1 && options.bands <= 6);
    const int n = harmonics::coefficient_count(options.bands);
    if (options.directions < 2 * n)
        return tl::unexpected(fmt::format("{} directions cannot carry {} coefficients, expected {} "
                                          "or more",
                                          options.directions, n, 2 * n));
    const auto solid = Solid::of(mesh);
    if (!solid)
        return tl::unexpected(solid.error());
    ThicknessField field;
    field.bands = options.bands;
    field.options = options;
    field.bounds = geometry::bounding_sphere(mesh);
    field.coefficients.resize(mesh.positions.size() * static_cast<std::size_t>(n));
    field.energy.resize(mesh.positions.size());
    const Task task{**solid, options.kind, projection_of(options), surface_shares(mesh)};
    if (auto traced = trace_field(task, progress, stop, field); !traced)
        return tl::unexpected(traced.error());
    field.normal_bins = bin_by_normal(mesh, field.coefficients, field.bands);
    return field;
}

double
reconstruct(const ThicknessField& field, std::size_t v, std::span<const double> basis, int bands) {
    EXPECTS(bands >= 1 && bands <= field.bands);
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const auto used = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    EXPECTS(basis.size() >= used && (v + 1) * stride <= field.coefficients.size());
    double sum = 0;
    for (std::size_t i = 0; i < used; ++i)
        sum += static_cast<double>(field.coefficients[v * stride + i]) * basis[i];
    return sum;
}

Expected<std::vector<double>>
trace_thickness(const geometry::Mesh& mesh, Kind kind, std::span<const glm::dvec3> directions) {
    return ThicknessTracer::prepare(mesh).and_then(
        [&](const ThicknessTracer& tracer) { return tracer.trace(kind, directions); });
}

ThicknessTracer::ThicknessTracer(std::shared_ptr<const Solid> solid)
    : solid_(std::move(solid)), order_(geometry::morton_order(solid_->vertices())) {}

Expected<ThicknessTracer> ThicknessTracer::prepare(const geometry::Mesh& mesh) {
    return Solid::of(mesh).map([](auto solid) { return ThicknessTracer(std::move(solid)); });
}

Expected<std::vector<double>> ThicknessTracer::trace(Kind kind,
                                                     std::span<const glm::dvec3> directions) const {
    std::vector<double> result(order_.size() * directions.size());
    Proceedings proceedings(static_cast<double>(result.size()), {});
    for_each_block(order_, [&](std::span<const std::uint32_t> block) {
        InteriorTracer tracer = solid_->tracer();
        for (std::size_t k = 0; k < directions.size() && proceedings.go_on(); ++k)
            trace_block(tracer, kind, block, directions[k], proceedings,
                        [&](auto i, double d) { result[block[i] * directions.size() + k] = d; });
    });
    if (auto outcome = proceedings.outcome(); !outcome)
        return tl::unexpected(outcome.error());
    return result;
}

} // namespace renderer::thickness
