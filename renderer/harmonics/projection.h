// From samples over the sphere to spherical-harmonic coefficients, by weighted least squares.
#pragma once

#include "renderer/harmonics/directions.h"

#include <cstddef>
#include <span>
#include <vector>

namespace renderer::harmonics {

/// How much a sample at each direction adds to each coefficient: the rows of W Y G^-1, with
/// G = Y^T W Y.  On a rule that integrates products of basis functions exactly, G is the identity
/// and row j is w_j y(s_j); elsewhere least squares removes what the rule gets wrong.
/// Shape:  rows[j * bands^2 + i].
/// Errors: EXPECTS 1..10 bands and directions that tell bands^2 functions apart.
std::vector<double> projection_rows(int bands, const DirectionSet& set);

/// Adds functions sampled in some of the directions to their coefficients: values[v][j], in the
/// direction of row j, times that row, to the coefficients of v.
/// Shapes: values.size() / directions functions of rows.size() / directions coefficients each.
/// Errors: EXPECTS directions >= 1 and sizes that agree.
void accumulate(std::span<const double> values,
                std::size_t directions,
                std::span<const double> rows,
                std::span<double> coefficients);

/// Coefficients of the function with these samples: c_i = sum_j samples[j] rows[j * bands^2 + i].
/// Errors: EXPECTS rows.size() to be a multiple of samples.size().
std::vector<double> project(std::span<const double> rows, std::span<const double> samples);

} // namespace renderer::harmonics
