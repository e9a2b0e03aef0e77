// Thickness fields of one model, handed out to every method that is made for it, and what tracing
// them took.
#pragma once

#include "experiment/models.h"
#include "renderer/thickness/field_source.h"
#include "renderer/thickness/thickness_field.h"

#include <tl/expected.hpp>

#include <map>
#include <memory>
#include <optional>
#include <string>

namespace experiment {

/// Where traced fields are kept for the next program: in <model's folder>/thickness, or nowhere, so
/// that what tracing takes is always measured.
enum class FieldsKept { BesideTheModel, Nowhere };

/// Traces once for every kind and number of directions, and keeps what was traced.  The model
/// outlives it and gets its remarks.
class TracedFields {
  public:
    using Field = std::shared_ptr<const renderer::thickness::ThicknessField>;

    TracedFields(LoadedModel& model,
                 renderer::thickness::Progress progress,
                 FieldsKept kept = FieldsKept::BesideTheModel);

    /// Errors: what the tracing refuses.
    tl::expected<Field, std::string> field(const renderer::thickness::FieldOptions& asked);

    /// How long whoever asked since the last call would have taken alone, had it had to trace all
    /// it asked for; `elapsed` seconds it did take.  Nothing when a field came from a file: what
    /// tracing it took is not known then.
    std::optional<double> seconds_alone(double elapsed);

  private:
    void remark(const renderer::thickness::SourcedField& sourced);

    LoadedModel& model_;
    renderer::thickness::Progress progress_;
    renderer::thickness::FieldSource source_;
    std::map<Field, double> traced_; ///< seconds; fields from files are not in it
    double seconds_spent_ = 0;
    std::optional<double> seconds_owed_ = 0;
};

} // namespace experiment
