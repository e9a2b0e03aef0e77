// Covers are fans around the middles of rims; the half-way surface is bracketed and bisected.
#include "renderer/geometry/openings.h"

#include "renderer/contract.h"
#include "renderer/geometry/disjoint_sets.h"
#include "renderer/geometry/winding.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <numbers>
#include <utility>

namespace renderer::geometry {

namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Passages that no passage the other way makes up for, as the surface runs through them.
std::vector<Edge> rim_edges(const Mesh& mesh) {
    std::vector<Edge> passages, opposite, rim;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto from = t[k], to = t[(k + 1) % 3]; from != to) {
                passages.emplace_back(from, to);
                opposite.emplace_back(to, from);
            }
    std::sort(passages.begin(), passages.end());
    std::sort(opposite.begin(), opposite.end());
    std::set_difference(passages.begin(), passages.end(), opposite.begin(), opposite.end(),
                        std::back_inserter(rim));
    return rim;
}

// Scene units are diameters.  So near a crossing its side is lost in rounding (crossings.cpp).
constexpr double beside_a_crossing = 1e-6;

constexpr double root_width = 1e-7;

// A dip so short is no length.
constexpr double turn_width = 1e-5;

// Answers are an eighth of a rim's width apart: so far from a half, the next one would have shown
// it.
constexpr double no_dip = 0.4;

// Less than a half, for the sum of the bounds is rounded.
constexpr double surely_too_little = 0.49;

/// Where the ray leaves the sphere around the scene; nothing is inside beyond it.
double leaves_the_scene(glm::dvec3 origin, glm::dvec3 direction) {
    constexpr double radius = 0.5;
    const double along = glm::dot(origin, direction);
    const double inside = along * along - glm::dot(origin, origin) + radius * radius;
    return inside > 0 ? std::max(0.0, std::sqrt(inside) - along) : 0;
}

} // namespace

CoveredMesh cover_openings(const Mesh& mesh) {
    CoveredMesh covered{mesh, mesh.positions.size(), mesh.triangles.size()};
    const auto rim = rim_edges(mesh);
    DisjointSets rims(mesh.positions.size());
    for (const auto& [from, to] : rim)
        rims.join(from, to);

    struct Apex {
        glm::dvec3 sum{};
        double corners = 0;
        std::uint32_t index = 0;
    };

    std::map<std::uint32_t, Apex> apexes; // by the rim's name
    for (const auto& [from, to] : rim) {
        auto& apex = apexes[rims.find(from)];
        apex.sum += mesh.positions[from] + mesh.positions[to];
        apex.corners += 2;
    }
    for (auto& [name, apex] : apexes) {
        apex.index = static_cast<std::uint32_t>(covered.mesh.positions.size());
        covered.mesh.positions.push_back(apex.sum / apex.corners);
    }
    // Every rim is a cycle, so that the edges to the apex make up for each other.
    for (const auto& [from, to] : rim)
        covered.mesh.triangles.push_back({to, from, apexes[rims.find(from)].index});
    return covered;
}

OpenInterior::OpenInterior(const RayScene& scene, std::size_t own_triangles)
    : scene_(&scene), own_triangles_(own_triangles) {
    EXPECTS(own_triangles <= scene.triangles().size());
    const auto positions = scene.positions();
    std::map<std::uint32_t, Cover> covers; // by the apex
    for (const auto& [from, to, apex] : scene.triangles().subspan(own_triangles)) {
        auto& cover = covers[apex];
        cover.centre = positions[apex];
        const glm::dvec3 a = glm::dvec3(positions[from]) - cover.centre,
                         b = glm::dvec3(positions[to]) - cover.centre;
        cover.radius = std::max({cover.radius, glm::length(a), glm::length(b)});
        cover.area += 0.5 * glm::length(glm::cross(a, b));
    }
    for (const auto& [apex, cover] : covers)
        covers_.push_back(cover);
}

/// From a distance of d a sheet of area A fills a solid angle of A / d^2 at most.
bool OpenInterior::may_matter(glm::vec3 origin, glm::dvec3 direction) const {
    double most = 0;
    for (const auto& [centre, radius, area] : covers_) {
        const glm::dvec3 to_centre = centre - glm::dvec3(origin);
        const double along = std::max(0.0, glm::dot(to_centre, direction));
        const double distance = glm::length(to_centre - along * direction) - radius;
        if (distance <= 0)
            return true;
        most += area / (distance * distance) / (4 * std::numbers::pi);
    }
    return most > surely_too_little;
}

double OpenInterior::covers_winding(glm::dvec3 point) const {
    return winding_number(scene_->positions(), scene_->triangles().subspan(own_triangles_), point);
}

double OpenInterior::winding(glm::dvec3 point) const {
    return winding_number(scene_->positions(), scene_->triangles().first(own_triangles_), point);
}

