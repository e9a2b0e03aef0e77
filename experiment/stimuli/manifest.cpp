// Optional members are written when they are there; nothing stands for "not measured".
#include "experiment/stimuli/manifest.h"

#include "experiment/json_text.h"
#include "protocols/study.h"

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

ModelRecord model_record(const JsonPlace& json) {
    return {json.at("file").text(), json.at("sha256").text(), json.at("vertices").size(),
            json.at("triangles").size()};
}

BrightnessRecord brightness_record(const JsonPlace& json) {
    return {json.at("mean_before").number(), json.at("target").number(), json.at("gain").number(),
            json.at("clipped_share").number()};
}

std::optional<double> number_if_there(const JsonPlace& json, const char* key) {
    return json.has(key) ? std::optional(json.at(key).number()) : std::nullopt;
}

std::optional<std::string> text_if_there(const JsonPlace& json, const char* key) {
    return json.has(key) ? std::optional(json.at(key).text()) : std::nullopt;
}

PictureRecord picture_record(const JsonPlace& json) {
    PictureRecord record;
    record.recipe = json.at("recipe").text();
    record.renderer = json.at("renderer").text();
    for (const auto& [name, value] : json.at("dials").members())
        record.dials[name] = value.text();
    record.png_sha256 = json.at("png_sha256").text();
    record.width = json.at("width").count();
    record.height = json.at("height").count();
    if (json.has("model"))
        record.model = model_record(json.at("model"));
    if (json.has("brightness"))
        record.brightness = brightness_record(json.at("brightness"));
    record.precompute_seconds = number_if_there(json, "precompute_seconds");
    record.frame_milliseconds = number_if_there(json, "frame_milliseconds");
    if (json.has("bytes_per_vertex"))
        record.bytes_per_vertex = json.at("bytes_per_vertex").size();
    record.decision = text_if_there(json, "decision");
    record.predicted_change = number_if_there(json, "predicted_change");
    record.measured_change = number_if_there(json, "measured_change");
    record.remark = text_if_there(json, "remark");
    return record;
}

Manifest manifest_of(const JsonPlace& json) {
    if (const auto form = json.at("form"); form.count() != form_version)
        form.refuse(fmt::format("{}", form_version));
    Manifest manifest{json.at("program").text(), json.at("study_sha256").text(), {}};
    for (const auto& entry : json.at("pictures").elements()) {
        const protocols::Picture picture{{entry.at("scene").text()},
                                         {entry.at("variant").text()},
                                         {entry.at("condition").text()}};
        if (!manifest.pictures.emplace(picture, picture_record(entry)).second)
            entry.complain(fmt::format("the picture {} is there twice, expected it once",
                                       protocols::picture_path(picture)));
    }
    return manifest;
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
    return read_json_as(text, file_name,
                        "expected the manifest as it was written; take the file away and run "
                        "`pairlight render` again",
                        manifest_of);
}

} // namespace experiment::stimuli
