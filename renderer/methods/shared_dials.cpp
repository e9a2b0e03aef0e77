// One list of words for every method that has the dial.
#include "renderer/methods/shared_dials.h"

namespace renderer::methods {

Dial law_dial() {
    return {.name = "law",
            .meaning = "what is left of the light after a thickness d: 1 - d/D_n, or "
                       "exp(-sigma_tr d) per channel",
            .preset = "physical",
            .names = {"paper", "physical"}};
}

shading::Law law_of(const Dials& dials) {
    return name_in(dials, "law") == "paper" ? shading::Law::Paper : shading::Law::Physical;
}

Expected<std::shared_ptr<const thickness::ThicknessField>> field_with_d_n(shading::Law law,
                                                                          const Subject& subject) {
    if (law == shading::Law::Physical)
        return nullptr;
    return subject.field({});
}

Dial thickness_dial() {
    return {.name = "thickness",
            .meaning = "which length counts: all interior segments, the one that starts at the "
                       "vertex, or the way to the last exit",
            .preset = "sum",
            .names = {"sum", "first", "span"}};
}

thickness::Kind thickness_kind(const Dials& dials) {
    const auto name = name_in(dials, "thickness");
    if (name == "first")
        return thickness::Kind::First;
    return name == "span" ? thickness::Kind::Span : thickness::Kind::Sum;
}

Dial depth_map_dial() {
    return {.name = "depth_map",
            .meaning = "texels along an edge of the light's depth map",
            .preset = std::int64_t{2048},
            .whole = DialRange<std::int64_t>{16, 16384}};
}

} // namespace renderer::methods