/// One ray, followed from its far end.
class OpenInterior::Ray {
  public:
    Ray(const OpenInterior& interior,
        glm::dvec3 origin,
        glm::dvec3 direction,
        std::vector<Segment>& segments)
        : interior_(interior), origin_(origin), direction_(direction), segments_(segments) {
        for (const auto& [centre, radius, area] : interior.covers_) {
            const double pass = glm::dot(centre - origin, direction);
            questions_.push_back(pass);
            if (glm::length(centre - origin - pass * direction) < 2 * radius)
                for (int i = 1; i <= questions_beside; ++i)
                    for (const double beside : {-radius, radius})
                        questions_.push_back(pass + beside * i / questions_beside);
        }
        std::sort(questions_.begin(), questions_.end(), std::greater<>());
    }

    void cross(bool leaving) { enclosing_ += leaving ? 1 : -1; }

    /// Between two crossings the winding number changes smoothly, and fastest where the ray passes
    /// a rim: so it is asked there.
    void follow_gap(double begin, double end) {
        ask_along(begin, end);
        ask_where_it_turns();
        double inside_until = end;
        for (std::size_t i = 1; i < answers_.size(); ++i) {
            if (answers_[i].is_inside() == answers_[i - 1].is_inside())
                continue;
            const double half_way = change_between(answers_[i], answers_[i - 1]);
            if (answers_[i - 1].is_inside())
                add(half_way, inside_until);
            inside_until = half_way;
        }
        if (answers_.back().is_inside())
            add(begin, inside_until);
    }

  private:
    static constexpr int questions_beside = 4; // the middle of a rim, within its radius

    struct Answer {
        double distance;
        double excess; ///< of the winding number over a half

        bool is_inside() const { return excess > 0; }
    };

    Answer ask(double distance) const {
        return {distance,
                enclosing_ - interior_.covers_winding(origin_ + distance * direction_) - 0.5};
    }

    void ask_along(double begin, double end) {
        const double margin = std::min(beside_a_crossing, 0.25 * (end - begin));
        answers_.assign({ask(end - margin)});
        for (const double question : questions_)
            if (begin + margin < question && question < answers_.back().distance)
                answers_.push_back(ask(question));
        answers_.push_back(ask(begin + margin));
    }

    /// A ray may dip through the half-way surface between two answers that agree: then the one
    /// between its neighbours is the nearest to a half, and near it is one on the other side.
    void ask_where_it_turns() {
        for (std::size_t i = 1; i + 1 < answers_.size(); ++i) {
            const auto &far = answers_[i - 1], &middle = answers_[i], &near = answers_[i + 1];
            if (std::abs(middle.excess) > no_dip || far.is_inside() != middle.is_inside() ||
                near.is_inside() != middle.is_inside() ||
                std::abs(middle.excess) > std::min(std::abs(far.excess), std::abs(near.excess)))
                continue;
            const Answer turn = nearest_to_half(near.distance, far.distance, middle.is_inside());
            if (turn.is_inside() != middle.is_inside()) {
                const auto place = answers_.begin() + static_cast<std::ptrdiff_t>(i) +
                                   (turn.distance < middle.distance ? 1 : 0);
                answers_.insert(place, turn);
                ++i;
            }
        }
    }

    /// By golden sections, until an answer is on the other side or the bracket is narrow.
    Answer nearest_to_half(double near, double far, bool inside) const {
        constexpr double golden = 0.6180339887498949;
        Answer a = ask(far - golden * (far - near)), b = ask(near + golden * (far - near));
        while (far - near > turn_width && a.is_inside() == inside && b.is_inside() == inside) {
            if (std::abs(a.excess) < std::abs(b.excess)) {
                far = b.distance;
                b = a;
                a = ask(far - golden * (far - near));
            } else {
                near = a.distance;
                a = b;
                b = ask(near + golden * (far - near));
            }
        }
        return b.is_inside() != inside ? b : a;
    }

    double change_between(Answer near, Answer far) const {
        while (far.distance - near.distance > root_width) {
            const Answer middle = ask(0.5 * (near.distance + far.distance));
            (middle.is_inside() == far.is_inside() ? far : near) = middle;
        }
        return 0.5 * (near.distance + far.distance);
    }

    /// Stretches that touch are one: a ray runs through a cover, not against it.
    void add(double begin, double end) {
        if (!segments_.empty() && segments_.back().begin - end <= beside_a_crossing)
            segments_.back().begin = begin;
        else
            segments_.push_back({begin, end});
    }

    const OpenInterior& interior_;
    glm::dvec3 origin_, direction_;
    std::vector<Segment>& segments_;
    std::vector<double> questions_; // distances, farthest first
    std::vector<Answer> answers_;   // in the gap in hand, farthest first
    int enclosing_ = 0;
};

void OpenInterior::follow(glm::vec3 origin,
                          glm::dvec3 direction,
                          std::span<const Hit> hits,
                          std::vector<Segment>& segments) const {
    segments.clear();
    Ray ray(*this, origin, direction, segments);
    const double farthest = hits.empty() ? 0 : hits.front().distance;
    double end = std::max(leaves_the_scene(origin, direction), farthest);
    for (const Hit& hit : hits) {
        if (end > hit.distance)
            ray.follow_gap(hit.distance, end);
        end = hit.distance;
        ray.cross(hit.leaving);
    }
    if (end > 0)
        ray.follow_gap(0, end);
}

} // namespace renderer::geometry
