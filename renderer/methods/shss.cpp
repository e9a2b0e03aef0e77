// The thickness is reconstructed when a light moves; drawing interpolates it.
#include "renderer/methods/shss.h"

#include "renderer/methods/shared_dials.h"
#include "renderer/methods/shss.frag.h"
#include "renderer/methods/shss.vert.h"
#include "renderer/reconstruction/thickness_pass.h"
#include "renderer/shading/shading.h"

#include <fmt/format.h>

#include <optional>
#include <utility>

namespace renderer::methods {

using reconstruction::BandChooser;
using reconstruction::BandPlan;
using reconstruction::BandSettings;
using reconstruction::BandWeights;
using reconstruction::most_bands;
using reconstruction::ThicknessPass;

namespace {

constexpr unsigned thickness_location = 2; // behind position and normal

class Shss : public Method {
  public:
    Shss(shading::SurfaceShader shader, ThicknessPass pass, BandPlan plan)
        : shader_(std::move(shader)), pass_(std::move(pass)), plan_(std::move(plan)) {}

    Expected<void> update(const Scene& scene, double seconds) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        const auto weights = plan_.weights(scene, seconds);
        if (weights == weights_ && lit_ == shading::lighting_of(scene))
            return {};
        lit_.reset();
        if (const auto done = pass_.run(scene, weights); !done)
            return done;
        shader_.vertex_array().feed(
            thickness_location, pass_.thickness(),
            {.components = static_cast<int>(scene.lights.size()), .per_input = 1});
        weights_ = weights;
        lit_ = shading::lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override {
        return {.bytes_per_vertex = pass_.bytes_per_vertex(),
                .bytes_per_light = pass_.bytes_per_light(),
                .passes_per_light = 1};
    }

    std::string decision() const override { return plan_.decision(); }

    std::optional<double> predicted_change() const override { return plan_.predicted_change(); }

    void let_choose(bool may) override { plan_.let_choose(may); }

  private:
    shading::SurfaceShader shader_;
    ThicknessPass pass_;
    BandPlan plan_;
    BandWeights weights_{};
    std::optional<shading::Lighting> lit_;
};

Expected<void> check_bands(int bands, const thickness::ThicknessField* field) {
    if (bands < 1 || bands > most_bands)
        return tl::make_unexpected(
            fmt::format("SHSS with {} bands, expected 1..{}", bands, most_bands));
    if (field == nullptr)
        return tl::make_unexpected("SHSS without a thickness field, expected one of its mesh");
    if (field->bands < bands)
        return tl::make_unexpected(
            fmt::format("SHSS with {0} bands and a thickness field of {1}, expected {0} or more",
                        bands, field->bands));
    return {};
}

thickness::ComponentType component_type(const Dials& dials) {
    const auto name = name_in(dials, "coefficients");
    if (name == "int8")
        return thickness::ComponentType::Int8;
    return name == "float16" ? thickness::ComponentType::Float16
                             : thickness::ComponentType::Float32;
}

BandSettings band_settings(const Dials& dials) {
    BandSettings settings;
    if (!is_name(dials, "bands"))
        settings.bands = static_cast<int>(whole_in(dials, "bands"));
    else
        settings.chooser =
            name_in(dials, "bands") == "paper" ? BandChooser::Paper : BandChooser::Tolerance;
    settings.tolerance = number_in(dials, "tolerance");
    return settings;
}

std::optional<DialProblem> refuse_dials(const Dials& dials) {
    const auto bands = band_settings(dials);
    if (const int least = 2 * bands.bands * bands.bands; whole_in(dials, "directions") < least)
        return DialProblem{"directions",
                           fmt::format("is {}, expected at least {}, two for each coefficient of "
                                       "{} bands",
                                       whole_in(dials, "directions"), least, bands.bands)};
    if (bands.chooser != BandChooser::Tolerance && bands.tolerance != BandSettings{}.tolerance)
        return DialProblem{"tolerance", fmt::format("is {}, but only bands = \"auto\" asks for one",
                                                    bands.tolerance)};
    return std::nullopt;
}

std::vector<Dials> settings_worth_measuring() {
    auto settings = one_at_a_time({{"bands", {1, 2, 3, 4, 6, "auto"}},
                                   {"coefficients", {"float16", "int8"}},
                                   {"directions", {64, 256}}});
    const auto add = [&](const std::vector<DialSteps>& steps, const Dials& throughout) {
        for (auto& more : one_at_a_time(steps, throughout))
            settings.push_back(std::move(more));
    };
    add({{"bands", {2, 3}}}, {{"coefficients", "int8"}});
    add({{"tolerance", {0.05, 0.1}}}, {{"bands", "auto"}});
    add({{"thickness", {"first", "span"}}}, {{"directions", 256}});
    return settings;
}

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials& dials, const Subject& subject) {
    const ShssSettings settings{
        .bands = band_settings(dials), .law = law_of(dials), .coefficients = component_type(dials)};
    const auto field =
        subject.field({.kind = thickness_kind(dials),
                       .bands = settings.bands.bands,
                       .directions = static_cast<int>(whole_in(dials, "directions"))});
    if (!field)
        return tl::make_unexpected(field.error());
    std::optional<thickness::SurfaceSample> sample;
    if (settings.bands.chooser == BandChooser::Tolerance)
        sample = thickness::sample_surface(subject.mesh, **field);
    return prepare_shss(settings, subject.surface, *field, std::move(sample));
}

} // namespace

