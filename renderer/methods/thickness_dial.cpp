// One list of words for every method that has the dial.
#include "renderer/methods/thickness_dial.h"

namespace renderer::methods {

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

} // namespace renderer::methods
