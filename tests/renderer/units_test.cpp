// What must not compile, and what must.
#include "renderer/units.h"

namespace {

using namespace renderer;

template <class A, class B>
concept Addable = requires(A a, B b) {
    a + b;
};

template <class A, class B>
concept Multipliable = requires(A a, B b) {
    a* b;
};

template <class A, class B>
concept AssignableFrom = requires(A a, B b) {
    a = b;
};

static_assert(!Addable<Millimetres, PerMillimetre>);
static_assert(!Multipliable<Millimetres, Millimetres>);
static_assert(Multipliable<PerMillimetre, Millimetres>);
static_assert(!AssignableFrom<LinearRgb&, EncodedRgb>);
static_assert(!AssignableFrom<EncodedRgb&, LinearRgb>);

TEST(Units, OpticalThicknessIsExtinctionTimesLength) {
    EXPECT_DOUBLE_EQ(PerMillimetre{0.5} * Millimetres{10.0}, 5.0);
}

TEST(Units, HalfATurnIsPiRadians) {
    EXPECT_DOUBLE_EQ(from_degrees(180.0).value, std::numbers::pi);
}

} // namespace
