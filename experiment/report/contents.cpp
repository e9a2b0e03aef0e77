// Labels in place of names.
#include "experiment/report/contents.h"

namespace experiment::report {

std::string labelled(const std::map<std::string, std::string>& labels, const std::string& name) {
    const auto found = labels.find(name);
    return found == labels.end() || found->second.empty() ? name : found->second;
}

std::string condition_label(const ReportContents& contents, std::size_t condition) {
    return labelled(contents.labels.conditions, contents.findings.design.conditions.at(condition));
}

std::string
level_label(const ReportContents& contents, std::size_t factor, const std::string& level) {
    const auto& name = contents.findings.design.factor_names.at(factor);
    if (name == "scene")
        return labelled(contents.labels.scenes, level);
    if (name == "variant")
        return labelled(contents.labels.variants, level);
    return level;
}

} // namespace experiment::report
