// High degrees, poles, and every number of digits that is promised.
#include "renderer/geometry/body_thickness.h"
#include "renderer/harmonics/basis.h"
#include "renderer/harmonics/basis_blocks.h"
#include "renderer/harmonics/directions.h"
#include "renderer/harmonics/gauss_legendre.h"
#include "renderer/harmonics/projection.h"
#include "tests/hard_cases/hard_cases.h"
#include "tests/renderer/harmonics/exact_basis.h"

#include <glm/geometric.hpp>

#include <numbers>

namespace hard_cases {

namespace {

using namespace renderer::harmonics;

const std::string area = "spherical harmonics";
const std::string extended = "recurrence in 64 bits";

/// Evenly over the sphere and ever closer to both poles and the equator.
std::vector<glm::dvec3> directions(int evenly) {
    auto all = fibonacci_directions(evenly, 3).directions;
    for (int decade = 1; decade <= 12; ++decade)
        for (const auto& s :
             fibonacci_directions(8, static_cast<std::uint64_t>(decade)).directions) {
            const double small = std::pow(10.0, -decade);
            all.push_back(glm::normalize(glm::dvec3(small * s.x, small * s.y, s.z)));
            all.push_back(glm::normalize(glm::dvec3(s.x, s.y, small * s.z)));
        }
    return all;
}

std::vector<double> basis_at(int bands, glm::dvec3 s) {
    std::vector<double> y(static_cast<std::size_t>(coefficient_count(bands)));
    evaluate(bands, s, y);
    return y;
}

long double legendre(int l, long double x) {
    long double before = 1, p = x;
    for (int k = 2; k <= l; ++k) {
        const long double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p;
        p = next;
    }
    return l == 0 ? 1 : p;
}

Case degree_100() {
    Worst worst(area, "degree 100, every order, up to the poles; of its greatest value", extended,
                12);
    const long double greatest = std::sqrt(201 / (4 * std::numbers::pi_v<long double>));
    for (const auto& s : directions(40)) {
        const auto y = basis_at(101, s);
        const auto exact = exact_basis(101, s);
        for (std::size_t i = 10000; i < y.size(); ++i)
            worst.see(y[i], exact[i], greatest);
    }
    return worst.result();
}

/// sum_m y(a) y(b) = (2l+1)/4pi P_l(a.b)
Case addition_theorem() {
    Worst worst(area, "degree 100, products of two directions summed over orders",
                "addition theorem", 12);
    const auto all = fibonacci_directions(24, 5).directions;
    const long double scale = 201 / (4 * std::numbers::pi_v<long double>);
    for (const auto& a : all)
        for (const auto& b : all) {
            const auto at_a = basis_at(101, a), at_b = basis_at(101, b);
            double sum = 0;
            for (std::size_t i = 10000; i < at_a.size(); ++i)
                sum += at_a[i] * at_b[i];
            const auto dot = [](glm::dvec3 u, glm::dvec3 v) {
                return static_cast<long double>(u.x) * v.x + static_cast<long double>(u.y) * v.y +
                       static_cast<long double>(u.z) * v.z;
            };
            const long double cosine = dot(a, b) / std::sqrt(dot(a, a) * dot(b, b));
            worst.see(sum, scale * legendre(100, cosine), scale);
        }
    return worst.result();
}

/// All squares of n bands add up to n^2/4pi; factorials would have ended at degree 85.
Case degree_1000() {
    Worst worst(area, "degrees 0 to 1000, sum of all squares", "n^2 / 4 pi", 12);
    double sum = 0;
    for (const double y : basis_at(1001, {0.6, 0, 0.8}))
        sum += y * y;
    worst.see(sum, 1001 * 1001 / (4 * std::numbers::pi_v<long double>));
    return worst.result();
}

Case poles() {
    Worst worst(area, "at the poles, orders other than 0 to degree 100", "zero, exactly", 17);
    for (const double z : {1.0, -1.0})
        for (const int bands : {5, 10, 101}) {
            const auto y = basis_at(bands, {0, -0.0, z});
            for (int l = 0; l < bands; ++l)
                for (int m = -l; m <= l; ++m)
                    if (m != 0)
                        worst.see(y[static_cast<std::size_t>(flat_index(l, m))], 0, 1);
        }
    return worst.result();
}

/// Values of type T; error of the value itself, in the direction that the T's point to.
template <class T>
Case in_blocks_of(int bands, const std::string& what, double largest_error) {
    Worst worst(area, what, extended, -std::log10(largest_error));
    const auto all = directions(2000);
    const auto blocks = in_blocks<T>(all);
    const auto n = static_cast<std::size_t>(coefficient_count(bands));
    const auto width = static_cast<std::size_t>(lanes<T>);
    std::vector<Line<T>> values(blocks.size() * n);
    evaluate_blocks<T>(bands, blocks, values);
    for (std::size_t j = 0; j < all.size(); ++j) {
        const auto rounded = [&](double x) { return static_cast<double>(static_cast<T>(x)); };
        const auto exact =
            exact_basis(bands, {rounded(all[j].x), rounded(all[j].y), rounded(all[j].z)});
        for (std::size_t i = 0; i < n; ++i)
            worst.see(static_cast<double>(values[j / width * n + i].at[j % width]), exact[i], 1);
    }
    return worst.result();
}

/// The integral of y_i y_j over a rule that is exact for it.
Case gram_matrix() {
    Worst worst(area, "products of 12 bands, integrated", "orthonormality", 13);
    const int bands = 12;
    const auto set = gauss_directions(2 * (bands - 1));
    const auto n = static_cast<std::size_t>(coefficient_count(bands));
    std::vector<double> gram(n * n);
    for (std::size_t j = 0; j < set.directions.size(); ++j) {
        const auto y = basis_at(bands, set.directions[j]);
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b <= a; ++b)
                gram[a * n + b] += set.weights[j] * y[a] * y[b];
    }
    for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b <= a; ++b)
            worst.see(gram[a * n + b], a == b ? 1 : 0, 1);
    return worst.result();
}

