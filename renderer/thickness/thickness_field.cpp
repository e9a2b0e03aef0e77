// Thickness by tracing every vertex toward every direction, projected as it is traced.
#include "renderer/thickness/thickness_field.h"

#include "renderer/contract.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/directions.h"
#include "renderer/harmonics/projection.h"
#include "renderer/thickness/percentile.h"
#include "renderer/thickness/traceable.h"

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

/// Each vertex's share of the surface, a third of the triangles around it, in units of 2^-40 of the
/// whole: integers, which add up the same in every order.
std::vector<std::uint64_t> area_shares(const Mesh& mesh) {
    std::vector<double> areas(mesh.positions.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions[a];
        const double area = glm::length(glm::cross(mesh.positions[b] - p, mesh.positions[c] - p));
        for (const auto corner : {a, b, c})
            areas[corner] += area;
    }
    const double total = std::accumulate(areas.begin(), areas.end(), 0.0);
    std::vector<std::uint64_t> shares;
    for (const double area : areas)
        shares.push_back(static_cast<std::uint64_t>(std::llround(area / total * 0x1p40)));
    return shares;
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

/// Rays that found no consistent answer, on all threads.  Too many fail the whole computation: then
/// there is no sense in going on, for each costs a sum over all triangles.
class Unresolved {
  public:
    explicit Unresolved(double rays) : rays_(rays) {}

    void report(std::uint64_t more) { count_ += more; }

    bool are_too_many() const {
        return static_cast<double>(count_.load()) > most_unresolved * rays_;
    }

    std::string message() const {
        return fmt::format(
            "more than {:.0f} of {:.0f} rays could not be resolved: their crossings do not add up "
            "to inside and outside; expected at most 1 in 10,000 on a closed mesh (is there a "
            "sheet without thickness?)",
            std::floor(most_unresolved * rays_), rays_);
    }

  private:
    double rays_;
    std::atomic<std::uint64_t> count_{0};
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
                 Unresolved& unresolved,
                 Take take) {
    const auto before = tracer.statistics().fallbacks;
    for (std::size_t i = 0; i < block.size(); ++i)
        take(i, length_of(kind, tracer.from_vertex(block[i], direction)));
    if (const auto more = tracer.statistics().fallbacks - before; more > 0)
        unresolved.report(more);
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

/// Adds values[v][j] times the j-th row to the coefficients of every vertex of a block.
void accumulate(std::span<const double> values,
                std::size_t directions,
                std::span<const double> rows,
                std::span<double> coefficients) {
    const std::size_t n = rows.size() / directions;
    for (std::size_t v = 0; v < values.size() / directions; ++v) {
        double* c = &coefficients[v * n];
        for (std::size_t j = 0; j < directions; ++j) {
            const double value = values[v * directions + j];
            if (value == 0)
                continue; // half of all: the light stands on this side
            const double* row = &rows[j * n];
            for (std::size_t i = 0; i < n; ++i)
                c[i] += value * row[i];
        }
    }
}

/// Traces one block toward all directions and writes the coefficients and energies of its vertices.
void project_block(const RayScene& scene,
                   Kind kind,
                   const Projection& projection,
                   std::span<const std::uint32_t> block,
                   std::span<const std::uint64_t> shares,
                   Unresolved& unresolved,
                   Totals& totals,
                   ThicknessField& field) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    InteriorTracer tracer(scene);
    LengthHistogram& lengths = totals.lengths.local();
    std::vector<double> coefficients(block.size() * n), values;
    const auto& [directions, weights] = projection.set;
    for (std::size_t first = 0; first < directions.size(); first += directions_per_chunk) {
        const std::size_t count = std::min(directions_per_chunk, directions.size() - first);
        values.assign(block.size() * count, 0);
        for (std::size_t j = 0; j < count && !unresolved.are_too_many(); ++j) {
            const double weight = weights[first + j];
            const auto take = [&](std::size_t i, double d) {
                const auto v = block[i];
                values[i * count + j] = d;
                field.energy[v] += weight * d * d;
                lengths.add(static_cast<float>(d / scene.model_per_scene()), shares[v]);
            };
            trace_block(tracer, kind, block, directions[first + j], unresolved, take);
        }
        accumulate(values, count, std::span(projection.rows).subspan(first * n, count * n),
                   coefficients);
    }
    for (std::size_t i = 0; i < block.size(); ++i)
        for (std::size_t k = 0; k < n; ++k)
            field.coefficients[block[i] * n + k] = static_cast<float>(coefficients[i * n + k]);
    totals.statistics.local() += tracer.statistics();
}

} // namespace

Expected<ThicknessField> compute_thickness_field(const geometry::Mesh& mesh,
                                                 const FieldOptions& options,
                                                 const Progress& progress) {
    EXPECTS(options.bands >= 1 && options.bands <= 6);
    const int n = harmonics::coefficient_count(options.bands);
    if (options.directions < 2 * n)
        return tl::unexpected(fmt::format("{} directions cannot carry {} coefficients, expected {} "
                                          "or more",
                                          options.directions, n, 2 * n));
    if (auto closed = check_closed(mesh); !closed)
        return tl::unexpected(closed.error());

    const RayScene scene(mesh);
    if (auto outward = check_components_face_outward(scene); !outward)
        return tl::unexpected(outward.error());
    const auto set =
        in_morton_order(harmonics::fibonacci_directions(options.directions, options.rotation_seed));
    const Projection projection{set, harmonics::projection_rows(options.bands, set)};
    const auto shares = area_shares(mesh);
    const std::size_t vertices = mesh.positions.size();

    ThicknessField field;
    field.bands = options.bands;
    field.coefficients.resize(vertices * static_cast<std::size_t>(n));
    field.energy.resize(vertices);
    Unresolved unresolved(static_cast<double>(vertices) * options.directions);
    Totals totals;
    std::mutex progress_mutex;
    std::size_t finished = 0;
    for_each_block(geometry::morton_order(scene.positions()),
                   [&](std::span<const std::uint32_t> block) {
                       project_block(scene, options.kind, projection, block, shares, unresolved,
                                     totals, field);
                       const std::lock_guard lock(progress_mutex);
                       finished += block.size();
                       if (progress)
                           progress(static_cast<double>(finished) / static_cast<double>(vertices));
                   });
    if (unresolved.are_too_many())
        return tl::unexpected(unresolved.message());

    LengthHistogram lengths;
    totals.lengths.combine_each([&](const LengthHistogram& part) { lengths += part; });
    totals.statistics.combine_each([&](const RayStatistics& part) { field.statistics += part; });
    field.d_n = lengths.percentile(0.995) * scene.model_per_scene();
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
    if (auto closed = check_closed(mesh); !closed)
        return tl::unexpected(closed.error());
    const RayScene scene(mesh);
    if (auto outward = check_components_face_outward(scene); !outward)
        return tl::unexpected(outward.error());
    std::vector<double> result(mesh.positions.size() * directions.size());
    Unresolved unresolved(static_cast<double>(result.size()));
    for_each_block(
        geometry::morton_order(scene.positions()), [&](std::span<const std::uint32_t> block) {
            InteriorTracer tracer(scene);
            for (std::size_t k = 0; k < directions.size() && !unresolved.are_too_many(); ++k)
                trace_block(tracer, kind, block, directions[k], unresolved, [&](auto i, double d) {
                    result[block[i] * directions.size() + k] = d;
                });
        });
    if (unresolved.are_too_many())
        return tl::unexpected(unresolved.message());
    return result;
}

} // namespace renderer::thickness
