// What a study says of itself.
#include "protocols/study.h"

namespace protocols {

std::vector<Variant> shown_variants(const Study& study) {
    return study.variants.empty() ? std::vector<Variant>{Variant{}} : study.variants;
}

std::string picture_path(const Picture& picture) {
    const auto folder = picture.variant.value.empty()
                            ? picture.scene.value
                            : picture.scene.value + "/" + picture.variant.value;
    return folder + "/" + picture.condition.value;
}

} // namespace protocols
