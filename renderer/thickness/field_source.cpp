// Memory first, then the file, then the rays.
#include "renderer/thickness/field_source.h"

#include "renderer/contract.h"
#include "renderer/stopwatch.h"
#include "renderer/thickness/cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

namespace renderer::thickness {

namespace fs = std::filesystem;

namespace {

constexpr int usual_bands = 5;

std::string_view name_of(Kind kind) {
    switch (kind) {
    case Kind::Sum:
        return "sum";
    case Kind::First:
        return "first";
    case Kind::Span:
        return "span";
    }
    return "";
}

/// As many bands as are usual, if the directions carry them: two for each coefficient.
FieldOptions generous(FieldOptions options) {
    if (options.bands < usual_bands && options.directions >= 2 * usual_bands * usual_bands)
        options.bands = usual_bands;
    return options;
}

} // namespace

FieldSource::FieldSource(std::shared_ptr<const geometry::Mesh> mesh, fs::path folder)
    : mesh_(std::move(mesh)), folder_(std::move(folder)) {
    EXPECTS(mesh_ != nullptr);
    hash_ = mesh_hash(*mesh_);
}

fs::path FieldSource::file(const FieldOptions& options) const {
    return folder_ / fmt::format("{:016x}-{}-{}-{}.thickness", hash_, name_of(options.kind),
                                 options.directions, options.rotation_seed);
}

Expected<SourcedField> FieldSource::field(const FieldOptions& options,
                                          const Progress& progress,
                                          const std::stop_token& stop) {
    const Stopwatch watch;
    SourcedField sourced;
    if ((sourced.field = remembered(options))) {
        sourced.origin = FieldOrigin::Memory;
    } else if ((sourced.field = read(options, sourced.remarks))) {
        sourced.origin = FieldOrigin::File;
        fields_.push_back(sourced.field);
    } else {
        auto traced = compute_thickness_field(*mesh_, generous(options), progress, stop);
        if (!traced)
            return tl::unexpected(traced.error());
        sourced.field = std::make_shared<const ThicknessField>(std::move(*traced));
        fields_.push_back(sourced.field);
        write(*sourced.field, sourced.remarks);
    }
    sourced.seconds = watch.seconds();
    return sourced;
}

std::shared_ptr<const ThicknessField> FieldSource::remembered(const FieldOptions& options) const {
    const auto found = std::find_if(fields_.begin(), fields_.end(), [&](const auto& field) {
        return serves(field->options, options);
    });
    return found != fields_.end() ? *found : nullptr;
}

std::shared_ptr<const ThicknessField> FieldSource::read(const FieldOptions& options,
                                                        std::vector<std::string>& remarks) const {
    if (folder_.empty())
        return nullptr;
    auto found = read_field(file(options), hash_, options);
    if (!found) {
        remarks.push_back(found.error() + "; traced again");
        return nullptr;
    }
    return *found ? std::make_shared<const ThicknessField>(std::move(**found)) : nullptr;
}

void FieldSource::write(const ThicknessField& field, std::vector<std::string>& remarks) const {
    if (folder_.empty())
        return;
    std::error_code ignored; // what matters is whether the file can be written
    fs::create_directories(folder_, ignored);
    if (const auto written = write_field(file(field.options), hash_, field); !written)
        remarks.push_back(written.error());
}

std::string describe(const SourcedField& sourced) {
    switch (sourced.origin) {
    case FieldOrigin::Memory:
        return "from memory";
    case FieldOrigin::File:
        return fmt::format("from its file in {:.2g} s", sourced.seconds);
    case FieldOrigin::Traced:
        return fmt::format("traced in {:.3g} s", sourced.seconds);
    }
    return "";
}

} // namespace renderer::thickness
