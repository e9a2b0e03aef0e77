// Which keys belong together; what they mean to light is the renderer's business.
#include "protocols/material_section.h"

#include <fmt/format.h>

#include <algorithm>

namespace protocols {

namespace {

/// Per millimetre: from none at all to opaque at any size.
constexpr Range<double> coefficients{0, 1e6};

/// sigma_s' as it stands there, or (1 - g) sigma_s.
std::array<double, 3> read_reduced_scattering(Section& section) {
    const bool has_g = section.has("g");
    if (!section.has("sigma_s")) {
        if (has_g)
            section.note("g", "'g' without 'sigma_s', expected both, or 'sigma_s_reduced' alone, "
                              "which is (1 - g) sigma_s");
        return section.rgb("sigma_s_reduced", coefficients);
    }
    if (section.has("sigma_s_reduced"))
        section.note("sigma_s_reduced",
                     "a material with both 'sigma_s' and 'sigma_s_reduced', expected one");
    if (!has_g)
        section.note("sigma_s", "'sigma_s' without 'g', expected the mean cosine of scattering "
                                "beside it, or 'sigma_s_reduced', which is (1 - g) sigma_s");
    double g = 0;
    section.number("g", {-0.999, 0.999}, g);
    auto reduced = section.rgb("sigma_s", coefficients);
    for (auto& channel : reduced)
        channel *= 1 - g;
    return reduced;
}

Coefficients read_coefficients(Section& section) {
    if (section.has("mean_free_path_mm"))
        section.note("mean_free_path_mm", "'mean_free_path_mm' without 'colour', expected it only "
                                          "there: coefficients say how far light spreads");
    Coefficients medium;
    medium.sigma_a = section.rgb("sigma_a", coefficients);
    medium.sigma_s_reduced = read_reduced_scattering(section);
    section.number("index", {1, 4}, medium.index);
    for (std::size_t c = 0; c < 3; ++c)
        if (medium.sigma_a[c] + medium.sigma_s_reduced[c] == 0)
            section.note("sigma_a", "neither absorption nor scattering in a colour channel, "
                                    "expected a medium that light meets");
    return medium;
}

Colour read_colour(Section& section) {
    for (const auto* key : {"sigma_a", "sigma_s_reduced", "sigma_s", "g", "index"})
        if (section.has(key))
            section.note(key, fmt::format("a material with both 'colour' and '{}', expected one: "
                                          "coefficients follow from the colour",
                                          key));
    return {section.rgb("colour", {0, 1}), section.rgb("mean_free_path_mm", {1e-6, 1e6})};
}

} // namespace

OwnMaterial read_material(Section section, const KnownNames& known) {
    OwnMaterial material;
    material.line = section.line();
    material.id.value = section.id();
    if (std::find(known.materials.begin(), known.materials.end(), material.id.value) !=
        known.materials.end())
        section.refuse("id", "another name: a measured material is called that");
    const bool has_colour = section.has("colour");
    if (has_colour)
        material.medium = read_colour(section);
    else if (section.has("sigma_a"))
        material.medium = read_coefficients(section);
    else
        section.note("id", fmt::format("[[material]] '{}' has neither 'sigma_a' nor 'colour', "
                                       "expected its coefficients or its colour",
                                       material.id.value));
    section.expect_nothing_else();
    return material;
}

} // namespace protocols
