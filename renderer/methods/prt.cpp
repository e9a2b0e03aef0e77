// The light's coefficients meet transfer vectors when a light moves; drawing interpolates radiance.
#include "renderer/methods/prt.h"

#include "renderer/gpu/vertex_pass.h"
#include "renderer/harmonics/basis.h"
#include "renderer/methods/prt_channel.vert.h"
#include "renderer/methods/prt_clusters.vert.h"
#include "renderer/shading/body_radiance.h"

#include <fmt/format.h>
#include <glm/vec4.hpp>

#include <array>
#include <optional>
#include <utility>

namespace renderer::methods {

namespace {

constexpr int most_bands = 6;              // transfer::compute_transfer_field's
constexpr int most_representatives = 4096; // 64 kB of vec4: what drivers give a uniform block
constexpr int most_vectors = 15;           // with the cluster's number four inputs

std::size_t slots_of(std::size_t numbers) {
    return (numbers + 3) / 4;
}

/// l_i = sum over lights of E y_i(L), for each channel: lights add up before anything is lit.
std::array<std::vector<double>, 3>
light_coefficients(const Scene& scene, const shading::Surface& surface, int bands) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(bands));
    std::array<std::vector<double>, 3> light;
    light.fill(std::vector<double>(n));
    std::vector<double> y(n);
    for (const auto& [to_light, irradiance] : shading::incident_lights(scene, surface)) {
        harmonics::evaluate(bands, to_light, y);
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t i = 0; i < n; ++i)
                light[c][i] += irradiance[static_cast<int>(c)] * y[i];
    }
    return light;
}

/// What turns a scene's light into radiance at the vertices.
class RadiancePass {
  public:
    RadiancePass() = default;
    RadiancePass(const RadiancePass&) = delete;
    RadiancePass& operator=(const RadiancePass&) = delete;
    virtual ~RadiancePass() = default;

    /// Feeds its results to the inputs from `radiance_location` on; they stay where they are.
    virtual void feed(gpu::VertexArray& array) const = 0;
    virtual void run(const Scene& scene) = 0;
    virtual Cost cost() const = 0;
};

/// bands^2 numbers to a vertex and channel: one pass for each channel, as three are more than a
/// shader takes in at once.
class WholeVectors : public RadiancePass {
  public:
    WholeVectors(gpu::VertexPass pass,
                 std::shared_ptr<const shading::Surface> surface,
                 const transfer::TransferField& field)
        : pass_(std::move(pass)), surface_(std::move(surface)), bands_(field.bands) {
        const auto n = static_cast<std::size_t>(harmonics::coefficient_count(bands_));
        const std::size_t vertices = surface_->vertex_count();
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<float> rows;
            rows.reserve(vertices * n);
            for (std::size_t v = 0; v < vertices; ++v)
                for (std::size_t i = 0; i < n; ++i)
                    rows.push_back(field.transfer[(3 * v + c) * n + i]);
            channels_.push_back({gpu::Buffer::holding(std::span<const float>(rows)),
                                 surface_->vertex_array(), gpu::Buffer(vertices * sizeof(float)),
                                 gpu::Buffer(slots_of(n) * sizeof(glm::vec4))});
            channels_.back().inputs.feed(shading::radiance_location, channels_.back().transfer,
                                         {.components = static_cast<int>(n)});
        }
    }

    void feed(gpu::VertexArray& array) const override {
        unsigned location = shading::radiance_location;
        for (const auto& channel : channels_)
            location = array.feed(location, channel.radiance, {.components = 1, .per_input = 1});
    }

    void run(const Scene& scene) override {
        const auto light = light_coefficients(scene, *surface_, bands_);
        for (std::size_t c = 0; c < 3; ++c) {
            std::vector<float> block(light[c].begin(), light[c].end());
            block.resize(4 * slots_of(block.size()));
            channels_[c].light.replace(std::as_bytes(std::span<const float>(block)));
            channels_[c].light.bind_uniform_block(1);
            pass_.run(channels_[c].inputs, surface_->vertex_count(), channels_[c].radiance);
        }
    }

    Cost cost() const override {
        std::size_t per_vertex = 0, per_light = 0;
        for (const auto& channel : channels_) {
            per_vertex += channel.transfer.bytes() + channel.radiance.bytes();
            per_light += channel.light.bytes();
        }
        return {.bytes_per_vertex = per_vertex / surface_->vertex_count(),
                .bytes_per_light = per_light,
                .passes_per_light = 3};
    }

  private:
    struct Channel {
        gpu::Buffer transfer;
        gpu::VertexArray inputs;
        gpu::Buffer radiance;
        gpu::Buffer light;
    };

    gpu::VertexPass pass_;
    std::shared_ptr<const shading::Surface> surface_;
    int bands_;
    std::vector<Channel> channels_;
};