/// What a shell's 25 coefficients hold of the thickness seen from its pole N, d depending on
/// x = N.s only: by Gauss's rule in each smooth piece, the root under the inner wall undone by
/// w^2 = x^2 - x_0^2.
double energy_held(double inner_radius, int bands) {
    const double graze = -std::sqrt(1 - inner_radius * inner_radius);
    std::vector<double> zonal(static_cast<std::size_t>(bands)), y;
    double all = 0;
    const auto add = [&](double x, double d, double weight) {
        y = basis_at(bands, {std::sqrt(1 - x * x), 0, x});
        for (int l = 0; l < bands; ++l)
            zonal[static_cast<std::size_t>(l)] +=
                weight * d * y[static_cast<std::size_t>(flat_index(l, 0))];
        all += weight * d * d;
    };
    for (const auto& [node, share] : gauss_legendre(40)) {
        const double u = (node + 1) / 2, weight = share / 2 * 2 * std::numbers::pi;
        add(graze * u, -2 * graze * u, -graze * weight);
        const double w = inner_radius * u, x = -std::sqrt(w * w + graze * graze);
        add(x, -2 * x - 2 * w, weight * inner_radius * w / -x);
    }
    double held = 0;
    for (const double c : zonal)
        held += c * c;
    return held / all;
}

/// The same from the directions that a thickness field is traced in, and the body's own thickness.
Case thin_shells() {
    Worst worst("thin shells", "share of the energy in 25 coefficients, walls of 0.5 to 0.01",
                "quadrature by pieces", 1.5);
    const auto set = fibonacci_directions(1024, 1);
    const auto rows = projection_rows(5, set);
    for (const double inner : {0.5, 0.9, 0.99}) {
        std::vector<double> samples;
        double all = 0, held = 0;
        for (std::size_t j = 0; j < set.directions.size(); ++j) {
            samples.push_back(
                renderer::geometry::shell_thickness(1, inner, {0, 0, 1}, set.directions[j]).sum);
            all += set.weights[j] * samples.back() * samples.back();
        }
        for (const double c : project(rows, samples))
            held += c * c;
        worst.see(held / all, static_cast<long double>(energy_held(inner, 5)));
    }
    return worst.result();
}

} // namespace

void add_harmonics(std::vector<Case>& cases) {
    cases.push_back(in_blocks_of<double>(5, "five bands in double, error of a value", 2e-15));
    cases.push_back(in_blocks_of<double>(10, "ten bands in double", 1.2e-14));
    cases.push_back(in_blocks_of<float>(5, "five bands in float", 7e-7));
    cases.push_back(in_blocks_of<float>(10, "ten bands in float", 1.8e-6));
    cases.push_back(degree_100());
    cases.push_back(addition_theorem());
    cases.push_back(degree_1000());
    cases.push_back(poles());
    cases.push_back(gram_matrix());
    cases.push_back(thin_shells());
}

} // namespace hard_cases
