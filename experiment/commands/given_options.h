// Options that would change nothing are refused: who gave them expects that they do.
#pragma once

#include "renderer/geometry/mesh_repair.h"

#include <array>
#include <initializer_list>
#include <string>

namespace CLI {
class App;
}

namespace experiment::commands {

bool was_given(const CLI::App& command, const char* option);

/// Errors: CommandError "--material: <why>" for the first of the options that was given.
void expect_not_given(const CLI::App& command,
                      std::initializer_list<const char*> options,
                      const std::string& why);

/// Errors: CommandError when the three numbers that `option` was given, or has, are all 0.
void expect_direction(const char* option, const std::array<double, 3>& v);

/// Adds `--holes refuse|winding` to `command`.
void add_holes(CLI::App& command, renderer::geometry::Holes& holes);

} // namespace experiment::commands