/// A cluster's number and a few weights to a vertex; the representatives meet the light first.
class Clusters : public RadiancePass {
  public:
    Clusters(gpu::VertexPass pass,
             std::shared_ptr<const shading::Surface> surface,
             const transfer::CompressedSignals& signals,
             int bands)
        : pass_(std::move(pass)), surface_(std::move(surface)), bands_(bands),
          representatives_(signals.representatives),
          rows_(gpu::Buffer::holding(std::span<const float>(rows_of(signals)))),
          inputs_(surface_->vertex_array()),
          radiance_(surface_->vertex_count() * 3 * sizeof(float)),
          block_(representatives_.size() / signals.dimension * sizeof(glm::vec4)) {
        inputs_.feed(shading::radiance_location, rows_,
                     {.components = static_cast<int>(signals.vectors + 1)});
    }

    void feed(gpu::VertexArray& array) const override {
        array.feed(shading::radiance_location, radiance_, {.components = 3, .per_input = 1});
    }

    void run(const Scene& scene) override {
        const auto light = light_coefficients(scene, *surface_, bands_);
        const std::size_t n = light[0].size();
        std::vector<glm::vec4> lit;
        for (std::size_t at = 0; at < representatives_.size(); at += 3 * n) {
            glm::dvec4 sum(0);
            for (std::size_t c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < n; ++i)
                    sum[static_cast<int>(c)] +=
                        light[c][i] * static_cast<double>(representatives_[at + c * n + i]);
            lit.emplace_back(sum);
        }
        block_.replace(std::as_bytes(std::span<const glm::vec4>(lit)));
        block_.bind_uniform_block(1);
        pass_.run(inputs_, surface_->vertex_count(), radiance_);
    }

    Cost cost() const override {
        return {.bytes_per_vertex = (rows_.bytes() + radiance_.bytes()) / surface_->vertex_count(),
                .bytes_per_light = block_.bytes(),
                .passes_per_light = 1};
    }

  private:
    static std::vector<float> rows_of(const transfer::CompressedSignals& signals) {
        std::vector<float> rows;
        for (std::size_t v = 0; v < signals.cluster_of.size(); ++v) {
            rows.push_back(static_cast<float>(signals.cluster_of[v]));
            for (std::size_t j = 0; j < signals.vectors; ++j)
                rows.push_back(signals.weights[v * signals.vectors + j]);
        }
        return rows;
    }

    gpu::VertexPass pass_;
    std::shared_ptr<const shading::Surface> surface_;
    int bands_;
    std::vector<float> representatives_;
    gpu::Buffer rows_;
    gpu::VertexArray inputs_;
    gpu::Buffer radiance_;
    gpu::Buffer block_;
};

class Prt : public Method {
  public:
    Prt(shading::SurfaceShader shader, std::unique_ptr<RadiancePass> pass, std::string decision)
        : shader_(std::move(shader)), pass_(std::move(pass)), decision_(std::move(decision)) {
        pass_->feed(shader_.vertex_array());
    }

