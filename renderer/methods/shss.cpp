// The thickness is reconstructed when a light moves; drawing interpolates it.
#include "renderer/methods/shss.h"

#include "renderer/methods/shading.h"
#include "renderer/methods/shss.frag.h"
#include "renderer/methods/shss.vert.h"
#include "renderer/methods/thickness_pass.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace renderer::methods {

namespace {

constexpr unsigned thickness_location = 2; // behind position and normal

class Shss : public Method {
  public:
    Shss(SurfaceShader shader, ThicknessPass pass, const ShssSettings& settings)
        : shader_(std::move(shader)), pass_(std::move(pass)) {
        std::fill_n(weights_.begin(), settings.bands, 1.0F);
    }

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (lit_ == lighting_of(scene))
            return {};
        lit_.reset();
        if (const auto done = pass_.run(scene, weights_); !done)
            return done;
        shader_.vertex_array().feed(
            thickness_location, pass_.thickness(),
            {.components = static_cast<int>(scene.lights.size()), .per_input = 1});
        lit_ = lighting_of(scene);
        return {};
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override {
        return {.bytes_per_vertex = pass_.bytes_per_vertex(),
                .bytes_per_light = pass_.bytes_per_light(),
                .passes_per_light = 1};
    }

  private:
    SurfaceShader shader_;
    ThicknessPass pass_;
    BandWeights weights_{};
    std::optional<Lighting> lit_;
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

thickness::Kind thickness_kind(const Dials& dials) {
    const auto name = name_in(dials, "thickness");
    if (name == "first")
        return thickness::Kind::First;
    return name == "span" ? thickness::Kind::Span : thickness::Kind::Sum;
}

std::optional<DialProblem> refuse_dials(const Dials& dials) {
    const auto bands = whole_in(dials, "bands"), least = 2 * bands * bands;
    if (whole_in(dials, "directions") >= least)
        return std::nullopt;
    return DialProblem{"directions",
                       fmt::format("is {}, expected at least {}, two for each coefficient of {} "
                                   "bands",
                                   whole_in(dials, "directions"), least, bands)};
}

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials& dials, const Subject& subject) {
    const ShssSettings settings{.bands = static_cast<int>(whole_in(dials, "bands")),
                                .law = law_of(dials)};
    const auto field =
        subject.field({.kind = thickness_kind(dials),
                       .bands = settings.bands,
                       .directions = static_cast<int>(whole_in(dials, "directions"))});
    if (!field)
        return tl::make_unexpected(field.error());
    return prepare_shss(settings, subject.surface, *field);
}

} // namespace

Description describe_shss() {
    return {.name = "shss",
            .label = "SHSS",
            .source = "SHSS",
            .dials = {{.name = "bands",
                       .meaning = "spherical-harmonic bands n, n^2 coefficients per vertex",
                       .preset = std::int64_t{5},
                       .whole = DialRange<std::int64_t>{1, most_bands}},
                      law_dial(),
                      {.name = "thickness",
                       .meaning = "which length counts: all interior segments, the one that starts "
                                  "at the vertex, or the way to the last exit",
                       .preset = "sum",
                       .names = {"sum", "first", "span"}},
                      {.name = "directions",
                       .meaning = "rays per vertex, at least two for each coefficient",
                       .preset = std::int64_t{1024},
                       .whole = DialRange<std::int64_t>{1, 65536}}},
            .prepare = prepare_from_dials,
            .refuse = refuse_dials};
}

Expected<std::unique_ptr<Method>>
prepare_shss(const ShssSettings& settings,
             std::shared_ptr<const Surface> surface,
             std::shared_ptr<const thickness::ThicknessField> field) {
    if (const auto fits = check_bands(settings.bands, field.get()); !fits)
        return tl::make_unexpected(fits.error());
    const auto attenuation = attenuation_for(settings.law, field.get());
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    auto pass = ThicknessPass::prepare(surface, std::move(field), settings.bands);
    if (!pass)
        return tl::make_unexpected(pass.error());
    auto shader = SurfaceShader::prepare(
        std::move(surface), *attenuation,
        {.vertex = {{"shss.vert", shss_vert}}, .fragment = {{"shss.frag", shss_frag}}});
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Shss>(std::move(*shader), std::move(*pass), settings);
}

} // namespace renderer::methods
