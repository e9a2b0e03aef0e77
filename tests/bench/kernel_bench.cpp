// What the innermost loops take: for every row nanoseconds of processor time for one item, and what
// of it does not depend on the clock: cycles and instructions.
//
// kernel_bench [--benchmark_filter=REGEX ...]   the tables of docs/benchmarks.md, on one core
//
// A cycle is a third of a multiplication that waits for the one before, which is what every
// processor of this kind has taken for years; the row of it runs among the others.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/crossings.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"
#include "renderer/harmonics/projection.h"
#include "renderer/reference/energy.h"
#include "renderer/reference/mesh_body.h"
#include "renderer/thickness/thickness_field.h"
#include "tests/bench/instruction_counter.h"
#include "tests/bench/kernel_table.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <string>
#include <vector>

namespace {

using namespace renderer;

const bench::InstructionCounter counter;
bench::KernelTable table(counter.way());

struct Row {
    std::string name;
    benchmark::State& state;
};

/// Runs `work`, which does so many items at a time, as often as asked for; its instructions are
/// counted when the row runs first.
template <class Work>
void measure(const Row& row, std::size_t items, Work work) {
    work(); // what is made once is not what is measured
    for (auto _ : row.state)
        work();
    const auto n = static_cast<double>(items);
    const auto all = static_cast<double>(row.state.iterations()) * n;
    row.state.SetItemsProcessed(static_cast<std::int64_t>(all));
    if (!table.has_instructions(row.name))
        if (const auto instructions = counter.count(work))
            table.set_instructions(row.name, static_cast<double>(*instructions) / n);
}

void waiting_multiplications(const Row& row) {
#ifdef __x86_64__
    std::uint64_t x = 1;
    const std::uint64_t factor = 0x9e3779b97f4a7c15u;
    measure(row, 1000, [&] {
        for (int i = 0; i < 1000; ++i)
            asm volatile("imul %1, %0" : "+r"(x) : "r"(factor));
    });
#else
    row.state.SkipWithError("known for x86 only");
#endif
}

/// As many blocks as stay in the first level of cache with their values.
template <class T>
void blocks_in_cache(const Row& row, int bands, harmonics::InstructionSet set) {
    const auto n = static_cast<std::size_t>(bands * bands);
    const std::size_t count = std::max<std::size_t>(1, 256 / n);
    const auto width = static_cast<std::size_t>(harmonics::lanes<T>);
    const auto directions =
        harmonics::fibonacci_directions(static_cast<int>(count * width), 1).directions;
    const auto blocks = harmonics::in_blocks<T>(directions);
    std::vector<harmonics::Line<T>> values(count * n);
    measure(row, directions.size(), [&] {
        harmonics::evaluate_blocks<T>(bands, blocks, values, set);
        benchmark::DoNotOptimize(values.data());
        benchmark::ClobberMemory();
    });
}

/// The road of the product's own loops: from vectors to values, packing and checks included.
void from_vectors(const Row& row, int bands) {
    const auto directions = harmonics::fibonacci_directions(4096, 1).directions;
    measure(row, directions.size(), [&] {
        double sum = 0;
        harmonics::for_each_basis(bands, directions,
                                  [&](std::size_t, const auto& y) { sum += y[0]; });
        benchmark::DoNotOptimize(sum);
    });
}

using Evaluate = void (*)(int bands, glm::dvec3 direction, std::span<double> out);

void one_by_one(const Row& row, int bands, Evaluate evaluate) {
    const auto directions = harmonics::fibonacci_directions(64, 1).directions;
    std::vector<double> y(static_cast<std::size_t>(bands * bands));
    measure(row, directions.size(), [&] {
        for (const auto& direction : directions) {
            evaluate(bands, direction, y);
            benchmark::ClobberMemory();
        }
    });
}

/// Thickness of 512 vertices toward 32 directions, half of it zero, as it is found on a convex
/// body.
void projection(const Row& row, int bands) {
    const auto set = harmonics::fibonacci_directions(32 * 4, 1);
    const auto n = static_cast<std::size_t>(bands * bands);
    const auto all_rows = harmonics::projection_rows(bands, set);
    const auto rows = std::span(all_rows).first(32 * n);
    std::vector<double> values(512 * 32), coefficients(512 * n);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::max(0.0, set.directions[i * 37 % set.directions.size()].x);
    measure(row, values.size(), [&] {
        harmonics::accumulate(values, 32, rows, coefficients);
        benchmark::ClobberMemory();
    });
}

void rows_of_projection(const Row& row, int bands) {
    const auto set = harmonics::fibonacci_directions(128, 1);
    measure(row, set.directions.size(),
            [&] { benchmark::DoNotOptimize(harmonics::projection_rows(bands, set)); });
}

void reconstruction(const Row& row, int bands) {
    constexpr std::size_t vertices = 200; // 20 kB of coefficients
    thickness::ThicknessField field{.bands = 5};
    field.coefficients.assign(vertices * 25, 0.5F);
    std::vector<double> y(25);
    harmonics::evaluate(5, {0.6, 0, 0.8}, y);
    measure(row, vertices, [&] {
        double sum = 0;
        for (std::size_t v = 0; v < vertices; ++v)
            sum += thickness::reconstruct(field, v, y, bands);
        benchmark::DoNotOptimize(sum);
    });
}

/// 64 neighbours on a ring of 40,000 triangles, from every 256th of 1024 directions.
void all_hits(const Row& row) {
    const auto mesh = geometry::torus(0.7, 0.3, 200, 100);
    const geometry::RayScene scene(mesh);
    const auto order = geometry::morton_order(scene.positions());
    const auto directions = harmonics::fibonacci_directions(1024, 1).directions;
    const geometry::DenormalsAreZero guard;
    geometry::InteriorTracer tracer(scene);
    double sum = 0;
    measure(row, 4 * 64, [&] {
        for (std::size_t j = 0; j < directions.size(); j += 256)
            tracer.from_vertices(
                std::span(order).subspan(1024, 64), directions[j],
                [&](std::size_t, const auto& segments) { sum += segments.size() > 0; });
    });
    benchmark::DoNotOptimize(sum);
}

/// Flight, collision and turn in a medium that absorbs nothing; an item is a collision.
void free_flight(const Row& row, const reference::Body& body) {
    const reference::EnergyRun run{.paths = 128, .seed = 1};
    const auto medium = reference::grey_medium(10, 1, 0, 1);
    const auto walk = [&] { return reference::body_energy(body, {}, 1, medium, {}, run); };
    const auto balance = walk();
    const double collisions = balance.collisions.value * static_cast<double>(balance.paths);
    measure(row, static_cast<std::size_t>(collisions), [&] { benchmark::DoNotOptimize(walk()); });
}

template <class Function, class... Arguments>
void add(const std::string& name, Function function, Arguments... arguments) {
    table.add_row(name);
    benchmark::RegisterBenchmark(name.c_str(), [=](benchmark::State& state) {
        function(Row{name, state}, arguments...);
    });
}

void add_harmonics() {
    for (const auto set : harmonics::instruction_sets())
        for (const int bands : {2, 3, 5, 10}) {
            add(fmt::format("{}, double, {} bands", name_of(set), bands), blocks_in_cache<double>,
                bands, set);
            add(fmt::format("{}, float, {} bands", name_of(set), bands), blocks_in_cache<float>,
                bands, set);
        }
    for (const int bands : {2, 3, 5, 10}) {
        add(fmt::format("from vectors, {} bands", bands), from_vectors, bands);
        add(fmt::format("one by one, {} bands", bands), one_by_one, bands, harmonics::evaluate);
        add(fmt::format("by recurrence, {} bands", bands), one_by_one, bands,
            harmonics::evaluate_by_recurrence);
    }
}

} // namespace

