// A study on disk: where everything of it lies.
#pragma once

#include <filesystem>

namespace experiment {

/// The folder of a study; `root` holds study.toml.
struct StudyFolder {
    std::filesystem::path root;

    std::filesystem::path study_file() const { return root / "study.toml"; }

    std::filesystem::path stimuli() const { return root / "stimuli"; }

    std::filesystem::path manifest() const { return stimuli() / "manifest.json"; }

    std::filesystem::path votes() const { return root / "votes.sqlite"; }

    std::filesystem::path report() const { return root / "report"; }

    std::filesystem::path cost() const { return root / "cost"; }
};

/// The study folder a person means by `path`: the folder itself, or the study.toml in it.
StudyFolder study_folder(const std::filesystem::path& path);

/// Whether a person means a study by `path`, and not a model: a .toml file, or a folder with a
/// study.toml in it.
bool is_study(const std::filesystem::path& path);

} // namespace experiment
