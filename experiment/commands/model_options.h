// Options of the commands that take a model.
#pragma once

#include "protocols/study.h"
#include "renderer/geometry/mesh_repair.h"

#include <array>

namespace experiment::commands {

class Command;

/// Errors: CommandError when the three numbers that `option` was given, or has, are all 0.
void expect_direction(const char* option, const std::array<double, 3>& v);

/// Adds `--material`, `--diameter-mm`, `--turn-degrees` and `--up` to `command`: how a model
/// without a study is shown.
void add_look(Command& command, protocols::Scene& look);

/// Adds `--holes refuse|winding` to `command`.
void add_holes(Command& command, renderer::geometry::Holes& holes);

} // namespace experiment::commands
