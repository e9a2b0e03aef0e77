// From samples over the sphere to spherical-harmonic coefficients, by weighted least squares.
#pragma once

#include "renderer/harmonics/directions.h"

#include <span>
#include <vector>

namespace renderer::harmonics {

/// How much a sample at each direction adds to each coefficient: the rows of W Y G^-1, with
/// G = Y^T W Y.  On a rule that integrates products of basis functions exactly, G is the identity
/// and row j is w_j y(s_j); elsewhere least squares removes what the rule gets wrong.
/// Shape:  rows[j * bands^2 + i].
/// Errors: EXPECTS bands >= 1 and directions that tell bands^2 functions apart.
std::vector<double> projection_rows(int bands, const DirectionSet& set);

/// Coefficients of the function with these samples: c_i = sum_j samples[j] rows[j * bands^2 + i].
/// Errors: EXPECTS rows.size() to be a multiple of samples.size().
std::vector<double> project(std::span<const double> rows, std::span<const double> samples);

} // namespace renderer::harmonics
