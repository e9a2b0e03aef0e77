// Tracing happens when a field is asked for, not before.
#include "experiment/traced_fields.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace experiment {

namespace thickness = renderer::thickness;
using Clock = std::chrono::steady_clock;

tl::expected<TracedFields::Field, std::string>
TracedFields::field(const thickness::FieldOptions& asked) {
    auto options = asked;
    options.bands = std::max(options.bands, thickness::FieldOptions{}.bands);
    auto& traced = fields_[{options.kind, options.directions, options.bands}];
    if (traced.field == nullptr) {
        const auto start = Clock::now();
        auto field = thickness::compute_thickness_field(model_.mesh, options, progress_);
        if (!field)
            return tl::unexpected(field.error());
        remark(field->statistics);
        traced.field = std::make_shared<const thickness::ThicknessField>(std::move(*field));
        traced.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        seconds_spent_ += traced.seconds;
    }
    seconds_owed_ += traced.seconds;
    return traced.field;
}

double TracedFields::take_seconds_saved() {
    return std::exchange(seconds_owed_, 0) - std::exchange(seconds_spent_, 0);
}

void TracedFields::remark(const renderer::geometry::RayStatistics& rays) {
    if (rays.retried + rays.fallbacks > 0)
        model_.remarks.push_back(
            fmt::format("{} of {} rays were traced again, {} decided by winding number",
                        rays.retried, rays.rays, rays.fallbacks));
}

} // namespace experiment
