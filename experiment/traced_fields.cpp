// Tracing happens when a field is asked for, not before.
#include "experiment/traced_fields.h"

#include "renderer/thickness/bands.h"

#include <fmt/core.h>

#include <filesystem>
#include <utility>

namespace experiment {

namespace thickness = renderer::thickness;
using thickness::FieldOrigin;

namespace {

constexpr double least_energy = 0.6; // a shell of 1 % of its radius keeps 0.57

/// The model outlives whoever borrows its mesh.
std::shared_ptr<const renderer::geometry::Mesh> borrowed(const LoadedModel& model) {
    return {std::shared_ptr<const void>(), &model.mesh};
}

/// Bodies have no file and are quickly traced again.
std::filesystem::path cache_folder(const LoadedModel& model, FieldsKept kept) {
    return model.file.empty() || kept == FieldsKept::Nowhere
               ? std::filesystem::path()
               : model.file.parent_path() / "thickness";
}

} // namespace

TracedFields::TracedFields(LoadedModel& model, thickness::Progress progress, FieldsKept kept)
    : model_(model), progress_(std::move(progress)),
      source_(borrowed(model), cache_folder(model, kept)) {}

tl::expected<TracedFields::Field, std::string>
TracedFields::field(const thickness::FieldOptions& asked) {
    auto sourced = source_.field(asked, progress_);
    if (!sourced)
        return tl::unexpected(sourced.error());
    remark(*sourced);
    if (sourced->origin == FieldOrigin::Traced) {
        traced_[sourced->field] = sourced->seconds;
        seconds_spent_ += sourced->seconds;
    }
    if (const auto found = traced_.find(sourced->field); found == traced_.end())
        seconds_owed_.reset();
    else if (seconds_owed_)
        *seconds_owed_ += found->second;
    return sourced->field;
}

std::optional<double> TracedFields::seconds_alone(double elapsed) {
    const double spent = std::exchange(seconds_spent_, 0);
    const auto owed = std::exchange(seconds_owed_, 0);
    return owed ? std::optional(elapsed - spent + *owed) : std::nullopt;
}

void TracedFields::remark(const thickness::SourcedField& sourced) {
    model_.remarks.insert(model_.remarks.end(), sourced.remarks.begin(), sourced.remarks.end());
    if (sourced.origin == FieldOrigin::Memory)
        return; // has been said
    if (sourced.origin == FieldOrigin::File)
        model_.remarks.push_back("thickness " + describe(sourced));
    if (const double kept = thickness::energy_kept(*sourced.field, sourced.field->bands);
        kept < least_energy)
        model_.remarks.push_back(
            fmt::format("{} bands hold {:.0f} % of the thickness's energy: the walls are thin, and "
                        "most of what glows is invented",
                        sourced.field->bands, 100 * kept));
    const auto& rays = sourced.field->statistics;
    if (rays.retried + rays.fallbacks > 0)
        model_.remarks.push_back(
            fmt::format("{} of {} rays were traced again, {} decided by winding number",
                        rays.retried, rays.rays, rays.fallbacks));
    if (rays.past_openings > 0)
        model_.remarks.push_back(fmt::format(
            "{} of {} rays passed so near an opening that the winding number decided where the "
            "inside ends",
            rays.past_openings, rays.rays));
}

} // namespace experiment
