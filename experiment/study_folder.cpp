// From what a person types to the folder that is meant.
#include "experiment/study_folder.h"

namespace experiment {

StudyFolder study_folder(const std::filesystem::path& path) {
    if (path.filename() == "study.toml")
        return {path.has_parent_path() ? path.parent_path() : std::filesystem::path(".")};
    return {path};
}

} // namespace experiment
