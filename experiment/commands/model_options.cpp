// What is asked of a model is asked in the same words by every command.
#include "experiment/commands/model_options.h"

#include "experiment/commands/command.h"
#include "experiment/commands/command_line.h"
#include "renderer/materials.h"

#include <fmt/format.h>

#include <cmath>

namespace experiment::commands {

using renderer::geometry::Holes;

void expect_direction(const char* option, const std::array<double, 3>& v) {
    if (!(std::hypot(v[0], v[1], v[2]) > 0))
        throw CommandError(fmt::format("{} {} {} {}: expected a direction, not all zero", option,
                                       v[0], v[1], v[2]));
}

void add_look(Command& command, protocols::Scene& look) {
    command.add_option("--material", look.material, "Of a model: a measured material")
        .one_of(renderer::measured_names())
        .shows_default();
    command.add_option("--diameter-mm", look.diameter_mm, "Of a model's bounding sphere")
        .within(1e-6, 1e6)
        .shows_default();
    command.add_option("--turn-degrees", look.turn_degrees, "Of a model").within(-360, 360);
    command.add_option("--up", look.up, "Of a model").within(-1e9, 1e9);
}

void add_holes(Command& command, Holes& holes) {
    command.add_choice("--holes", holes,
                       "What to do with a model's surface that is not closed: refuse it, or take "
                       "for inside where it winds more than half around",
                       {{"refuse", Holes::Refuse}, {"winding", Holes::ByWinding}});
}

} // namespace experiment::commands