int main(int count, char** arguments) {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    std::vector<std::string> words(arguments, arguments + count);
    words.insert(words.begin() + 1, {"--benchmark_repetitions=9", "--benchmark_min_time=0.05",
                                     "--benchmark_enable_random_interleaving=true"});
    std::vector<char*> pointers;
    for (auto& word : words)
        pointers.push_back(word.data());
    int given = static_cast<int>(pointers.size());

    const auto sphere = reference::make_sphere(1);
    const auto ring = reference::make_mesh_body(geometry::torus(0.7, 0.3, 200, 100));
    add(bench::clock_row, waiting_multiplications);
    add_harmonics();
    for (const int bands : {2, 3, 5, 6}) {
        add(fmt::format("projection of a sample, {} bands", bands), projection, bands);
        add(fmt::format("rows of projection, a direction, {} bands", bands), rows_of_projection,
            bands);
    }
    for (const int bands : {2, 3, 5})
        add(fmt::format("reconstruction at a vertex, {} bands", bands), reconstruction, bands);
    add("all hits of a ray", all_hits);
    add("a collision in a sphere", [&](const Row& row) { free_flight(row, *sphere); });
    add("a collision in a ring of triangles", [&](const Row& row) { free_flight(row, *ring); });

    benchmark::Initialize(&given, pointers.data());
    if (benchmark::ReportUnrecognizedArguments(given, pointers.data()))
        return 2;
    benchmark::RunSpecifiedBenchmarks(&table);
    benchmark::Shutdown();
    return 0;
}
