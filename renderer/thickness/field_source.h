// Thickness fields of one mesh from where they are quickest to have: memory, a file, or the rays.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/thickness/thickness_field.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

namespace renderer::thickness {

enum class FieldOrigin { Memory, File, Traced };

struct SourcedField {
    std::shared_ptr<const ThicknessField> field;
    FieldOrigin origin = FieldOrigin::Traced;
    double seconds = 0; ///< how long the caller waited
    std::vector<std::string>
        remarks; ///< files that were damaged or could not be written, for people
};

/// Remembers every field it was asked for.  One thread at a time; the fields may be shared.
class FieldSource {
  public:
    /// `folder` is where files are kept; empty for none.  It is made when something is written.
    FieldSource(std::shared_ptr<const geometry::Mesh> mesh, std::filesystem::path folder);

    /// A field for these options, with at least the bands asked for: tracing costs the same for any
    /// number, so five are computed where fewer are wanted, and serve whatever comes later.
    /// Errors: those of compute_thickness_field; a cache that fails is a remark, and the mesh is
    /// traced.
    Expected<SourcedField> field(const FieldOptions& options,
                                 const Progress& progress = {},
                                 const std::stop_token& stop = {});

    /// Where a field of these options is kept; its name has all of them but the bands.
    std::filesystem::path file(const FieldOptions& options) const;

  private:
    std::shared_ptr<const ThicknessField> remembered(const FieldOptions& options) const;
    std::shared_ptr<const ThicknessField> read(const FieldOptions& options,
                                               std::vector<std::string>& remarks) const;
    void write(const ThicknessField& field, std::vector<std::string>& remarks) const;

    std::shared_ptr<const geometry::Mesh> mesh_;
    std::filesystem::path folder_;
    std::uint64_t hash_;
    std::vector<std::shared_ptr<const ThicknessField>> fields_;
};

/// "from memory", "from its file in 0.02 s", "traced in 31.5 s".
std::string describe(const SourcedField& sourced);

} // namespace renderer::thickness
