// How far the pictures of a method are from those that they are compared with.
#pragma once

#include "experiment/cost/lit_case.h"
#include "renderer/methods/method.h"

#include <tl/expected.hpp>

#include <span>
#include <string>
#include <vector>

namespace experiment::cost {

/// All but `fitted`; `law` where the method has one.
/// Errors: pixels that are no number; a picture that is black; OpenGL's own.
tl::expected<LightErrors, std::string>
compare_picture(renderer::methods::Method& method, const Lit& lit, bool has_law, int samples);

/// Of the pictures with one set of coefficients for all lights together, light by light; nothing
/// where one of them has no path-traced picture.
/// Errors: the same.
tl::expected<std::vector<double>, std::string>
fitted_errors(renderer::methods::Method& method, std::span<const Lit> lights, int samples);

} // namespace experiment::cost
