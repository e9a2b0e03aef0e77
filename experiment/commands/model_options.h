// Options of the commands that take a model.
#pragma once

#include "renderer/geometry/mesh_repair.h"

#include <array>

namespace experiment::commands {

class Command;

/// Errors: CommandError when the three numbers that `option` was given, or has, are all 0.
void expect_direction(const char* option, const std::array<double, 3>& v);

/// Adds `--holes refuse|winding` to `command`.
void add_holes(Command& command, renderer::geometry::Holes& holes);

} // namespace experiment::commands
