// The commands of the program, each in a file of its own name; main.cpp adds them one by one.
#pragma once

#include "experiment/commands/command.h"

#include <filesystem>
#include <string>

namespace experiment::commands {

void add_init(Command& program);
void add_check(Command& program);
void add_verify(Command& program);
void add_render(Command& program);
void add_view(Command& program);
void add_session(Command& program);
void add_simulate(Command& program);
void add_export(Command& program);
void add_analyze(Command& program);
void add_anova(Command& program);
void add_report(Command& program);
void add_schedule(Command& program);
void add_thickness(Command& program);
void add_reference(Command& program);
void add_simplify(Command& program);
void add_compare(Command& program);
void add_methods(Command& program);
void add_fit(Command& program);
void add_cost(Command& program);
void add_demo(Command& program);
void add_register(Command& program);
void add_observers(Command& program);
void add_withdraw(Command& program);
void add_display(Command& program);
void add_timing_check(Command& program);
void add_photometer(Command& program);
void add_pages(Command& program);
void add_import(Command& program);

/// Writes a new study of the named template into `path`, its pages in "en" or "de".  Errors:
/// CommandError when there is a study already.
void make_study_folder(const std::filesystem::path& path,
                       const std::string& template_name,
                       const std::string& language = "en");

} // namespace experiment::commands
