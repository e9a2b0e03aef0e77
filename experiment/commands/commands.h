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
void add_reference(CLI::App& program);
void add_simplify(CLI::App& program);
void add_compare(CLI::App& program);
void add_methods(CLI::App& program);
void add_fit(CLI::App& program);
void add_cost(CLI::App& program);
void add_demo(CLI::App& program);
void add_register(CLI::App& program);
void add_observers(CLI::App& program);
void add_withdraw(CLI::App& program);
void add_display(CLI::App& program);
void add_timing_check(CLI::App& program);
void add_photometer(CLI::App& program);
void add_pages(CLI::App& program);
void add_import(CLI::App& program);

/// Writes a new study of the named template into `path`, its pages in "en" or "de".  Errors:
/// CommandError when there is a study already.
void make_study_folder(const std::filesystem::path& path,
                       const std::string& template_name,
                       const std::string& language = "en");

} // namespace experiment::commands
