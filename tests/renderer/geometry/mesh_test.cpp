// Bounding sphere, volume and vertex normals against shapes one can work out by hand.
#include "renderer/geometry/bodies.h"
#include "renderer/geometry/mesh.h"

#include <glm/geometric.hpp>

namespace {

using namespace renderer::geometry;

Mesh moved(Mesh mesh, double scale, glm::dvec3 offset) {
    for (auto& p : mesh.positions)
        p = scale * p + offset;
    return mesh;
}

TEST(BoundingSphere, OfABoxReachesItsCorners) {
    const auto sphere = bounding_sphere(moved(slab(2, 4, 4, 3), 1, {10, -5, 1}));
    EXPECT_EQ(sphere.centre, glm::dvec3(10, -5, 1));
    EXPECT_DOUBLE_EQ(sphere.radius, 3); // |(1, 2, 2)|
}

TEST(BoundingSphere, OfNothingIsAPointAtTheOrigin) {
    EXPECT_EQ(bounding_sphere({}).radius, 0);
    EXPECT_EQ(bounding_sphere({}).centre, glm::dvec3(0));
}

TEST(SignedVolume, OfABoxIsTheProductOfItsEdges) {
    EXPECT_NEAR(signed_volume(slab(2, 3, 5, 4)), 30, 1e-13 * 30);
}

TEST(SignedVolume, ChangesSignWithTheOrientation) {
    auto mesh = slab(2, 3, 5, 4);
    for (auto& triangle : mesh.triangles)
        std::swap(triangle[1], triangle[2]);
    EXPECT_NEAR(signed_volume(mesh), -30, 1e-13 * 30);
}

TEST(SignedVolume, KeepsItsDigitsFarFromTheOrigin) {
    // Positions near 1e6 are rounded to 1e-10, a part in 1e10 of this sphere's radius; from the
    // origin the tetrahedra would cancel away six digits of the volume more.
    const auto here = sphere(1, 3);
    const auto there = moved(here, 1, {1e6, -1e6, 1e6});
    EXPECT_NEAR(signed_volume(there), signed_volume(here), 1e-9);
}

TEST(VertexNormals, OfASpherePointAwayFromItsCentre) {
    const auto mesh = sphere(2, 4);
    const auto normals = vertex_normals(mesh);
    ASSERT_EQ(normals.size(), mesh.positions.size());
    for (std::size_t v = 0; v < normals.size(); ++v) {
        EXPECT_NEAR(glm::length(normals[v]), 1, 1e-14);
        // The fan around a vertex is not quite regular: off by order h^2, h = 0.07 here.
        EXPECT_GE(glm::dot(normals[v], mesh.positions[v] / 2.0), 1 - 1e-5);
    }
}

TEST(VertexNormals, DoNotDependOnHowAFaceIsCutIntoTriangles) {
    // At a cube's corner three right angles meet, however many triangles share each.
    const auto mesh = slab(1, 1, 1, 1);
    const auto normals = vertex_normals(mesh);
    ASSERT_EQ(normals.size(), 8u);
    for (std::size_t v = 0; v < normals.size(); ++v)
        EXPECT_LE(glm::distance(normals[v], glm::normalize(mesh.positions[v])), 1e-14);
}

TEST(VertexNormals, AreZeroWhereThereIsNoArea) {
    const Mesh needle{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}}, {{0, 1, 2}}};
    const auto normals = vertex_normals(needle);
    ASSERT_EQ(normals.size(), 4u);
    for (const auto& normal : normals)
        EXPECT_EQ(normal, glm::dvec3(0));
}

} // namespace
