// How this module says that a file or a scene disappoints: a value, or a message for the person who
// can mend it.
#pragma once

#include <tl/expected.hpp>

#include <string>

namespace renderer {

/// The error is one line that names file, place, value and remedy.
template <class T>
using Expected = tl::expected<T, std::string>;

} // namespace renderer
