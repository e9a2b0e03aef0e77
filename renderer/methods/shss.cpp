// Coefficients as streams of bands, the light's basis functions as a uniform block.
#include "renderer/methods/shss.h"

#include "renderer/harmonics/basis.h"
#include "renderer/methods/shading.h"
#include "renderer/methods/shss.frag.h"
#include "renderer/methods/shss.vert.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace renderer::methods {

namespace {

// One vertex buffer to a stream, so that bands that are not asked for are neither sent nor fetched.
// Bands 0 and 1 share the first, as their four coefficients fill one shader input; a later band l
// has 2l+1 and begins a new input.
struct Stream {
    int first; // flat index of its first coefficient
    int count;
    int slots; // shader inputs of four floats
};

constexpr int most_bands = 6;
constexpr int most_slots = 11;
constexpr unsigned first_location = 2; // behind position and normal

std::vector<Stream> streams_of(int bands) {
    std::vector<Stream> streams{{0, std::min(4, harmonics::coefficient_count(bands)), 1}};
    for (int l = 2; l < bands; ++l)
        streams.push_back({harmonics::flat_index(l, -l), 2 * l + 1, (2 * l + 4) / 4});
    return streams;
}

int slots_of(int bands) {
    int slots = 0;
    for (const auto& stream : streams_of(bands))
        slots += stream.slots;
    return slots;
}

gpu::Buffer upload(const thickness::ThicknessField& field, const Stream& stream) {
    const auto stride = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    const auto first = static_cast<std::size_t>(stream.first);
    const auto count = static_cast<std::size_t>(stream.count);
    std::vector<float> rows;
    rows.reserve(field.coefficients.size() / stride * count);
    for (std::size_t row = 0; row < field.coefficients.size(); row += stride)
        for (std::size_t i = first; i < first + count; ++i)
            rows.push_back(field.coefficients[row + i]);
    return gpu::Buffer::holding<float>(rows);
}

using BasisSlots = std::array<float, 4 * most_slots>;

// y(L) in the order of the slots, holes zero.  Dividing by the stretch turns model units into mm.
BasisSlots basis_slots(const ModelLight& light, int bands) {
    std::vector<double> y(static_cast<std::size_t>(harmonics::coefficient_count(bands)));
    harmonics::evaluate(bands, light.to_light, y);
    BasisSlots slots{};
    std::size_t slot = 0;
    for (const auto& stream : streams_of(bands)) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(stream.count); ++i)
            slots[4 * slot + i] =
                static_cast<float>(y[static_cast<std::size_t>(stream.first) + i] / light.stretch);
        slot += static_cast<std::size_t>(stream.slots);
    }
    return slots;
}

class Shss : public Method {
  public:
    Shss(SurfaceShader shader, const thickness::ThicknessField& field, int bands)
        : shader_(std::move(shader)), bands_(bands), basis_(used_floats() * sizeof(float)) {
        unsigned location = first_location;
        for (const auto& stream : streams_of(bands)) {
            streams_.push_back(upload(field, stream));
            location = shader_.vertex_array().feed(location, streams_.back(), stream.count);
        }
    }

    Expected<void> relight(const Scene& scene) override {
        const auto light = model_light(scene);
        if (!light)
            return tl::make_unexpected(light.error());
        const auto slots = basis_slots(*light, bands_);
        basis_.replace(std::as_bytes(std::span(slots).first(used_floats())));
        return {};
    }

    void draw(const Scene& scene) override {
        basis_.bind_uniform_block(1);
        shader_.draw(scene);
    }

    Cost cost() const override {
        const auto coefficients = static_cast<std::size_t>(harmonics::coefficient_count(bands_));
        return {.bytes_per_vertex = coefficients * sizeof(float),
                .bytes_per_light = basis_.bytes()};
    }

  private:
    std::size_t used_floats() const { return 4 * static_cast<std::size_t>(slots_of(bands_)); }

    SurfaceShader shader_;
    int bands_;
    std::vector<gpu::Buffer> streams_;
    gpu::Buffer basis_;
};

Expected<void> check_field(const ShssSettings& settings,
                           const Surface& surface,
                           const thickness::ThicknessField* field) {
    if (settings.bands < 1 || settings.bands > most_bands)
        return tl::make_unexpected(
            fmt::format("SHSS with {} bands, expected 1..{}", settings.bands, most_bands));
    if (field == nullptr)
        return tl::make_unexpected("SHSS without a thickness field, expected one of its mesh");
    if (field->bands < settings.bands)
        return tl::make_unexpected(
            fmt::format("SHSS with {0} bands and a thickness field of {1}, expected {0} or more",
                        settings.bands, field->bands));
    const auto expected = surface.vertex_count() *
                          static_cast<std::size_t>(harmonics::coefficient_count(field->bands));
    if (field->coefficients.size() != expected)
        return tl::make_unexpected(
            fmt::format("a thickness field of {} coefficients, expected {} for {} vertices",
                        field->coefficients.size(), expected, surface.vertex_count()));
    return {};
}

} // namespace

Expected<std::unique_ptr<Method>> prepare_shss(const ShssSettings& settings,
                                               std::shared_ptr<const Surface> surface,
                                               const thickness::ThicknessField* field) {
    if (const auto fits = check_field(settings, *surface, field); !fits)
        return tl::make_unexpected(fits.error());
    const auto attenuation = attenuation_for(settings.law, field);
    if (!attenuation)
        return tl::make_unexpected(attenuation.error());
    const auto slots = fmt::format("#define SLOTS {}", slots_of(settings.bands));
    const std::array vertex{gpu::ShaderPart{"SLOTS", slots},
                            gpu::ShaderPart{"shss.vert", shss_vert}};
    const std::array fragment{gpu::ShaderPart{"shss.frag", shss_frag}};
    auto shader = SurfaceShader::prepare(std::move(surface), *attenuation, vertex, fragment);
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Shss>(std::move(*shader), *field, settings.bands);
}

} // namespace renderer::methods
