// The law's dial, and where D_n comes from.
#include "renderer/methods/attenuation.h"

#include <fmt/format.h>

namespace renderer::methods {

Dial law_dial() {
    return {.name = "law",
            .meaning = "what is left of the light after a thickness d: 1 - d/D_n, or "
                       "exp(-sigma_tr d) per channel",
            .preset = "physical",
            .names = {"paper", "physical"}};
}

Law law_of(const Dials& dials) {
    return name_in(dials, "law") == "paper" ? Law::Paper : Law::Physical;
}

Expected<Attenuation> attenuation_for(Law law, const thickness::ThicknessField* field) {
    if (law == Law::Physical)
        return Attenuation{};
    if (field == nullptr)
        return tl::make_unexpected("the paper's law divides by D_n, expected a thickness field");
    if (!(field->d_n > 0))
        return tl::make_unexpected(
            fmt::format("the thickness field's D_n is {}, expected > 0", field->d_n));
    return Attenuation{Law::Paper, field->d_n};
}

Expected<std::shared_ptr<const thickness::ThicknessField>> field_with_d_n(Law law,
                                                                          const Subject& subject) {
    if (law == Law::Physical)
        return nullptr;
    return subject.field({});
}

} // namespace renderer::methods
