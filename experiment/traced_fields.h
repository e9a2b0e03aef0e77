// Thickness fields of one mesh, handed out to every method that is made for it.
#pragma once

#include "experiment/models.h"
#include "renderer/thickness/thickness_field.h"

#include <tl/expected.hpp>

#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace experiment {

/// Thickness of one mesh, traced once for every kind and number of directions, with as many bands
/// as the study's methods usually ask for.  The model outlives it and gets its remarks.
class TracedFields {
  public:
    using Field = std::shared_ptr<const renderer::thickness::ThicknessField>;

    TracedFields(LoadedModel& model, renderer::thickness::Progress progress)
        : model_(model), progress_(std::move(progress)) {}

    /// Errors: what the tracing refuses.
    tl::expected<Field, std::string> field(const renderer::thickness::FieldOptions& asked);

    /// What tracing would add to the time that whoever asked since the last call has taken, had
    /// nobody else asked for the same before.
    double take_seconds_saved();

  private:
    struct Traced {
        double seconds = 0;
        Field field;
    };

    void remark(const renderer::geometry::RayStatistics& rays);

    LoadedModel& model_;
    renderer::thickness::Progress progress_;
    std::map<std::tuple<renderer::thickness::Kind, int, int>, Traced> fields_;
    double seconds_spent_ = 0;
    double seconds_owed_ = 0;
};

} // namespace experiment