    Expected<void> update(const Scene& scene, double) override {
        if (const auto ready = shader_.adapt(scene); !ready)
            return ready;
        if (lit_ != shading::lighting_of(scene)) {
            pass_->run(scene);
            lit_ = shading::lighting_of(scene);
        }
        return {};
    }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override { return pass_->cost(); }

    std::string decision() const override { return decision_; }

  private:
    shading::SurfaceShader shader_;
    std::unique_ptr<RadiancePass> pass_;
    std::string decision_;
    std::optional<shading::Lighting> lit_;
};

Expected<gpu::VertexPass>
link(std::string_view name, std::string_view text, const std::string& defines, const char* output) {
    const std::array parts{gpu::ShaderPart{"defines", defines}, gpu::ShaderPart{name, text}};
    const std::array captured{output};
    return gpu::VertexPass::link(parts, captured);
}

template <class Pass, class... Rest>
Expected<std::unique_ptr<Method>> method_with(Expected<gpu::VertexPass> program,
                                              std::shared_ptr<const shading::Surface> surface,
                                              std::string decision,
                                              const Rest&... rest) {
    if (!program)
        return tl::make_unexpected(program.error());
    auto shader = shading::body_radiance_shader(surface);
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Prt>(
        std::move(*shader),
        std::make_unique<Pass>(std::move(*program), std::move(surface), rest...),
        std::move(decision));
}

std::string undersampled_or_not(const transfer::TransferField& field) {
    return field.undersampled
               ? fmt::format("undersampled: {} surface samples are farther apart than one "
                             "transport mean free path",
                             field.samples)
               : std::string();
}

std::optional<DialProblem> refuse_dials(const Dials& dials) {
    const auto bands = whole_in(dials, "bands"), least = 2 * bands * bands;
    if (whole_in(dials, "directions") < least)
        return DialProblem{"directions",
                           fmt::format("is {}, expected at least {}, two for each coefficient of "
                                       "{} bands",
                                       whole_in(dials, "directions"), least, bands)};
    const auto clusters = whole_in(dials, "clusters"), vectors = whole_in(dials, "vectors");
    if (vectors > 0 && clusters * (vectors + 1) > most_representatives)
        return DialProblem{"clusters",
                           fmt::format("is {} with {} vectors each, expected at most {}", clusters,
                                       vectors, most_representatives / (vectors + 1))};
    if (vectors > 3 * bands * bands)
        return DialProblem{"vectors", fmt::format("is {}, expected at most {}, the length of a "
                                                  "transfer vector of {} bands",
                                                  vectors, 3 * bands * bands, bands)};
    return std::nullopt;
}

std::vector<Dials> settings_worth_measuring() {
    auto settings = one_at_a_time({{"bands", {1, 2, 3, 4, 6}}, {"vectors", {4, 8}}});
    for (const auto& shared : one_at_a_time({{"clusters", {64}}}, {{"vectors", 4}}))
        settings.push_back(shared);
    return settings;
}

Expected<std::shared_ptr<const transfer::TransferField>>
transfer_for(const transfer::TransferOptions& options, const Subject& subject) {
    if (subject.transfer)
        return subject.transfer(options);
    return transfer::compute_transfer_field(subject.mesh, subject.material.medium,
                                            shading::mm_per_unit(subject.placement), options,
                                            [&](double fraction) {
                                                if (subject.progress)
                                                    subject.progress(fraction);
                                                return true;
                                            })
        .map([](transfer::TransferField field) {
            return std::make_shared<const transfer::TransferField>(std::move(field));
        });
}

Expected<std::unique_ptr<Method>> prepare_from_dials(const Dials& dials, const Subject& subject) {
    const int bands = static_cast<int>(whole_in(dials, "bands"));
    const auto field = transfer_for(
        {.bands = bands, .directions = static_cast<int>(whole_in(dials, "directions"))}, subject);
    if (!field)
        return tl::make_unexpected(field.error());
    const auto vectors = static_cast<std::size_t>(whole_in(dials, "vectors"));
    if (vectors == 0)
        return prepare_prt(subject.surface, **field);
    const auto signals = transfer::compress(
        (*field)->transfer, static_cast<std::size_t>(3 * harmonics::coefficient_count(bands)),
        {.clusters = static_cast<std::size_t>(whole_in(dials, "clusters")), .vectors = vectors});
    return prepare_prt(subject.surface, signals, bands);
}

} // namespace

