// Rays through a mesh by Embree 3 or 4; everything in which the two differ is in this file.
#include "renderer/geometry/ray_scene.h"

#include "renderer/contract.h"

#if __has_include(<embree3/rtcore.h>)
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif
#include <fmt/format.h>
#include <xmmintrin.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace renderer::geometry {

namespace {

#if RTC_VERSION_MAJOR < 4
using QueryContext = RTCIntersectContext;
#else
using QueryContext = RTCRayQueryContext;
#endif

// Squared sine of the angle below which float does not know where a ray meets a triangle's plane: a
// rounding of 1e-7 becomes 0.03 of the scene.  One crossing in 1e11 of rays from everywhere.
constexpr float grazing_square = 3e-6f * 3e-6f;

/// What the filter is handed with every hit: where to put it.
struct Collector {
    QueryContext context;   // first, so that a pointer to it is a pointer to the collector
    std::vector<Hit>* hits; // one list for each ray, by its id
    const Triangle* triangles;
};

/// Notes the hits and refuses them, so that the rays go on.
void collect(const RTCFilterFunctionNArguments* arguments) {
    const auto* collector = reinterpret_cast<const Collector*>(arguments->context);
    const unsigned n = arguments->N; // how many rays Embree has at hand
    for (unsigned i = 0; i < n; ++i) {
        if (arguments->valid[i] == 0)
            continue;
        arguments->valid[i] = 0;
        RTCRayN* ray = arguments->ray;
        RTCHitN* hit = arguments->hit;
        const float along = RTCHitN_Ng_x(hit, n, i) * RTCRayN_dir_x(ray, n, i) +
                            RTCHitN_Ng_y(hit, n, i) * RTCRayN_dir_y(ray, n, i) +
                            RTCHitN_Ng_z(hit, n, i) * RTCRayN_dir_z(ray, n, i);
        const float square = RTCHitN_Ng_x(hit, n, i) * RTCHitN_Ng_x(hit, n, i) +
                             RTCHitN_Ng_y(hit, n, i) * RTCHitN_Ng_y(hit, n, i) +
                             RTCHitN_Ng_z(hit, n, i) * RTCHitN_Ng_z(hit, n, i);
        const bool grazing = along * along < grazing_square * square;
        const unsigned triangle = RTCHitN_primID(hit, n, i);
        collector->hits[RTCRayN_id(ray, n, i)].push_back(
            {RTCRayN_tfar(ray, n, i), triangle, along > 0, grazing});
        // Whoever asked will look at the corners, and by then they are in the cache: 4 % of the
        // tracing.
        __builtin_prefetch(&collector->triangles[triangle]);
    }
}

/// All of the rays at once in Embree 3, whose streams visit a node of the tree once for all that
/// meet it.  Embree 4 has no streams.
void follow(RTCScene scene, Collector& collector, std::span<RTCRay> rays) {
#if RTC_VERSION_MAJOR < 4
    rtcInitIntersectContext(&collector.context);
    collector.context.filter = collect;
    if (rays.size() == 1)
        rtcOccluded1(scene, &collector.context, rays.data());
    else
        rtcOccluded1M(scene, &collector.context, rays.data(), static_cast<unsigned>(rays.size()),
                      sizeof(RTCRay));
#else
    rtcInitRayQueryContext(&collector.context);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    arguments.context = &collector.context;
    arguments.filter = collect;
    for (auto& ray : rays)
        rtcOccluded1(scene, &ray, &arguments);
#endif
}

/// Stops at the first hit; afterwards `tfar` of a ray that met one is minus infinity.
void occluded_without_filter(RTCScene scene, RTCRay& ray) {
#if RTC_VERSION_MAJOR < 4
    QueryContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
#else
    rtcOccluded1(scene, &ray, nullptr);
#endif
}

RTCRay ray_between(
    glm::vec3 origin, glm::vec3 direction, float nearest, float farthest, std::size_t id = 0) {
    RTCRay ray{};
    ray.org_x = origin.x;
    ray.org_y = origin.y;
    ray.org_z = origin.z;
    ray.dir_x = direction.x;
    ray.dir_y = direction.y;
    ray.dir_z = direction.z;
    ray.tnear = nearest;
    ray.tfar = farthest;
    ray.mask = ~0u;
    ray.id = static_cast<unsigned>(id);
    return ray;
}

RTCRay endless_ray(glm::vec3 origin, glm::vec3 direction, float nearest, std::size_t id = 0) {
    return ray_between(origin, direction, nearest, std::numeric_limits<float>::infinity(), id);
}

RTCSceneFlags scene_flags() {
    // Robust: neighbours agree about their common edge, so that no ray slips through between them.
#if RTC_VERSION_MAJOR < 4
    return static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                      RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
#else
    return static_cast<RTCSceneFlags>(RTC_SCENE_FLAG_ROBUST |
                                      RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS);
#endif
}

template <class T>
void fill(RTCGeometry geometry,
          RTCBufferType type,
          RTCFormat format,
          const std::vector<T>& values) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), values.size());
    if (buffer == nullptr)
        throw std::runtime_error(fmt::format("Embree has no room for {} elements", values.size()));
    std::memcpy(buffer, values.data(), sizeof(T) * values.size());
}

