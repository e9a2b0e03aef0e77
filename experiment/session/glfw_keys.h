// Keys by name, as GLFW numbers them.
#pragma once

#include "experiment/session/inputs.h"
#include "protocols/key_map.h"

#include <map>

namespace experiment::session {

/// What each of GLFW's key codes means here.  EXPECTS names out of protocols::key_names().
std::map<int, Key> glfw_keys(const protocols::KeyMap& keys);

} // namespace experiment::session
