// The commands of the program, each in a file of its own name; main.cpp adds them one by one.
#pragma once

#include "experiment/commands/command.h"

#include <filesystem>
#include <string>

namespace experiment::commands {

void add_init(CLI::App& program);
void add_check(CLI::App& program);
void add_verify(CLI::App& program);
void add_render(CLI::App& program);
void add_view(CLI::App& program);
void add_session(CLI::App& program);
void add_simulate(CLI::App& program);
void add_export(CLI::App& program);
void add_analyze(CLI::App& program);
void add_anova(CLI::App& program);
void add_report(CLI::App& program);
void add_schedule(CLI::App& program);
void add_thickness(CLI::App& program);
void add_methods(CLI::App& program);
void add_demo(CLI::App& program);

/// Writes a new study of the named template into `path`.  Errors: CommandError when there is a
/// study already.
void make_study_folder(const std::filesystem::path& path, const std::string& template_name);

} // namespace experiment::commands
