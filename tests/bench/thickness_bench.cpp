// How fast thickness is traced and projected, against the first hits of the same rays by bare
// Embree.
//
//   thickness_bench MODEL [SUBDIVISIONS [DIRECTIONS [REPEATS]]]
//
// Every ray of compute_thickness_field, vertices in blocks and directions in Morton order, is also
// sent through a scene of the same triangles by rtcIntersect1, which stops at the first hit, finds
// no second, and projects nothing.  Variants take turns; rates are per second of processor time,
// which neighbours on the machine disturb least.  The ratio is the one that counts.
#include "renderer/geometry/mesh_files.h"
#include "renderer/geometry/mesh_repair.h"
#include "renderer/geometry/morton_order.h"
#include "renderer/geometry/ray_scene.h"
#include "renderer/harmonics/directions.h"
#include "renderer/stopwatch.h"
#include "renderer/thickness/thickness_field.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <fmt/format.h>
#include <sys/resource.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace renderer;

/// Each triangle in four, new vertices in the middle of edges.
geometry::Mesh subdivided(const geometry::Mesh& mesh) {
    geometry::Mesh fine{mesh.positions, {}};
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        const auto [found, is_new] = middles.try_emplace(
            std::minmax(a, b), static_cast<std::uint32_t>(fine.positions.size()));
        if (is_new)
            fine.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]));
        return found->second;
    };
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        for (const auto& t : {geometry::Triangle{a, ab, ca}, geometry::Triangle{b, bc, ab},
                              geometry::Triangle{c, ca, bc}, geometry::Triangle{ab, bc, ca}})
            fine.triangles.push_back(t);
    }
    return fine;
}

/// Embree as it comes, without the door of renderer/geometry.
class BareScene {
  public:
    BareScene(const geometry::RayScene& from, RTCSceneFlags flags, RTCBuildQuality quality)
        : device_(rtcNewDevice(nullptr)), scene_(rtcNewScene(device_)) {
        rtcSetSceneFlags(scene_, flags);
        rtcSetSceneBuildQuality(scene_, quality);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        copy(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, from.positions());
        copy(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, from.triangles());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }

    ~BareScene() {
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    BareScene(const BareScene&) = delete;
    BareScene& operator=(const BareScene&) = delete;

    /// Whether anything is hit.
    bool is_hit(glm::vec3 origin, glm::vec3 direction) const {
        RTCRayHit query{};
        query.ray.org_x = origin.x;
        query.ray.org_y = origin.y;
        query.ray.org_z = origin.z;
        query.ray.dir_x = direction.x;
        query.ray.dir_y = direction.y;
        query.ray.dir_z = direction.z;
        query.ray.tnear = 1e-6f;
        query.ray.tfar = std::numeric_limits<float>::infinity();
        query.ray.mask = ~0u;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR < 4
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene_, &context, &query);
#else
        rtcIntersect1(scene_, &query);
#endif
        return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    }

  private:
    template <class T>
    static void
    copy(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::span<const T> values) {
        std::memcpy(rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size()),
                    values.data(), values.size_bytes());
    }

    RTCDevice device_;
    RTCScene scene_;
};

double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

long peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss / 1024;
}

struct Timings {
    std::string name;
    std::vector<double> processor, wall;
};

