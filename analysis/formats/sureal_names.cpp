#include "analysis/formats/sureal_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

namespace analysis::formats {

namespace {

// "caps/Caps1.png": Caps1
std::string stem_of(const std::string& path) {
    const auto slash = path.find_last_of("/\\");
    const auto file = slash == path.npos ? path : path.substr(slash + 1);
    const auto dot = file.rfind('.');
    return dot == path.npos || dot == 0 ? file : file.substr(0, dot);
}

// Without the content's name where all have it in front, but for at least one sign.
std::vector<std::string> stems_of(std::span<const NamedAsset> assets) {
    std::vector<std::string> stems;
    bool in_front = true;
    for (const auto& asset : assets) {
        const auto& stem = stems.emplace_back(stem_of(asset.path));
        in_front = in_front && stem.size() > asset.content_name.size() &&
                   stem.starts_with(asset.content_name);
    }
    for (std::size_t a = 0; in_front && a < stems.size(); ++a)
        stems[a].erase(0, std::min(stems[a].find_first_not_of(" _-", assets[a].content_name.size()),
                                   stems[a].size() - 1));
    return stems;
}

bool tell_apart(std::span<const NamedAsset> assets, const std::vector<std::string>& names) {
    std::set<std::pair<std::int64_t, std::string_view>> seen;
    for (std::size_t a = 0; a < assets.size(); ++a)
        if (names[a].empty() || !seen.emplace(assets[a].content, names[a]).second)
            return false;
    return true;
}

} // namespace

ConditionNames condition_names(std::span<const NamedAsset> assets) {
    std::vector<std::string> own, numbers;
    for (const auto& asset : assets) {
        own.push_back(asset.condition);
        numbers.push_back(fmt::format("{}", asset.id));
    }
    if (tell_apart(assets, own))
        return {std::move(own), "conditions are called as their entries say"};
    if (auto stems = stems_of(assets); tell_apart(assets, stems))
        return {std::move(stems), "conditions are called by their files' names"};
    return {std::move(numbers), "conditions are called by their assets' numbers"};
}

} // namespace analysis::formats
