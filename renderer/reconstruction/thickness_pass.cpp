// Coefficients as streams of bands, the lights' basis functions as a uniform block.
#include "renderer/reconstruction/thickness_pass.h"

#include "renderer/contract.h"
#include "renderer/harmonics/basis.h"
#include "renderer/reconstruction/thickness_pass.vert.h"
#include "renderer/shading/harmonics.glsl.h"

#include <fmt/format.h>
#include <glm/ext/vector_uint4.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <algorithm>

namespace renderer::reconstruction {

namespace {

constexpr unsigned first_location = 2; // behind position and normal

/// Every stream of bands begins a new shader input of four numbers: bands 0 and 1 fill the first, a
/// later band l has 2l+1 coefficients in (2l+4)/4 inputs.
int slots_of_band(int l) {
    return (2 * l + 4) / 4;
}

int slots_of(int bands) {
    int slots = 1;
    for (int l = 2; l < bands; ++l)
        slots += slots_of_band(l);
    return slots;
}

/// Streams that hold the first `bands` bands.
std::size_t streams_of(int bands) {
    return static_cast<std::size_t>(std::max(1, bands - 1));
}

gpu::Component component(thickness::ComponentType type) {
    switch (type) {
    case thickness::ComponentType::Float16:
        return gpu::Component::Float16;
    case thickness::ComponentType::Int8:
        return gpu::Component::Fraction8;
    case thickness::ComponentType::Float32:
        break;
    }
    return gpu::Component::Float32;
}

int band_of(int coefficient) {
    int l = 0;
    while (harmonics::coefficient_count(l + 1) <= coefficient)
        ++l;
    return l;
}

/// Values of the flat order, in the order of the slots, holes zero.
void append_slots(std::span<const double> flat, int bands, std::vector<glm::vec4>& block) {
    const auto append = [&](int first, int count, int slots) {
        const auto slot = block.size();
        block.resize(slot + static_cast<std::size_t>(slots), glm::vec4(0));
        for (int i = 0; i < count; ++i)
            block[slot + static_cast<std::size_t>(i / 4)][i % 4] =
                static_cast<float>(flat[static_cast<std::size_t>(first + i)]);
    };
    append(0, std::min(4, harmonics::coefficient_count(bands)), 1);
    for (int l = 2; l < bands; ++l)
        append(harmonics::flat_index(l, -l), 2 * l + 1, slots_of_band(l));
}

int used_bands(const BandWeights& weights) {
    int bands = most_bands;
    while (bands > 1 && weights[static_cast<std::size_t>(bands - 1)] == 0)
        --bands;
    return bands;
}

/// Ranges as the shader reads them: slot by slot, in each slot block by block; holes zero.
std::vector<glm::uvec4> ranges_in_slots(std::span<const thickness::Stream> streams,
                                        std::size_t blocks) {
    std::vector<glm::uvec4> ranges;
    for (const auto& stream : streams) {
        const auto components = stream.scale.size();
        const auto first = ranges.size();
        ranges.resize(first + (components + 3) / 4 * blocks, glm::uvec4(0));
        for (std::size_t b = 0; b < blocks; ++b)
            for (std::size_t k = 0; k < components; ++k)
                ranges[first + k / 4 * blocks + b][static_cast<int>(k % 4)] =
                    stream.blocks[b * components + k];
    }
    return ranges;
}

/// What a stored component is multiplied by: its stream's scale and its band's weight.
std::vector<double> coefficient_scales(std::span<const thickness::Stream> streams,
                                       const BandWeights& weights,
                                       int bands) {
    std::vector<double> scales;
    for (const auto& stream : streams)
        for (const float scale : stream.scale)
            scales.push_back(static_cast<double>(scale));
    scales.resize(static_cast<std::size_t>(harmonics::coefficient_count(bands)));
    for (std::size_t i = 0; i < scales.size(); ++i)
        scales[i] *=
            static_cast<double>(weights[static_cast<std::size_t>(band_of(static_cast<int>(i)))]);
    return scales;
}

/// y of every far light times the scales; dividing by the stretch turns model units into mm.
void append_far_lights(const Scene& scene,
                       std::span<const double> scales,
                       int bands,
                       std::vector<glm::vec4>& block) {
    for (const auto& light : scene.lights) {
        std::vector<double> y(scales.size());
        if (const auto* far = std::get_if<DirectionalLight>(&light.place)) {
            const auto seen = shading::model_light(*far, scene.placement);
            harmonics::evaluate(bands, seen.to_light, y);
            for (std::size_t i = 0; i < y.size(); ++i)
                y[i] *= scales[i] / seen.stretch;
        }
        append_slots(y, bands, block);
    }
}

void append_near_lights(const Scene& scene,
                        const shading::Surface& surface,
                        std::span<const double> scales,
                        int bands,
                        std::vector<glm::vec4>& block) {
    const auto object_from_world = glm::inverse(surface.world_from_object(scene.placement));
    for (const auto& light : scene.lights) {
        const auto* near = std::get_if<PointLight>(&light.place);
        block.push_back(near == nullptr
                            ? glm::vec4(0)
                            : glm::vec4(object_from_world * glm::dvec4(near->position, 1)));
    }
    append_slots(scales, bands, block);
    const glm::mat4 linear(glm::dmat4(glm::dmat3(scene.placement.world_from_model)));
    for (int column = 0; column < 4; ++column)
        block.push_back(linear[column]);
    block.emplace_back(static_cast<float>(surface.model_sphere().radius), 0, 0, 0);
}

} // namespace

ThicknessPass::ThicknessPass(std::shared_ptr<const shading::Surface> surface,
                             std::vector<thickness::Stream> kept)
    : surface_(std::move(surface)), kept_(std::move(kept)),
      blocks_(kept_.front().blocks.size() / kept_.front().scale.size()) {
    if (blocks_ > 0)
        ranges_.emplace(gpu::Buffer::holding<glm::uvec4>(ranges_in_slots(kept_, blocks_)));
}

Expected<ThicknessPass> ThicknessPass::prepare(std::shared_ptr<const shading::Surface> surface,
                                               const thickness::ThicknessField& field,
                                               int bands,
                                               thickness::ComponentType type) {
    EXPECTS(bands >= 1 && bands <= std::min(field.bands, most_bands));
    const auto expected = surface->vertex_count() *
                          static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    if (field.coefficients.size() != expected)
        return tl::make_unexpected(
            fmt::format("a thickness field of {} coefficients, expected {} for {} vertices",
                        field.coefficients.size(), expected, surface->vertex_count()));
    return ThicknessPass(std::move(surface), thickness::band_streams(field, bands, type));
}

Expected<void> ThicknessPass::run(const Scene& scene, const BandWeights& weights) {
    const auto setup = shading::light_setup(scene);
    EXPECTS(setup.has_value());
    const int bands = used_bands(weights);
    EXPECTS(streams_of(bands) <= kept_.size());
    const auto pass = program(bands, *setup);
    if (!pass)
        return tl::make_unexpected(pass.error());
    send_bands(bands);

    const auto scales = coefficient_scales(kept_, weights, bands);
    std::vector<glm::vec4> block;
    append_far_lights(scene, scales, bands, block);
    if (setup->with_points)
        append_near_lights(scene, *surface_, scales, bands, block);
    uniforms_.emplace(std::as_bytes(std::span(block)));

    lights_ = scene.lights.size();
    const auto bytes = surface_->vertex_count() * lights_ * sizeof(float);
    if (!thickness_ || thickness_->bytes() != bytes)
        thickness_.emplace(bytes);
    uniforms_->bind_uniform_block(1);
    if (ranges_)
        ranges_->bind_storage_block(0);
    (*pass)->run(inputs_.at(bands), surface_->vertex_count(), *thickness_);
    return {};
}

void ThicknessPass::send_bands(int bands) {
    while (streams_.size() < streams_of(bands)) {
        auto& stream = kept_[streams_.size()];
        streams_.emplace_back(stream.bytes);
        std::vector<std::byte>().swap(stream.bytes);
    }
    if (inputs_.contains(bands))
        return;
    auto inputs = surface_->vertex_array();
    unsigned location = first_location;
    for (std::size_t i = 0; i < streams_of(bands); ++i)
        location = inputs.feed(
            location, streams_[i],
            {.components = kept_[i].components(), .component = component(kept_[i].type)});
    inputs_.emplace(bands, std::move(inputs));
}

Expected<const gpu::VertexPass*> ThicknessPass::program(int bands,
                                                        const shading::LightSetup& setup) {
    const Key key{bands, setup};
    if (const auto found = programs_.find(key); found != programs_.end())
        return &found->second;
    auto lines = defines(setup) +
                 fmt::format("#define BANDS {}\n#define SLOTS {}\n", bands, slots_of(bands));
    if (blocks_ > 0)
        lines += fmt::format("#define BLOCKS {}\n#define BLOCK_VERTICES {}\n", blocks_,
                             thickness::block_vertices);
    const std::array parts{gpu::ShaderPart{"defines", lines},
                           gpu::ShaderPart{"harmonics.glsl", shading::harmonics_glsl},
                           gpu::ShaderPart{"thickness_pass.vert", thickness_pass_vert}};
    const std::array captured{"thickness"};
    auto pass = gpu::VertexPass::link(parts, captured);
    if (!pass)
        return tl::make_unexpected(pass.error());
    return &programs_.emplace(key, std::move(*pass)).first->second;
}

std::size_t ThicknessPass::bytes_per_vertex() const {
    std::size_t bytes = 0;
    for (const auto& stream : streams_)
        bytes += stream.bytes();
    if (ranges_)
        bytes += ranges_->bytes();
    const auto vertices = surface_->vertex_count();
    return (bytes + vertices / 2) / vertices;
}

std::size_t ThicknessPass::bytes_per_light() const {
    return uniforms_ ? uniforms_->bytes() / lights_ : 0;
}

} // namespace renderer::reconstruction
