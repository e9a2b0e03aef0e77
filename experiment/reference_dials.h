// The reference as a condition of a study: its name, its dials, and the run they ask for.
//
// It is drawn by following light, not by OpenGL, so it stands beside the catalogue of methods.
#pragma once

#include "protocols/study.h"
#include "renderer/methods/dials.h"
#include "renderer/reference/reference_picture.h"

#include <string_view>
#include <vector>

namespace experiment {

inline constexpr std::string_view reference_method = "reference";

const std::vector<renderer::methods::Dial>& reference_dials();

/// EXPECTS all dials to be there, as `reference_dials` completes them.
renderer::reference::ReferenceRun reference_run(const protocols::Dials& complete_dials);

} // namespace experiment
