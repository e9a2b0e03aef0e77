// What was not measured reads as NaN, which is on no front and is never chosen.
#include "experiment/cost/cost_report.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace experiment::cost {

std::string_view name_of(ErrorKind kind) {
    switch (kind) {
    case ErrorKind::Thickness:
        return "thickness";
    case ErrorKind::Law:
        return "law";
    case ErrorKind::Reference:
        return "reference";
    case ErrorKind::Fitted:
        return "fitted";
    }
    return "";
}

std::optional<ErrorKind> error_kind(std::string_view name) {
    const auto found = std::ranges::find(all_errors, name, name_of);
    return found == all_errors.end() ? std::nullopt : std::optional(*found);
}

double error_of(const Row& row, std::size_t light, ErrorKind kind) {
    const auto& errors = row.lights.at(light);
    const auto error = kind == ErrorKind::Thickness   ? row.thickness
                       : kind == ErrorKind::Law       ? errors.law
                       : kind == ErrorKind::Reference ? errors.reference
                                                      : errors.fitted;
    return error.value_or(std::numeric_limits<double>::quiet_NaN());
}

std::size_t bytes_in_all(const Row& row) {
    return row.mesh_bytes + row.vertices * row.bytes_per_vertex;
}

std::string full_name(const Row& row) {
    return row.setting.empty() ? row.label : row.label + ", " + row.setting;
}

bool has_error(const SceneCost& scene, std::size_t light, ErrorKind kind) {
    return std::ranges::any_of(
        scene.rows, [&](const Row& row) { return !std::isnan(error_of(row, light, kind)); });
}

} // namespace experiment::cost
