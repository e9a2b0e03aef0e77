// Rays along surfaces, through edges, in models far away, tiny or thin.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/crossings.h"
#include "renderer/harmonics/directions.h"
#include "renderer/thickness/thickness_field.h"
#include "tests/hard_cases/hard_cases.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>

namespace hard_cases {

namespace {

using namespace renderer::geometry;
using renderer::thickness::Kind;

const std::string area = "rays";

struct Exact {
    long double x, y, z;
};

Exact exact(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}

Exact operator-(Exact a, Exact b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

long double dot(Exact a, Exact b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Exact cross(Exact a, Exact b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// From a vertex of a convex mesh to where the ray leaves: the nearest of all planes ahead.
long double convex_thickness(const Mesh& mesh, std::uint32_t vertex, glm::dvec3 direction) {
    const Exact p = exact(mesh.positions[vertex]), s = exact(direction);
    long double nearest = std::numeric_limits<long double>::infinity();
    for (const auto& t : mesh.triangles) {
        const Exact a = exact(mesh.positions[t[0]]);
        const Exact n = cross(exact(mesh.positions[t[1]]) - a, exact(mesh.positions[t[2]]) - a);
        const long double ahead = dot(n, s);
        const bool is_own = std::find(t.begin(), t.end(), vertex) != t.end();
        if (ahead > 0)
            nearest = std::min(nearest, is_own ? 0 : dot(n, a - p) / ahead);
    }
    return nearest;
}

double summed(std::span<const Segment> segments) {
    double sum = 0;
    for (const auto& [begin, end] : segments)
        sum += end - begin;
    return sum;
}

/// Compares every `stride`-th vertex in the directions that `directions(normal)` names.
template <class Directions>
void see_convex(Worst& worst, const Mesh& mesh, std::uint32_t stride, Directions directions) {
    const RayScene scene(mesh);
    const DenormalsAreZero guard;
    InteriorTracer tracer(scene);
    const auto normals = vertex_normals(mesh);
    for (std::uint32_t v = 0; v < mesh.positions.size(); v += stride)
        for (const glm::dvec3 s : directions(normals[v])) {
            const glm::dvec3 asked(glm::vec3{s}); // as it will be traced
            worst.see(summed(tracer.from_vertex(v, asked)), convex_thickness(mesh, v, asked),
                      scene.model_per_scene());
        }
}

std::vector<glm::dvec3> into(glm::dvec3 normal) {
    std::vector<glm::dvec3> inward;
    for (const auto& s : renderer::harmonics::fibonacci_directions(12, 9).directions)
        inward.push_back(glm::dot(s, normal) < 0 ? s : -s);
    return inward;
}

std::vector<glm::dvec3> grazing(glm::dvec3 normal) {
    const auto along = glm::normalize(glm::cross(normal, glm::dvec3(0.36, 0.48, 0.8)));
    const auto across = glm::cross(normal, along);
    std::vector<glm::dvec3> all;
    for (const double slope : {1e-7, -1e-7, -1e-5, -1e-3, -1e-2, -0.04, -0.1})
        for (const auto& tangent : {along, -along, across, -across})
            all.push_back(glm::normalize(tangent + slope * normal));
    return all;
}

Mesh moved(Mesh mesh, double scale, glm::dvec3 offset) {
    for (auto& p : mesh.positions)
        p = scale * p + offset;
    return mesh;
}

constexpr const char* clipping = "clipping by planes in 64 bits";
const glm::dvec3 far_away(1e6, -1e6, 1e6);

Case grazing_rays() {
    Worst worst(area, "grazing a sphere, N.s = 1e-7 to -0.1; of the diameter", clipping, 5.5);
    see_convex(worst, sphere(1, 4), 17, grazing);
    return worst.result();
}

/// From the grid of one face of a cube straight and aslant through the grids of others.
Case edges_and_vertices() {
    Worst worst(area, "through edges and vertices of a cube; of the diameter", clipping, 6);
    const auto cube = slab(2, 2, 2, 8);
    const RayScene scene(cube);
    const DenormalsAreZero guard;
    InteriorTracer tracer(scene);
    for (std::uint32_t v = 0; v < cube.positions.size(); ++v) {
        const auto& p = cube.positions[v];
        if (!(p.z > 0.999 && std::abs(p.x) < 0.999 && std::abs(p.y) < 0.999))
            continue;
        for (const glm::dvec3 way :
             {glm::dvec3(0, 0, -1), {0, 1, -1}, {-1, 0, -1}, {1, 1, -1}, {0.25, 0.5, -1}}) {
            const auto s = glm::normalize(way);
            worst.see(summed(tracer.from_vertex(v, s)), convex_thickness(cube, v, s),
                      scene.model_per_scene());
        }
    }
    return worst.result();
}

Case far_model() {
    Worst worst(area, "a model of diameter 2 at (1e6, -1e6, 1e6); of the diameter", clipping, 6);
    see_convex(worst, moved(sphere(1, 2), 1, far_away), 1, into);
    return worst.result();
}

Case scaled_model(double scale, const std::string& what) {
    Worst worst(area, what, clipping, 6);
    see_convex(worst, moved(sphere(1, 2), scale, {}), 1, into);
    return worst.result();
}

/// Coefficients are lengths: those of a model that is moved or scaled follow it.
Case coefficients_elsewhere(double scale, glm::dvec3 offset, const std::string& what) {
    Worst worst("coefficients", what, "the same model at home", 6);
    const auto mesh = torus(0.7, 0.3, 24, 12);
    const renderer::thickness::FieldOptions options{.bands = 4, .directions = 128};
    const auto home = renderer::thickness::compute_thickness_field(mesh, options).value();
    const auto there =
        renderer::thickness::compute_thickness_field(moved(mesh, scale, offset), options).value();
    const float largest = *std::max_element(home.coefficients.begin(), home.coefficients.end());
    for (std::size_t i = 0; i < home.coefficients.size(); ++i)
        worst.see(static_cast<double>(there.coefficients[i]) / scale,
                  static_cast<long double>(home.coefficients[i]),
                  static_cast<long double>(largest));
    return worst.result();
}

/// Straight through the middle, where rays meet the vertices of all four surfaces.
Case thin_shell(Kind kind, const std::string& what, long double expected, double floor) {
    constexpr double thin = 1e-4;
    Worst worst(area, what, "by construction", floor);
    const auto mesh = shell(1, 1 - thin, 3);
    const RayScene scene(mesh);
    const DenormalsAreZero guard;
    InteriorTracer tracer(scene);
    for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
        const auto& p = mesh.positions[v];
        if (glm::length(p) < 1 - thin / 2)
            continue;
        const auto segments = tracer.from_vertex(v, glm::normalize(-p));
        worst.see(segments.empty()     ? 0
                  : kind == Kind::Sum  ? summed(segments)
                  : kind == Kind::Span ? segments.back().end
                                       : segments.front().end,
                  expected);
    }
    return worst.result();
}

} // namespace

void add_rays(std::vector<Case>& cases) {
    cases.push_back(grazing_rays());
    cases.push_back(edges_and_vertices());
    cases.push_back(far_model());
    cases.push_back(scaled_model(1e-6, "a model of diameter 2e-6; of the diameter"));
    cases.push_back(scaled_model(1e6, "a model of diameter 2e6; of the diameter"));
    cases.push_back(thin_shell(Kind::Sum, "a shell 1e-4 thick, both walls", 2e-4L, 2));
    cases.push_back(thin_shell(Kind::First, "the same, the first wall", 1e-4L, 2));
    cases.push_back(thin_shell(Kind::Span, "the same, to the last exit", 2, 5.5));
    cases.push_back(coefficients_elsewhere(1, far_away, "a ring of size 1 at (1e6, -1e6, 1e6)"));
    cases.push_back(coefficients_elsewhere(1e-6, {}, "a ring of size 1e-6"));
    cases.push_back(coefficients_elsewhere(1e6, {}, "a ring of size 1e6"));
}

} // namespace hard_cases
