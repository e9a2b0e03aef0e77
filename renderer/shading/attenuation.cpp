// Where D_n comes from.
#include "renderer/shading/attenuation.h"

#include <fmt/format.h>

namespace renderer::shading {

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

} // namespace renderer::shading
