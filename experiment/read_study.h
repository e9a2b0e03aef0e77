// A study file from disk, with the names the program knows, and where its models may lie.
#pragma once

#include "experiment/study_folder.h"
#include "protocols/study.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace experiment {

struct LoadedStudy {
    StudyFolder folder;
    protocols::Study study;
    std::string sha256; ///< of the study file's bytes, hexadecimal
};

/// What a study file may name: the renderer's methods with their dials, and its materials.
protocols::KnownNames known_names();

/// Reads the study a person means by `path` (a folder or its study.toml).
/// Errors: one line with file, line and remedy.
tl::expected<LoadedStudy, std::string> read_study(const std::filesystem::path& path);

/// Its own files, whether they are there or not: the study file, and what is read because of it.
std::vector<std::filesystem::path> files_of(const LoadedStudy& loaded);

/// The instructions' text.  Errors: the file is missing, empty or not UTF-8.
tl::expected<std::string, std::string> read_instructions(const LoadedStudy& loaded);

/// Folders in which a model's name is looked up, in order: the study's own models/, then
/// PAIRLIGHT_MODELS (separated by colons), else the cache that tools/fetch-models fills.
std::vector<std::filesystem::path> model_folders(const StudyFolder& folder);

} // namespace experiment
