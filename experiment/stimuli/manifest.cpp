// Optional members are written when they are there; nothing stands for "not measured".
#include "experiment/stimuli/manifest.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

namespace experiment::stimuli {

namespace {

using Json = nlohmann::ordered_json;

constexpr int form_version = 1;

Json to_json(const ModelRecord& model) {
    return {{"file", model.file},
            {"sha256", model.sha256},
            {"vertices", model.vertices},
            {"triangles", model.triangles}};
}

Json to_json(const BrightnessRecord& brightness) {
    return {{"mean_before", brightness.mean_before},
            {"target", brightness.target},
            {"gain", brightness.gain},
            {"clipped_share", brightness.clipped_share}};
}

template <class T>
void add(Json& json, const char* key, const std::optional<T>& value) {
    if (!value)
        return;
    if constexpr (requires { to_json(*value); })
        json[key] = to_json(*value);
    else
        json[key] = *value;
}

Json to_json(const protocols::Picture& picture, const PictureRecord& record) {
    Json json{{"scene", picture.scene.value},
              {"variant", picture.variant.value},
              {"condition", picture.condition.value},
              {"recipe", record.recipe},
              {"renderer", record.renderer},
              {"dials", record.dials},
              {"png_sha256", record.png_sha256},
              {"width", record.width},
              {"height", record.height}};
    add(json, "model", record.model);
    add(json, "brightness", record.brightness);
    add(json, "precompute_seconds", record.precompute_seconds);
    add(json, "frame_milliseconds", record.frame_milliseconds);
    add(json, "bytes_per_vertex", record.bytes_per_vertex);
    add(json, "decision", record.decision);
    add(json, "predicted_change", record.predicted_change);
    add(json, "measured_change", record.measured_change);
    add(json, "remark", record.remark);
    return json;
}

ModelRecord model_record(const Json& json) {
    return {json.at("file"), json.at("sha256"), json.at("vertices"), json.at("triangles")};
}

BrightnessRecord brightness_record(const Json& json) {
    return {json.at("mean_before"), json.at("target"), json.at("gain"), json.at("clipped_share")};
}

template <class T>
std::optional<T> optional_value(const Json& json, const char* key) {
    return json.contains(key) ? std::optional<T>(json.at(key).get<T>()) : std::nullopt;
}

PictureRecord picture_record(const Json& json) {
    PictureRecord record;
    record.recipe = json.at("recipe");
    record.renderer = json.at("renderer");
    record.dials = json.at("dials");
    record.png_sha256 = json.at("png_sha256");
    record.width = json.at("width");
    record.height = json.at("height");
    if (json.contains("model"))
        record.model = model_record(json.at("model"));
    if (json.contains("brightness"))
        record.brightness = brightness_record(json.at("brightness"));
    record.precompute_seconds = optional_value<double>(json, "precompute_seconds");
    record.frame_milliseconds = optional_value<double>(json, "frame_milliseconds");
    record.bytes_per_vertex = optional_value<std::size_t>(json, "bytes_per_vertex");
    record.decision = optional_value<std::string>(json, "decision");
    record.predicted_change = optional_value<double>(json, "predicted_change");
    record.measured_change = optional_value<double>(json, "measured_change");
    record.remark = optional_value<std::string>(json, "remark");
    return record;
}

} // namespace

std::string manifest_json(const Manifest& manifest) {
    Json json{{"form", form_version},
              {"program", manifest.program},
              {"study_sha256", manifest.study_sha256},
              {"pictures", Json::array()}};
    for (const auto& [picture, record] : manifest.pictures)
        json["pictures"].push_back(to_json(picture, record));
    return json.dump(2) + "\n";
}

tl::expected<Manifest, std::string> parse_manifest(std::string_view text,
                                                   std::string_view file_name) {
    try {
        const auto json = Json::parse(text);
        if (const int form = json.at("form"); form != form_version)
            return tl::unexpected(fmt::format("{}: form {}, expected {}; render the study again",
                                              file_name, form, form_version));
        Manifest manifest{json.at("program"), json.at("study_sha256"), {}};
        for (const auto& entry : json.at("pictures"))
            manifest
                .pictures[{{entry.at("scene")}, {entry.at("variant")}, {entry.at("condition")}}] =
                picture_record(entry);
        return manifest;
    } catch (const Json::exception& error) {
        return tl::unexpected(
            fmt::format("{}: not a stimuli manifest: {}", file_name, error.what()));
    }
}

} // namespace experiment::stimuli
