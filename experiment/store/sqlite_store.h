// The vote store in one SQLite file.
#pragma once

#include "experiment/store/vote_store.h"

#include <filesystem>
#include <memory>

namespace experiment::store {

/// Opens the votes of a study that has some.
/// Errors: no such file; not a vote store; another schema version; damaged.
Expected<std::unique_ptr<VoteStore>> open_votes(const std::filesystem::path& file);

/// Opens the votes of `study` to add some, making the file when it is not there.
/// Errors: also an empty file, a file or folder that cannot be written, another program that is
/// writing, and a store made for another study (another id; a new digest under the same id is
/// welcome, every sitting keeps its own).
Expected<std::unique_ptr<VoteStore>> open_or_create_votes(const std::filesystem::path& file,
                                                          const StudyIdentity& study);

} // namespace experiment::store
