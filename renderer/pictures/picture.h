// One antialiased picture of a scene by a method, in linear light.
#pragma once

#include "renderer/expected.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"

#include <glm/vec2.hpp>

#include <vector>

namespace renderer::pictures {

/// Where in a pixel the samples lie: offsets from its centre, -0.5..0.5, in pixels.  The points
/// ((i + 1/2)/n, bit-reversed i + 1/(2n)): every row and column of an n x n grid has one, and a
/// single sample is the centre.
/// Errors: EXPECTS samples >= 1.
std::vector<glm::dvec2> sample_offsets(int samples);

/// Updates `method` and draws it `samples` times, each time moved by a part of a pixel, with
/// black behind; the mean is taken in linear light and double precision.  Coverage is the share of
/// samples that met the object, and colours are premultiplied by it.
/// Needs a current OpenGL 4.5 context, the one the method was prepared in.
/// Errors: a light without a direction, a size the device cannot draw, OpenGL's own.
Expected<imaging::LinearImage>
render_picture(methods::Method& method, const Scene& scene, int width, int height, int samples);

} // namespace renderer::pictures