bool is_finite(glm::dvec3 p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

} // namespace

DenormalsAreZero::DenormalsAreZero() : before_(_mm_getcsr()) {
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    _mm_setcsr(before_ | flush_to_zero | denormals_are_zero);
}

DenormalsAreZero::~DenormalsAreZero() {
    _mm_setcsr(before_);
}

struct RayScene::Handles {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    Handles() = default;
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    ~Handles() {
        if (scene != nullptr)
            rtcReleaseScene(scene);
        if (device != nullptr)
            rtcReleaseDevice(device);
    }
};

RayScene::RayScene(const Mesh& mesh)
    : triangles_(mesh.triangles), handles_(std::make_unique<Handles>()) {
    for (const auto& position : mesh.positions)
        EXPECTS(is_finite(position));
    for (const auto& triangle : mesh.triangles)
        for (const auto corner : triangle)
            EXPECTS(corner < mesh.positions.size());
    const auto bounds = bounding_sphere(mesh);
    EXPECTS(bounds.radius > 0);
    centre_ = bounds.centre;
    model_per_scene_ = 2 * bounds.radius;
    for (const auto& position : mesh.positions)
        positions_.emplace_back(scene_from_model(position));

    const DenormalsAreZero guard;
    handles_->device = rtcNewDevice(nullptr);
    if (handles_->device == nullptr)
        throw std::runtime_error(fmt::format("Embree cannot start (error {})",
                                             static_cast<int>(rtcGetDeviceError(nullptr))));
    handles_->scene = rtcNewScene(handles_->device);
    rtcSetSceneFlags(handles_->scene, scene_flags());
    // Never HIGH: its spatial splits report one triangle several times.
    rtcSetSceneBuildQuality(handles_->scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
    fill(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions_);
    fill(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles_);
#if RTC_VERSION_MAJOR >= 4
    rtcSetGeometryEnableFilterFunctionFromArguments(geometry, true);
#endif
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(handles_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(handles_->scene);
    if (const auto error = rtcGetDeviceError(handles_->device); error != RTC_ERROR_NONE)
        throw std::runtime_error(
            fmt::format("Embree cannot build a scene of {} triangles (error {})", triangles_.size(),
                        static_cast<int>(error)));
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

void RayScene::all_hits(glm::vec3 origin,
                        glm::vec3 direction,
                        float nearest,
                        std::vector<Hit>& hits) const {
    hits.clear();
    RTCRay ray = endless_ray(origin, direction, nearest);
    Collector collector{{}, &hits, triangles_.data()};
    follow(handles_->scene, collector, std::span(&ray, 1));
}

void RayScene::all_hits(std::span<const glm::vec3> origins,
                        glm::vec3 direction,
                        float nearest,
                        BundleHits& hits) const {
    EXPECTS(origins.size() <= bundle_size);
    std::array<RTCRay, bundle_size> rays;
    for (std::size_t i = 0; i < origins.size(); ++i) {
        hits[i].clear();
        rays[i] = endless_ray(origins[i], direction, nearest, i);
    }
    Collector collector{{}, hits.data(), triangles_.data()};
    follow(handles_->scene, collector, std::span(rays).first(origins.size()));
}

bool RayScene::is_occluded(glm::vec3 origin, glm::vec3 direction, float nearest) const {
    RTCRay ray = endless_ray(origin, direction, nearest);
    occluded_without_filter(handles_->scene, ray);
    return ray.tfar < 0;
}

bool RayScene::meets(glm::vec3 origin, glm::vec3 direction, float nearest, float farthest) const {
    RTCRay ray = ray_between(origin, direction, nearest, farthest);
    occluded_without_filter(handles_->scene, ray);
    return ray.tfar < 0;
}

} // namespace renderer::geometry
