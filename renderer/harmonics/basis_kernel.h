// The arithmetic of spherical harmonics, written once for a number and for a register full of them.
//
// y(l, +-m) = q(2z^2 - 1) z^p (C_m, S_m), with C_m + i S_m = (x + iy)^m, p = (l - m) mod 2 and q a
// polynomial of degree (l - m - p)/2 (renderer/harmonics/basis_polynomials.h).  Functions of z are
// steepest beside a pole, where z is near 1 and a rounded z says least of the direction: there the
// argument is taken from x and y, which are small and say all.  In float, ten bands err by 1.2e-6
// so, and by 4.0e-6 with recurrences in z.
//
// Each file that includes this is compiled for another set of instructions.  So everything has
// internal linkage and nothing is called from a library: the linker keeps one copy of an inline
// function, and it might keep the one that this processor cannot run.  For the same reason tables
// are constinit: nothing of such a file runs before main.  No multiplication is fused
// with an addition anywhere (-ffp-contract=off): every set of instructions gives the same bits.
#pragma once

#include "renderer/harmonics/basis_kernels.h"

#include <utility>

namespace renderer::harmonics {

namespace {

/// q(t), highest power first; `Degree + 1` constants.
template <int Degree, class V, class T>
inline __attribute__((always_inline)) V polynomial(V t, const T* constants) {
    if constexpr (Degree == 0)
        return V{} + constants[0];
    else {
        V q = constants[0] * t + constants[1];
        for (int i = 2; i <= Degree; ++i)
            q = q * t + constants[i];
        return q;
    }
}

/// Degrees L, L+2, ... of order M: `c` and `s` are z^p C_m and z^p S_m, value i goes to
/// out[i * Stride].  Returns the constants of what comes next.
template <int Bands, int Stride, int M, int L, class V, class T>
inline __attribute__((always_inline)) const T*
store_degrees(V t, V c, V s, const T* constants, T* out) {
    if constexpr (L < Bands) {
        typedef V Stored __attribute__((may_alias));
        constexpr int degree = (L - M) / 2;
        const V q = polynomial<degree>(t, constants);
        *reinterpret_cast<Stored*>(out + (L * (L + 1) + M) * Stride) = q * c;
        if constexpr (M > 0)
            *reinterpret_cast<Stored*>(out + (L * (L + 1) - M) * Stride) = q * s;
        return store_degrees<Bands, Stride, M, L + 2>(t, c, s, constants + degree + 1, out);
    } else
        return constants;
}

template <class V>
struct Place {
    V x, y, z;
    V t; ///< 2z^2 - 1
};

/// 1 - 2w with w = x^2 + y^2 toward the poles, 2z^2 - 1 toward the equator.
template <class T, class V>
inline __attribute__((always_inline)) V cosine_of_twice(const Place<V>& at) {
    const V zz = at.z * at.z, w = at.x * at.x + at.y * at.y;
    return zz > w ? T{1} - (w + w) : (zz + zz) - T{1};
}

/// Orders M, M+1, ...
template <int Bands, int Stride, int M, class V, class T>
inline __attribute__((always_inline)) void
store_orders(const Place<V>& at, V c, V s, const T* constants, T* out) {
    if constexpr (M < Bands) {
        constants = store_degrees<Bands, Stride, M, M>(at.t, c, s, constants, out);
        constants =
            store_degrees<Bands, Stride, M, M + 1>(at.t, at.z * c, at.z * s, constants, out);
        if constexpr (M == 0)
            store_orders<Bands, Stride, 1>(at, at.x, at.y, constants, out);
        else
            store_orders<Bands, Stride, M + 1>(at, at.x * c - at.y * s, at.x * s + at.y * c,
                                               constants, out);
    }
}

/// As many numbers as one register holds.
template <class T, int Bytes>
struct Register {
    typedef T Type __attribute__((vector_size(Bytes)));
};

template <class T>
struct Register<T, sizeof(T)> {
    using Type = T;
};

/// Blocks of `Lanes` directions, x y z each Lanes numbers, to blocks of Bands^2 times Lanes values.
template <class T, int Lanes, int Bytes, int Bands>
void evaluate_blocks_of(const T* __restrict directions,
                        unsigned long blocks,
                        const T* __restrict constants,
                        T* __restrict out) {
    using V = typename Register<T, Bytes>::Type;
    typedef V Stored __attribute__((may_alias));
    constexpr int width = Bytes / static_cast<int>(sizeof(T));
    for (unsigned long block = 0; block < blocks; ++block) {
        for (int lane = 0; lane < Lanes; lane += width) {
            const auto* d = reinterpret_cast<const Stored*>(directions + lane);
            constexpr int next = Lanes / width;
            Place<V> at{d[0], d[next], d[2 * next], V{}};
            at.t = cosine_of_twice<T>(at);
            store_orders<Bands, Lanes, 0>(at, V{} + T{1}, V{}, constants, out + lane);
        }
        directions += 3 * Lanes;
        out += Bands * Bands * Lanes;
    }
}

/// Kernels for registers of so many bytes.
template <int Bytes, int... Before>
constexpr BlockKernels kernels_of(std::integer_sequence<int, Before...>) {
    return {{evaluate_blocks_of<double, lanes<double>, Bytes, Before + 1>...},
            {evaluate_blocks_of<float, lanes<float>, Bytes, Before + 1>...}};
}

using UnrolledBands = std::make_integer_sequence<int, most_unrolled_bands>;

} // namespace

} // namespace renderer::harmonics