void take_time(Timings& timings, const std::function<void()>& work) {
    const double processor = processor_seconds();
    const renderer::Stopwatch watch;
    work();
    timings.processor.push_back(processor_seconds() - processor);
    timings.wall.push_back(watch.seconds());
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

/// First hits in the order in which compute_thickness_field asks: blocks of 512 neighbouring
/// vertices, in each one direction after the other.  Returns how many rays hit anything.
std::size_t first_hits(const BareScene& bare,
                       const geometry::RayScene& scene,
                       const std::vector<std::uint32_t>& order,
                       const std::vector<glm::vec3>& directions) {
    constexpr std::size_t block = 512;
    std::atomic<std::size_t> hits{0};
    tbb::parallel_for(std::size_t{0}, (order.size() + block - 1) / block, [&](std::size_t b) {
        const geometry::DenormalsAreZero guard;
        const std::size_t end = std::min(order.size(), (b + 1) * block);
        std::size_t here = 0;
        for (const auto& direction : directions)
            for (std::size_t i = b * block; i < end; ++i)
                here += bare.is_hit(scene.positions()[order[i]], direction) ? 1 : 0;
        hits += here;
    });
    return hits;
}

std::vector<glm::vec3> directions_in_order(int count) {
    const auto set = harmonics::fibonacci_directions(count, 1);
    std::vector<glm::vec3> halves, ordered;
    for (const auto& direction : set.directions)
        halves.emplace_back(0.5 * direction);
    for (const auto j : geometry::morton_order(halves))
        ordered.emplace_back(set.directions[j]);
    return ordered;
}

void print(const std::vector<Timings>& all, double rays) {
    fmt::print("{:<34} {:>10} {:>10} {:>9} {:>15}\n", "", "Mray/cpu-s", "Mray/s", "ratio",
               "ratios from..to");
    const auto& measured = all.front().processor;
    for (const auto& timings : all) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < measured.size(); ++i)
            ratios.push_back(timings.processor[i] / measured[i]);
        fmt::print("{:<34} {:>10.3f} {:>10.3f} {:>9.3f} {:>7.3f}..{:.3f}\n", timings.name,
                   rays / median(timings.processor) * 1e-6, rays / median(timings.wall) * 1e-6,
                   median(ratios), *std::min_element(ratios.begin(), ratios.end()),
                   *std::max_element(ratios.begin(), ratios.end()));
    }
    fmt::print("ratio: rays of thickness in the time of one ray of the row; peak memory {} MB\n",
               peak_megabytes());
}

} // namespace

int main(int count, char** arguments) {
    const auto number = [&](int i, int otherwise) {
        return count > i ? std::atoi(arguments[i]) : otherwise;
    };
    if (count < 2) {
        fmt::print(stderr, "thickness_bench MODEL [SUBDIVISIONS [DIRECTIONS [REPEATS]]]\n");
        return 2;
    }
    auto raw = geometry::read_mesh(arguments[1]);
    if (!raw) {
        fmt::print(stderr, "{}\n", raw.error());
        return 1;
    }
    auto prepared = geometry::prepare(std::move(*raw), arguments[1]);
    if (!prepared) {
        fmt::print(stderr, "{}\n", prepared.error());
        return 1;
    }
    geometry::Mesh mesh = std::move(prepared->mesh);
    for (int i = 0; i < number(2, 0); ++i)
        mesh = subdivided(mesh);
    const int directions = number(3, 64), repeats = number(4, 5);
    const double rays = static_cast<double>(mesh.positions.size()) * directions;
    fmt::print("{}: {} vertices, {} triangles, {} directions, {:.3g} rays, {} repeats\n",
               arguments[1], mesh.positions.size(), mesh.triangles.size(), directions, rays,
               repeats);

    const geometry::RayScene scene(mesh);
    const BareScene plain(scene, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_MEDIUM);
    const BareScene robust(scene, RTC_SCENE_FLAG_ROBUST, RTC_BUILD_QUALITY_MEDIUM);
    const BareScene split(scene, RTC_SCENE_FLAG_NONE, RTC_BUILD_QUALITY_HIGH);
    const auto order = geometry::morton_order(scene.positions());
    const auto ordered_directions = directions_in_order(directions);

    std::vector<Timings> all{{"thickness, traced and projected", {}, {}},
                             {"rtcIntersect1, plain", {}, {}},
                             {"rtcIntersect1, robust", {}, {}},
                             {"rtcIntersect1, plain, best build", {}, {}}};
    const BareScene* bare[] = {&plain, &robust, &split};
    std::size_t hits = 0;
    geometry::RayStatistics statistics;
    for (int i = 0; i < repeats; ++i) {
        take_time(all[0], [&] {
            const auto field =
                thickness::compute_thickness_field(mesh, {.bands = 5, .directions = directions});
            if (field)
                statistics = field->statistics;
            else
                fmt::print(stderr, "{}\n", field.error());
        });
        for (std::size_t k = 0; k < 3; ++k)
            take_time(all[k + 1],
                      [&] { hits = first_hits(*bare[k], scene, order, ordered_directions); });
    }
    print(all, rays);
    fmt::print("{} rays asked again, {} decided by winding number; {:.1f} % have a first hit\n",
               statistics.retried, statistics.fallbacks, 100 * static_cast<double>(hits) / rays);
    return 0;
}
