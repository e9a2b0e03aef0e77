// The walk along a ray from its far end, its retries and its last resort.
#include "renderer/geometry/crossings.h"

#include "renderer/contract.h"
#include "renderer/geometry/winding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace renderer::geometry {

namespace {

// Scene units are diameters.  Closer than this, a float cannot tell a crossing from the origin.
constexpr float nearest_crossing = 1e-6f;

// Shorter stretches have no side: the order of two crossings of a sharp edge is lost in rounding.
constexpr float shortest_gap = 1e-6f;

constexpr int attempts = 4; // the ray itself, then three beside it
constexpr double jitter = 1e-5;

/// Two distances that would be one in exact arithmetic: 8 ulp apart at most.
bool is_same_place(float a, float b) {
    return std::abs(a - b) <= 8 * std::numeric_limits<float>::epsilon() * std::max(a, b);
}

bool is_unit(glm::dvec3 direction) {
    return std::abs(glm::dot(direction, direction) - 1) <= 2e-6;
}

/// Three directions turned by 1e-5 rad, a third of a circle apart.
glm::dvec3 jittered(glm::dvec3 direction, int attempt) {
    const glm::dvec3 aside =
        std::abs(direction.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(direction, aside)), v = glm::cross(direction, u);
    const double angle = 2.0943951 * attempt + 0.5;
    return glm::normalize(direction + jitter * (std::cos(angle) * u + std::sin(angle) * v));
}

} // namespace

RayStatistics& RayStatistics::operator+=(const RayStatistics& other) {
    rays += other.rays;
    retried += other.retried;
    fallbacks += other.fallbacks;
    past_openings += other.past_openings;
    return *this;
}

std::span<const Segment> InteriorTracer::from_vertex(std::uint32_t vertex, glm::dvec3 direction) {
    EXPECTS(vertex < scene_->positions().size());
    return trace({scene_->positions()[vertex], vertex, Side::Unknown}, direction);
}

std::span<const Segment>
InteriorTracer::from_point(glm::dvec3 point, glm::dvec3 direction, Side side) {
    return trace({glm::vec3(scene_->scene_from_model(point)), std::nullopt, side}, direction);
}

std::uint32_t InteriorTracer::triangle_at(double distance) const {
    EXPECTS(!hits_.empty());
    const auto at = static_cast<float>(distance / scene_->model_per_scene());
    return std::ranges::min_element(hits_, {},
                                    [&](const Hit& hit) { return std::abs(hit.distance - at); })
        ->triangle;
}

void InteriorTracer::follow_bundle(std::span<const std::uint32_t> vertices, glm::dvec3 direction) {
    EXPECTS(is_unit(direction));
    std::array<glm::vec3, RayScene::bundle_size> origins;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        EXPECTS(vertices[i] < scene_->positions().size());
        origins[i] = scene_->positions()[vertices[i]];
    }
    scene_->all_hits(std::span(origins).first(vertices.size()), glm::vec3(direction),
                     nearest_crossing, bundle_);
}

/// The answer for one ray of the bundle that was followed last.
std::span<const Segment>
InteriorTracer::from_bundle(std::size_t i, std::uint32_t vertex, glm::dvec3 direction) {
    ++statistics_.rays;
    if (bundle_[i].empty() && open_ == nullptr)
        return {}; // as for every second ray
    doubtful_.clear();
    hits_.swap(bundle_[i]);
    const Origin origin{scene_->positions()[vertex], vertex, Side::Unknown};
    order_hits(origin);
    return resolve_hits(origin.side) ? finished(origin, direction) : trace_again(origin, direction);
}

std::span<const Segment> InteriorTracer::trace(const Origin& origin, glm::dvec3 direction) {
    EXPECTS(is_unit(direction));
    ++statistics_.rays;
    doubtful_.clear();
    return resolve(origin, direction) ? finished(origin, direction)
                                      : trace_again(origin, direction);
}

/// The ray itself left a doubt: asks beside it, and in the end for winding numbers.
std::span<const Segment> InteriorTracer::trace_again(const Origin& origin, glm::dvec3 direction) {
    ++statistics_.retried;
    int attempt = 1;
    while (attempt < attempts && !resolve(origin, jittered(direction, attempt)))
        ++attempt;
    if (attempt < attempts)
        return finished(origin, direction);
    ++statistics_.fallbacks;
    classify_gaps(origin, direction);
    return in_model_units();
}

/// The crossings are sure; what they enclose is too, unless an opening is near.
std::span<const Segment> InteriorTracer::finished(const Origin& origin, glm::dvec3 direction) {
    if (open_ != nullptr && open_->may_matter(origin.position, direction)) {
        ++statistics_.past_openings;
        open_->follow(origin.position, direction, hits_, segments_);
    }
    return in_model_units();
}

/// Nearest first.
std::span<const Segment> InteriorTracer::in_model_units() {
    std::reverse(segments_.begin(), segments_.end());
    for (auto& [begin, end] : segments_) {
        begin *= scene_->model_per_scene();
        end *= scene_->model_per_scene();
    }
    return segments_;
}

