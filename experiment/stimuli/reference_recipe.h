// Which picture a reference is of, in words, and the film it goes on from.
#pragma once

#include "experiment/stimuli/manifest.h"
#include "protocols/study.h"
#include "renderer/reference/film.h"
#include "renderer/reference/path_tracer.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <filesystem>
#include <string>

namespace experiment::stimuli {

/// Equal for equal pictures, so that a file is only gone on with when it is of the same one.
std::string reference_recipe(const protocols::Study& study,
                             const protocols::Scene& scene,
                             const protocols::Variant& variant,
                             const ModelRecord& model,
                             const renderer::reference::ReferenceSettings& settings);

/// The film that the file holds, or a blank one of the study's size where there is no file.
/// Errors: a file that is no reference, or one of another picture or seed.
tl::expected<renderer::reference::Film, std::string>
film_to_go_on_with(const std::filesystem::path& file,
                   const std::string& recipe,
                   const protocols::Study& study,
                   std::uint64_t seed);

} // namespace experiment::stimuli
