#include "renderer/geometry/bodies.h"
#include "renderer/harmonics/basis.h"
#include "renderer/thickness/surface_sample.h"

#include <glm/geometric.hpp>

#include <numeric>

namespace {

using namespace renderer;
using namespace renderer::thickness;

class SurfaceSampleTest : public testing::Test {
  protected:
    geometry::Mesh torus_ = geometry::torus(2, 1, 24, 12);
    ThicknessField field_ = *compute_thickness_field(torus_, {.bands = 3, .directions = 64});
};

// Every vertex of so small a mesh: the same sums in the same order.
TEST_F(SurfaceSampleTest, HasTheThicknessOfItsVertices) {
    const auto sample = sample_surface(torus_, field_);
    ASSERT_EQ(sample.size(), torus_.positions.size());
    std::vector<double> y(9), d(3);
    harmonics::evaluate(3, glm::normalize(glm::dvec3(1, -2, 0.5)), y);
    for (std::size_t v = 0; v < sample.size(); ++v) {
        thickness_by_bands(sample, v, y, d);
        for (int n = 1; n <= 3; ++n)
            EXPECT_EQ(d[static_cast<std::size_t>(n) - 1], reconstruct(field_, v, y, n));
    }
}

// A torus repeats itself 24 times: whichever 48 or fewer vertices stand for it, none weighs
// nothing.
TEST_F(SurfaceSampleTest, IsAsLargeAsAsked) {
    const auto sample = sample_surface(torus_, field_, 50);
    EXPECT_EQ(sample.size(), 48U); // every sixth of 288
    EXPECT_EQ(sample.shares.size(), sample.size());
    EXPECT_EQ(sample.coefficients.size(), 9 * sample.size());
    for (const double share : sample.shares)
        EXPECT_GT(share, 0);
}

TEST_F(SurfaceSampleTest, LeavesOutVerticesWithoutANormal) {
    auto mesh = torus_;
    mesh.positions.emplace_back(9, 9, 9); // of no triangle
    auto field = field_;
    field.coefficients.resize(field.coefficients.size() + 9);
    EXPECT_EQ(sample_surface(mesh, field).size(), torus_.positions.size());
}

} // namespace