/// Fills `segments_`, in scene units and farthest first; false when the answer is in doubt.
bool InteriorTracer::resolve(const Origin& origin, glm::dvec3 direction) {
    collect(origin, direction);
    return resolve_hits(origin.side);
}

bool InteriorTracer::resolve_hits(Side side) {
    if (!merge()) {
        doubtful_.clear();
        return false;
    }
    return walk(side) || is_confirmed();
}

/// Whether the neighbour that was in doubt met the surface in the same senses one after the other.
/// Two rays do not lose the same crossing: then what looked odd is the shape of the surface.
bool InteriorTracer::is_confirmed() {
    std::vector<bool> senses;
    for (const Hit& hit : hits_)
        senses.push_back(hit.leaving);
    const bool agrees = senses == doubtful_;
    doubtful_ = std::move(senses);
    return agrees;
}

void InteriorTracer::collect(const Origin& origin, glm::dvec3 direction) {
    scene_->all_hits(origin.position, glm::vec3(direction), nearest_crossing, hits_);
    order_hits(origin);
}

/// Drops the triangles that meet in the ray's own vertex and sorts the others, farthest first; of
/// equally far ones those that leave come first, so that the count never dips below zero for an
/// order that only rounding made.
void InteriorTracer::order_hits(const Origin& origin) {
    if (origin.vertex)
        std::erase_if(hits_, [&](const Hit& hit) {
            const auto& [a, b, c] = scene_->triangles()[hit.triangle];
            return a == *origin.vertex || b == *origin.vertex || c == *origin.vertex;
        });
    std::sort(hits_.begin(), hits_.end(), [](const Hit& a, const Hit& b) {
        if (a.distance != b.distance)
            return a.distance > b.distance;
        if (a.leaving != b.leaving)
            return a.leaving;
        return a.triangle < b.triangle;
    });
}

/// A ray through an edge or a vertex meets several triangles in one place: one crossing, if they
/// agree about its sense.  False when they do not, or when the ray grazes: then neither count is
/// sure.
bool InteriorTracer::merge() {
    std::size_t kept = 0;
    for (const Hit& hit : hits_) {
        if (hit.grazing)
            return false;
        bool is_new = true;
        for (std::size_t i = kept; i-- > 0 && is_same_place(hits_[i].distance, hit.distance);)
            if (share_a_corner(hits_[i].triangle, hit.triangle)) {
                if (hits_[i].leaving != hit.leaving)
                    return false;
                is_new = false;
            }
        if (is_new)
            hits_[kept++] = hit;
    }
    hits_.resize(kept);
    return true;
}

/// Fills `segments_`; true when the count is one that a single body gives: at every place and in
/// the end none or one, more only in between.  In the end it is what is known about the origin.
bool InteriorTracer::walk(Side side) {
    segments_.clear();
    bool is_ordinary = true;
    int enclosing = 0;
    float end = 0;
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const float distance = hits_[i].distance;
        const bool was_inside = enclosing >= 1;
        enclosing += hits_[i].leaving ? 1 : -1;
        const bool is_inside = enclosing >= 1;
        const float next = i + 1 < hits_.size() ? hits_[i + 1].distance : 0;
        if (enclosing < 0 && distance - next > shortest_gap)
            is_ordinary = false;
        if (!was_inside && is_inside)
            end = distance;
        if (was_inside && !is_inside && distance < end)
            segments_.push_back({distance, end});
    }
    if (enclosing >= 1)
        segments_.push_back({0, end});
    return is_ordinary &&
           ((enclosing == 0 && side != Side::Inside) || (enclosing == 1 && side != Side::Outside));
}

/// The last resort: each gap between crossings is inside when the surface winds around its middle.
void InteriorTracer::classify_gaps(const Origin& origin, glm::dvec3 direction) {
    collect(origin, direction);
    segments_.clear();
    for (std::size_t i = 0; i < hits_.size(); ++i) {
        const float end = hits_[i].distance;
        const float begin = i + 1 < hits_.size() ? hits_[i + 1].distance : 0;
        if (end - begin <= shortest_gap)
            continue;
        const glm::dvec3 middle = glm::dvec3(origin.position) + 0.5 * (begin + end) * direction;
        if (winding(middle) <= 0.5)
            continue;
        if (!segments_.empty() && segments_.back().begin - end <= shortest_gap)
            segments_.back().begin = begin;
        else
            segments_.push_back({begin, end});
    }
}

/// In scene coordinates, and around the surface without its covers.
double InteriorTracer::winding(glm::dvec3 point) const {
    return open_ != nullptr ? open_->winding(point)
                            : winding_number(scene_->positions(), scene_->triangles(), point);
}

bool InteriorTracer::share_a_corner(std::uint32_t a, std::uint32_t b) const {
    const auto& first = scene_->triangles()[a];
    const auto& second = scene_->triangles()[b];
    return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) !=
           first.end();
}

} // namespace renderer::geometry
