// Smoothing happens once, in double on the CPU; a picture costs Phong's model and what is fetched.
#include "renderer/methods/patro.h"

#include "renderer/diffusion/dipole.h"
#include "renderer/methods/patro_harmonics.frag.h"
#include "renderer/methods/patro_harmonics.vert.h"
#include "renderer/methods/patro_normals.frag.h"
#include "renderer/methods/patro_normals.vert.h"
#include "renderer/shading/harmonics.glsl.h"
#include "renderer/shading/shading.h"
#include "renderer/smoothing/shading_fields.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace renderer::methods {

namespace {

constexpr unsigned first_location = 2; // behind position and normal
constexpr std::size_t channels = 3;

class Patro : public Method {
  public:
    /// `rows`: three floats to a shader input, `inputs` of them to a vertex.
    Patro(shading::SurfaceShader shader, const std::vector<float>& rows, int inputs)
        : shader_(std::move(shader)), rows_(gpu::Buffer::holding<float>(rows)), inputs_(inputs) {
        shader_.vertex_array().feed(first_location, rows_,
                                    {.components = 3 * inputs, .per_input = 3});
    }

    Expected<void> update(const Scene& scene, double) override { return shader_.adapt(scene); }

    void draw(const Scene& scene) override { shader_.draw(scene); }

    Cost cost() const override {
        return {.bytes_per_vertex = 3 * sizeof(float) * static_cast<std::size_t>(inputs_)};
    }

  private:
    shading::SurfaceShader shader_;
    gpu::Buffer rows_;
    int inputs_;
};

/// Diffusion times of red, green and blue in the subject's model units squared.
std::array<double, channels> diffusion_times(const Subject& subject) {
    const double mm_per_unit =
        std::cbrt(std::abs(glm::determinant(glm::dmat3(subject.placement.world_from_model))));
    const Millimetres diameter{2 * subject.surface->model_sphere().radius * mm_per_unit};
    std::array<double, channels> times{};
    const auto dipoles = diffusion::dipoles(subject.material.medium);
    for (std::size_t c = 0; c < channels; ++c)
        times[c] = smoothing::diffusion_time(diffusion::mean_square_radius(dipoles[c]), diameter) /
                   (mm_per_unit * mm_per_unit);
    return times;
}

void tell(const thickness::Progress& progress, std::size_t channels_done) {
    if (progress)
        progress(static_cast<double>(channels_done) / channels);
}

/// Three inputs to a vertex: the normal of red, of green, of blue.
Expected<std::vector<float>> normal_rows(const Subject& subject) {
    const auto normals = geometry::vertex_normals(subject.mesh);
    const auto times = diffusion_times(subject);
    smoothing::SurfaceSmoother smoother(subject.mesh);
    std::vector<float> rows(9 * normals.size());
    for (std::size_t c = 0; c < channels; ++c) {
        const auto smooth = smoothing::smoothed_normals(smoother, times[c], normals);
        if (!smooth)
            return tl::make_unexpected(smooth.error());
        for (std::size_t v = 0; v < normals.size(); ++v)
            for (int axis = 0; axis < 3; ++axis)
                rows[9 * v + 3 * c + static_cast<std::size_t>(axis)] =
                    static_cast<float>((*smooth)[v][axis]);
        tell(subject.progress, c + 1);
    }
    return rows;
}

/// Nine inputs to a vertex: each coefficient of red, green and blue.
Expected<std::vector<float>> irradiance_rows(const Subject& subject) {
    const auto normals = geometry::vertex_normals(subject.mesh);
    const auto times = diffusion_times(subject);
    smoothing::SurfaceSmoother smoother(subject.mesh);
    std::vector<float> rows(27 * normals.size());
    for (std::size_t c = 0; c < channels; ++c) {
        const auto smooth = smoothing::smoothed_irradiance(smoother, times[c], normals);
        if (!smooth)
            return tl::make_unexpected(smooth.error());
        for (std::size_t i = 0; i < smooth->size(); ++i)
            rows[3 * i + c] = static_cast<float>((*smooth)[i]);
        tell(subject.progress, c + 1);
    }
    return rows;
}

Expected<std::unique_ptr<Method>> prepare(const Subject& subject,
                                          shading::ShaderSource source,
                                          const Expected<std::vector<float>>& rows,
                                          int inputs) {
    if (!rows)
        return tl::make_unexpected(rows.error());
    auto shader = shading::SurfaceShader::prepare(subject.surface, {}, std::move(source));
    if (!shader)
        return tl::make_unexpected(shader.error());
    return std::make_unique<Patro>(std::move(*shader), *rows, inputs);
}

} // namespace

Description describe_patro() {
    return {.name = "patro",
            .label = "Patro (reconstruction)",
            .caveat = "reconstruction",
            .source = "Patro2007",
            .dials = {{.name = "variant",
                       .meaning = "what is smoothed over the surface: a normal for each colour "
                                  "channel, or irradiance in three bands of spherical harmonics",
                       .preset = "normals",
                       .names = {"normals", "harmonics"}}},
            .prepare =
                [](const Dials& dials, const Subject& subject) {
                    return prepare_patro({name_in(dials, "variant") == "harmonics"
                                              ? PatroSettings::Variant::Harmonics
                                              : PatroSettings::Variant::Normals},
                                         subject);
                },
            .sweep = one_at_a_time({{"variant", {"harmonics"}}})};
}

Expected<std::unique_ptr<Method>> prepare_patro(const PatroSettings& settings,
                                                const Subject& subject) {
    if (settings.variant == PatroSettings::Variant::Normals)
        return prepare(subject,
                       {.defines = "",
                        .vertex = {{"patro_normals.vert", patro_normals_vert}},
                        .fragment = {{"patro_normals.frag", patro_normals_frag}}},
                       normal_rows(subject), 3);
    return prepare(subject,
                   {.defines = "#define BANDS 3\n#define SLOTS 3\n",
                    .vertex = {{"harmonics.glsl", shading::harmonics_glsl},
                               {"patro_harmonics.vert", patro_harmonics_vert}},
                    .fragment = {{"patro_harmonics.frag", patro_harmonics_frag}}},
                   irradiance_rows(subject), 9);
}

} // namespace renderer::methods
