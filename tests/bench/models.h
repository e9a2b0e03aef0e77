// Models by name, and what a bench does when there is none.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh_repair.h"
#include "renderer/geometry/model_library.h"

#include <stdexcept>
#include <string>
#include <utility>

namespace bench {

template <class T>
T value_or_throw(renderer::Expected<T> result) {
    if (!result)
        throw std::runtime_error(result.error());
    return std::move(*result);
}

/// A model by its name in the working directory or on a path, or a body.
inline renderer::geometry::Mesh load_mesh(const std::string& name) {
    using namespace renderer::geometry;
    const auto model = value_or_throw(find_model(name, {".", {"."}}));
    return value_or_throw(prepare(value_or_throw(load_model(model)), name)).mesh;
}

} // namespace bench
