// What the pictures of a sureal data set are called: the form itself knows numbers only.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace analysis::formats {

struct NamedAsset {
    std::int64_t id = 0, content = 0;
    std::string content_name;
    std::string condition; ///< where its entry says so itself, "" where not
    std::string path;      ///< of its file, "" without one
};

struct ConditionNames {
    std::vector<std::string> names; ///< one per asset
    std::string note;               ///< where they come from
};

/// By what the entries say themselves; else by files' names without their ending and without the
/// content's name in front; each where all have one, and unique within every content.  Else by
/// numbers.
ConditionNames condition_names(std::span<const NamedAsset> assets);

} // namespace analysis::formats