Description describe_shss() {
    return {.name = "shss",
            .label = "SHSS",
            .source = "SHSS",
            .dials = {{.name = "bands",
                       .meaning = "spherical-harmonic bands n, n^2 coefficients per vertex; auto: "
                                  "as few as change the picture by less than the tolerance; paper: "
                                  "5 with the light behind the object, else 2",
                       .preset = std::int64_t{5},
                       .whole = DialRange<std::int64_t>{1, most_bands},
                       .names = {"auto", "paper"}},
                      {.name = "tolerance",
                       .meaning = "what bands = auto may change, root mean square brightness over "
                                  "what is seen, 1 = white",
                       .preset = BandSettings{}.tolerance,
                       .number = DialRange<double>{0, 1}},
                      law_dial(),
                      thickness_dial(),
                      {.name = "directions",
                       .meaning = "rays per vertex, at least two for each coefficient",
                       .preset = std::int64_t{1024},
                       .whole = DialRange<std::int64_t>{1, 65536}},
                      {.name = "coefficients",
                       .meaning = "how they are stored on the GPU; int8 takes a byte each",
                       .preset = "float32",
                       .names = {"float32", "float16", "int8"}}},
            .prepare = prepare_from_dials,
            .refuse = refuse_dials,
            .sweep = settings_worth_measuring(),
            .scatters_by_thickness = true};
}

Expected<std::unique_ptr<Method>>
prepare_shss(const ShssSettings& settings,
             std::shared_ptr<const shading::Surface> surface,
             std::shared_ptr<const thickness::ThicknessField> field,
             std::optional<thickness::SurfaceSample> sample) {
    if (const auto fits = check_bands(settings.bands.bands, field.get()); !fits)
        return tl::make_unexpected(fits.error());
    const auto attenuation = shading::attenuation_for(settings.law, field.get());
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto pass =
        ThicknessPass::prepare(surface, *field, settings.bands.bands, settings.coefficients);
    if (!pass)
        return tl::make_unexpected(pass.error());
    auto shader = shading::SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.vertex = {{"shss.vert", shss_vert}}, .fragment = {{"shss.frag", shss_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Shss>(
        std::move(*shader), std::move(*pass),
        BandPlan(settings.bands, *attenuation, std::move(field), std::move(sample)));
}

} // namespace renderer::methods
