// How this module says that its input disappoints: a value, or a message for the person who can
// mend it.
#pragma once

#include <tl/expected.hpp>

#include <string>

namespace protocols {

/// The error is one line that names file, line, value and remedy.
template <class T>
using Expected = tl::expected<T, std::string>;

} // namespace protocols
