// What a study says of itself.
#include "protocols/study.h"

#include <algorithm>

namespace protocols {

const OwnMaterial* own_material(const Study& study, std::string_view name) {
    const auto found = std::find_if(study.materials.begin(), study.materials.end(),
                                    [&](const OwnMaterial& each) { return each.id.value == name; });
    return found != study.materials.end() ? &*found : nullptr;
}

std::vector<Variant> shown_variants(const Study& study) {
    return study.variants.empty() ? std::vector<Variant>{Variant{}} : study.variants;
}

std::map<SceneId, PictureSize> picture_sizes(const Study& study) {
    std::map<SceneId, PictureSize> sizes;
    for (const auto& scene : study.scenes)
        sizes[scene.id] = scene.size.value_or(PictureSize{study.width, study.height});
    return sizes;
}

std::string picture_path(const Picture& picture) {
    const auto folder = picture.variant.value.empty()
                            ? picture.scene.value
                            : picture.scene.value + "/" + picture.variant.value;
    return folder + "/" + picture.condition.value;
}

} // namespace protocols
