// From what a person types to the folder that is meant.
#include "experiment/study_folder.h"

#include <system_error>

namespace experiment {

StudyFolder study_folder(const std::filesystem::path& path) {
    if (path.filename() == "study.toml")
        return {path.has_parent_path() ? path.parent_path() : std::filesystem::path(".")};
    return {path};
}

bool is_study(const std::filesystem::path& path) {
    std::error_code ignored; // what cannot be looked at is refused as a model, by name
    return path.extension() == ".toml" || std::filesystem::exists(path / "study.toml", ignored);
}

} // namespace experiment
