// What transport must give, from sources that are no simulation: Chandrasekhar's H function
// evaluated by quadrature, adding-doubling refined until it stands still, the sphere's integral
// equation.  Where the value is itself a simulation's, its error says so.
#pragma once

#include "renderer/reference/energy.h"

#include <limits>
#include <vector>

namespace anchors {

enum class Shape { Slab, Sphere };
enum class Quantity { Back, Through, Escape };

struct Anchor {
    Shape shape;
    Quantity quantity;
    renderer::reference::EnergyProblem problem;
    double exact;
    double exact_error; ///< of `exact`: half its last digit, or its simulation's standard error
    bool is_quick;      ///< known to 1e-3 within a second or so: in the normal suite
};

inline renderer::reference::EnergyBalance balance_of(const Anchor& anchor,
                                                     const renderer::reference::EnergyRun& run) {
    namespace reference = renderer::reference;
    return anchor.shape == Shape::Slab ? reference::slab_energy(anchor.problem, run)
                                       : reference::sphere_energy(anchor.problem, run);
}

/// The share that the anchor speaks of.
inline renderer::reference::Estimate share_of(const Anchor& anchor,
                                              const renderer::reference::EnergyBalance& balance) {
    switch (anchor.quantity) {
    case Quantity::Back:
        return balance.back;
    case Quantity::Through:
        return balance.through;
    case Quantity::Escape:
        break;
    }
    return balance.escape;
}

inline std::vector<Anchor> all() {
    using renderer::reference::Boundary;
    using renderer::reference::BoundaryKind;
    using renderer::reference::Incidence;
    std::vector<Anchor> anchors;
    const auto boundary = [](double index) {
        return Boundary{index == 1 ? BoundaryKind::Matched : BoundaryKind::Smooth};
    };
    constexpr double deep = std::numeric_limits<double>::infinity();
    const auto both = [&](double a, double g, double tau, double index, Quantity quantity,
                          double normal, double diffuse, double error, bool quick) {
        anchors.push_back({Shape::Slab,
                           quantity,
                           {a, g, tau, index, boundary(index), Incidence::Normal},
                           normal,
                           error,
                           quick});
        if (diffuse > 0)
            anchors.push_back({Shape::Slab,
                               quantity,
                               {a, g, tau, index, boundary(index), Incidence::Diffuse},
                               diffuse,
                               error,
                               false});
    };
    const auto half_space = [&](double a, double g, double index, double normal, double diffuse,
                                double error, bool quick = false) {
        both(a, g, deep, index, Quantity::Back, normal, diffuse, error, quick);
    };
    const auto slab = [&](double a, double g, double tau, double index, double r, double t,
                          double r_diffuse, double t_diffuse, double error, bool quick = false) {
        both(a, g, tau, index, Quantity::Back, r, r_diffuse, error, quick && r > 0.3);
        both(a, g, tau, index, Quantity::Through, t, t_diffuse, error, quick && t > 0.3);
    };

    // Half-space, isotropic, no refraction: Chandrasekhar.
    half_space(0.5, 0, 1, 0.115225878, 0.146544381, 0, true);
    half_space(0.7, 0, 1, 0.208679952, 0.256556653, 0);
    half_space(0.9, 0, 1, 0.414947479, 0.478024489, 0, true);
    half_space(0.95, 0, 1, 0.535540989, 0.596668780, 0);
    half_space(0.99, 0, 1, 0.752720717, 0.794563653, 0);
    half_space(0.999, 0, 1, 0.912845335, 0.929713285, 0);
    // The same with a smooth boundary; what the surface reflects is apart.
    half_space(0.9, 0, 1.3, 0.2857828, 0.2883341, 5e-8);
    half_space(0.99, 0, 1.3, 0.6453937, 0.6305512, 5e-8);
    half_space(0.999, 0, 1.3, 0.8567544, 0.8247878, 5e-8);
    half_space(0.9, 0, 1.4, 0.2505959, 0.2489355, 5e-8);
    half_space(0.99, 0, 1.4, 0.6035893, 0.5840070, 5e-8);
    half_space(0.5, 0, 1.5, 0.0442459, 0.0443435, 5e-8);
    half_space(0.9, 0, 1.5, 0.2199186, 0.2161121, 5e-8);
    half_space(0.99, 0, 1.5, 0.5619808, 0.5401830, 5e-8);
    half_space(0.999, 0, 1.5, 0.8014585, 0.7624620, 5e-8);
    // Henyey-Greenstein media.
    half_space(0.9, 0.5, 1, 0.2777824, 0.3601516, 1e-7);
    half_space(0.9, 0.75, 1, 0.1655172, 0.2489699, 1e-7);
    half_space(0.9, 0.9, 1, 0.0685660, 0.1325849, 1e-7);
    half_space(0.9, -0.5, 1, 0.5026725, 0.5468556, 1e-7, true);
    half_space(0.99, 0.5, 1, 0.6646070, 0.7234413, 1e-7);
    half_space(0.99, 0.75, 1, 0.5591697, 0.6348151, 1e-7);
    half_space(0.99, 0.9, 1, 0.3995406, 0.4934154, 1e-7);
    half_space(0.999, 0.75, 1, 0.8311605, 0.8647523, 1e-7);
    half_space(0.999, 0.9, 1, 0.7459538, 0.7954316, 1e-7);
    half_space(0.99, 0.75, 1.3, 0.4360737, 0.4363368, 1e-7);
    half_space(0.999, 0.9, 1.3, 0.6452318, 0.6311072, 1e-7);
    half_space(0.99, 0.9, 1.5, 0.2204660, 0.2190817, 1e-7);
    half_space(0.9, 0.75, 1.5, 0.069707, 0.072185, 1e-6);
    half_space(0.999, 0.9, 1.5, 0.562454, 0.540814, 1e-6);
    // Slabs.
    slab(0.9, 0.75, 2, 1, 0.0973946, 0.6609577, 0.1910902, 0.5018161, 5e-8, true);
    slab(0.5, 0, 1, 1, 0.0991192, 0.4460584, 0.1341652, 0.3067088, 5e-8);
    slab(0.9, 0, 1, 1, 0.2674103, 0.5916251, 0.3527120, 0.4747459, 5e-8);
    slab(0.9, 0, 2, 1, 0.3616489, 0.3565007, 0.4371469, 0.2655813, 5e-8, true);
    slab(0.9, 0, 8, 1, 0.4148432, 0.0160196, 0.4779526, 0.0110285, 5e-8);
    slab(0.9, 0.9, 8, 1, 0.0645535, 0.2664128, 0.1299455, 0.1645104, 5e-8);
    slab(0.99, 0.75, 8, 1, 0.4330482, 0.4163357, 0.5371482, 0.3220248, 5e-8);
    slab(1, 0, 1, 1, 0.3413288, 0.6586712, 0.4465940, 0.5534060, 5e-8);
    slab(1, 0, 2, 1, 0.5175149, 0.4824851, 0.6099400, 0.3900600, 5e-8);
    slab(1, 0, 8, 1, 0.8218033, 0.1781967, 0.8584706, 0.1415294, 5e-8);
    slab(1, 0.75, 8, 1, 0.5064150, 0.4935850, 0.6108885, 0.3891115, 5e-8);
    slab(1, 0.9, 8, 1, 0.2509955, 0.7490045, 0.4009487, 0.5990513, 5e-8);
    slab(0.9, 0, 2, 1.3, 0.262596, 0.322326, 0, 0, 5e-7);
    slab(1, 0, 2, 1.3, 0.471282, 0.511705, 0, 0, 5e-7);
    slab(0.9, 0, 2, 1.5, 0.213076, 0.288799, 0, 0, 5e-7);
    slab(0.9, 0.75, 2, 1.5, 0.086822, 0.493146, 0, 0, 5e-7, true);
    slab(1, 0, 2, 1.5, 0.449010, 0.510990, 0, 0, 5e-7);
    slab(1, 0.75, 8, 1.5, 0.466602, 0.493398, 0, 0, 5e-7);
    // Spheres under an even sky, isotropic, no refraction: Peierls' equation.
    const auto sphere = [&](double a, double g, double tau, double index, Incidence incidence,
                            Quantity quantity, double exact, double error, bool quick = false) {
        anchors.push_back({Shape::Sphere,
                           quantity,
                           {a, g, tau, index, boundary(index), incidence},
                           exact,
                           error,
                           quick});
    };
    const auto sky = Incidence::Diffuse, beam = Incidence::Normal;
    sphere(0.5, 0, 1, 1, sky, Quantity::Escape, 0.5422571, 5e-8);
    sphere(0.9, 0, 1, 1, sky, Quantity::Escape, 0.8780062, 5e-8);
    sphere(0.99, 0, 1, 1, sky, Quantity::Escape, 0.9867900, 5e-8);
    sphere(0.5, 0, 2, 1, sky, Quantity::Escape, 0.3489238, 5e-8);
    sphere(0.9, 0, 2, 1, sky, Quantity::Escape, 0.7816173, 5e-8, true);
    sphere(0.99, 0, 2, 1, sky, Quantity::Escape, 0.9739195, 5e-8);
    sphere(0.5, 0, 5, 1, sky, Quantity::Escape, 0.2051950, 5e-8);
    sphere(0.9, 0, 5, 1, sky, Quantity::Escape, 0.6234846, 5e-8, true);
    sphere(0.99, 0, 5, 1, sky, Quantity::Escape, 0.9385367, 5e-8);
    sphere(0.5, 0, 10, 1, sky, Quantity::Escape, 0.1703255, 5e-8);
    sphere(0.9, 0, 10, 1, sky, Quantity::Escape, 0.5462861, 5e-8);
    sphere(0.99, 0, 10, 1, sky, Quantity::Escape, 0.8938190, 5e-8);
    // The same with refraction or forward scattering, and in a beam: another program's simulations.
    sphere(0.9, 0, 5, 1.5, sky, Quantity::Escape, 0.428531, 3.5e-5);
    sphere(0.9, 0.8, 5, 1.3, sky, Quantity::Escape, 0.416676, 3.5e-5);
    sphere(0.9, 0.8, 5, 1, sky, Quantity::Escape, 0.552376, 3.5e-5);
    sphere(0.99, 0, 5, 1.3, sky, Quantity::Escape, 0.899708, 3.0e-5);
    sphere(0.9, 0, 5, 1, beam, Quantity::Escape, 0.62343, 5e-5);
    sphere(0.9, 0, 5, 1, beam, Quantity::Through, 0.19958, 5e-5);
    sphere(0.9, 0, 5, 1.3, beam, Quantity::Escape, 0.48673, 5e-5);
    sphere(0.9, 0, 5, 1.3, beam, Quantity::Through, 0.17302, 5e-5);
    sphere(0.99, 0.8, 5, 1.3, beam, Quantity::Escape, 0.89670, 5e-5, true);
    sphere(0.99, 0.8, 5, 1.3, beam, Quantity::Through, 0.55993, 5e-5);
    return anchors;
}

} // namespace anchors