Description describe_prt() {
    return {.name = "prt",
            .label = "PRT",
            .source = "Sloan2003",
            .dials = {{.name = "bands",
                       .meaning = "spherical-harmonic bands n of the light, n^2 coefficients per "
                                  "vertex and channel",
                       .preset = std::int64_t{5},
                       .whole = DialRange<std::int64_t>{1, most_bands}},
                      {.name = "vectors",
                       .meaning = "principal vectors of a cluster; 0 keeps the transfer vectors "
                                  "whole",
                       .preset = std::int64_t{0},
                       .whole = DialRange<std::int64_t>{0, most_vectors}},
                      {.name = "clusters",
                       .meaning = "clusters of vertices that share principal vectors",
                       .preset = std::int64_t{256},
                       .whole = DialRange<std::int64_t>{1, most_representatives / 2}},
                      {.name = "directions",
                       .meaning = "rays per surface sample, at least two for each coefficient",
                       .preset = std::int64_t{1024},
                       .whole = DialRange<std::int64_t>{1, 65536}}},
            .prepare = prepare_from_dials,
            .refuse = refuse_dials,
            .sweep = settings_worth_measuring()};
}

Expected<std::unique_ptr<Method>> prepare_prt(std::shared_ptr<const shading::Surface> surface,
                                              const transfer::TransferField& field) {
    const auto n = static_cast<std::size_t>(harmonics::coefficient_count(field.bands));
    if (field.transfer.size() != surface->vertex_count() * 3 * n)
        return tl::make_unexpected(fmt::format(
            "a transfer field of {} numbers, expected {} for {} vertices", field.transfer.size(),
            surface->vertex_count() * 3 * n, surface->vertex_count()));
    auto program = link("prt_channel.vert", prt_channel_vert,
                        fmt::format("#define SLOTS {}\n", slots_of(n)), "radiance");
    return method_with<WholeVectors>(std::move(program), std::move(surface),
                                     undersampled_or_not(field), field);
}

Expected<std::unique_ptr<Method>> prepare_prt(std::shared_ptr<const shading::Surface> surface,
                                              const transfer::CompressedSignals& signals,
                                              int bands) {
    if (signals.cluster_of.size() != surface->vertex_count() ||
        signals.dimension != static_cast<std::size_t>(3 * harmonics::coefficient_count(bands)))
        return tl::make_unexpected(fmt::format(
            "{} signals of {} numbers, expected {} of {} for as many vertices and {} bands",
            signals.cluster_of.size(), signals.dimension, surface->vertex_count(),
            3 * harmonics::coefficient_count(bands), bands));
    if (signals.vectors > most_vectors ||
        signals.clusters * (signals.vectors + 1) > most_representatives)
        return tl::make_unexpected(
            fmt::format("{} clusters of {} vectors, expected at most {} vectors and {} in all, "
                        "means among them",
                        signals.clusters, signals.vectors, most_vectors, most_representatives));
    auto program =
        link("prt_clusters.vert", prt_clusters_vert,
             fmt::format("#define CLUSTERS {}\n#define VECTORS {}\n#define SLOTS {}\n",
                         signals.clusters, signals.vectors, slots_of(signals.vectors + 1)),
             "radiance");
    auto decision = fmt::format("{} clusters of {} vectors leave {:.2g} % of the transfer out",
                                signals.clusters, signals.vectors, 100 * signals.relative_error);
    return method_with<Clusters>(std::move(program), std::move(surface), std::move(decision),
                                 signals, bands);
}

} // namespace renderer::methods
