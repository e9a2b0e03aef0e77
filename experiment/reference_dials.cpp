// What a study may say of its reference.
#include "experiment/reference_dials.h"

#include "renderer/reference/boundary.h"

#include <chrono>
#include <limits>

namespace experiment {

namespace methods = renderer::methods;
namespace reference = renderer::reference;

const std::vector<methods::Dial>& reference_dials() {
    static const std::vector<methods::Dial> dials{
        {.name = "relative_error",
         .meaning = "95 % half-width over its light at which a pixel is good enough",
         .preset = 0.005,
         .number = methods::DialRange<double>{1e-4, 1}},
        {.name = "seconds",
         .meaning = "at most so long for each picture; 0: as long as it takes",
         .preset = 0.0,
         .number = methods::DialRange<double>{0, 1e6}},
        // a polished surface cannot be lit by a study's lights, which are directions and points
        {.name = "boundary",
         .meaning = "what the surface does to light",
         .preset = std::string("matched"),
         .names = {"matched", "rough"}},
        {.name = "roughness",
         .meaning = "GGX alpha of a rough boundary",
         .preset = 0.3,
         .number = methods::DialRange<double>{0.1, 1}},
        {.name = "anisotropy",
         .meaning = "Henyey-Greenstein's g, at one reduced scattering",
         .preset = 0.0,
         .number = methods::DialRange<double>{-0.999, 0.999}},
        {.name = "seed",
         .meaning = "of the random numbers",
         .preset = std::int64_t{1},
         .whole = methods::DialRange<std::int64_t>{0, std::numeric_limits<std::int64_t>::max()}}};
    return dials;
}

reference::ReferenceRun reference_run(const protocols::Dials& dials) {
    reference::ReferenceRun run;
    run.settings.boundary = {*reference::boundary_kind(methods::name_in(dials, "boundary")),
                             methods::number_in(dials, "roughness")};
    run.settings.anisotropy = methods::number_in(dials, "anisotropy");
    run.rule.relative = methods::number_in(dials, "relative_error");
    if (const double seconds = methods::number_in(dials, "seconds"); seconds > 0)
        run.rule.time_budget = std::chrono::duration<double>(seconds);
    run.seed = static_cast<std::uint64_t>(methods::whole_in(dials, "seed"));
    return run;
}

} // namespace experiment
