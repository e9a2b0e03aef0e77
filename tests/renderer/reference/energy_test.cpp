// Transport against exact results; the rest of them: tests/bench/transport_precision.cpp.
#include "renderer/reference/energy.h"
#include "tests/renderer/reference/anchors.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace renderer::reference;

// Eleven anchors, 4 standard errors each: one run in 1400 would fail by chance, were the seed not
// fixed.
TEST(Anchors, ThatAreQuickAreMetWithinFourStandardErrors) {
    int seen = 0;
    for (const auto& anchor : anchors::all()) {
        if (!anchor.is_quick)
            continue;
        ++seen;
        const auto& p = anchor.problem;
        const auto name = fmt::format("albedo {} g {} tau {} index {}", p.albedo, p.anisotropy,
                                      p.optical_thickness, p.index);
        const auto found = share_of(anchor, balance_of(anchor, {.paths = 1 << 19}));
        EXPECT_LE(std::abs(found.value - anchor.exact),
                  4 * std::hypot(found.standard_error, anchor.exact_error))
            << name;
        EXPECT_LE(found.standard_error, 1e-3 * anchor.exact) << name;
    }
    EXPECT_GE(seen, 10);
}

// The first order alone: (a/2)(1 - ln 2) of a beam comes back from a half-space after one
// collision.  Found as what the second collision's absorption does not see: here by albedo, since
// orders are powers of it and the first is the slope at none.
TEST(SingleScattering, IsTheSlopeAtNoAlbedo) {
    constexpr double a = 1e-3;
    const auto b =
        slab_energy({a, 0, std::numeric_limits<double>::infinity(), 1}, {.paths = 1 << 18});
    const double first = a * 0.5 * (1 - std::log(2.0));
    EXPECT_LE(std::abs(b.back.value - first), 4 * b.back.standard_error + a * first);
    EXPECT_LE(b.back.standard_error, 2e-3 * first);
}

} // namespace
