// One scene's model in video memory, prepared for every method the study compares on it.
#pragma once

#include "experiment/models.h"
#include "experiment/stimuli/manifest.h"
#include "experiment/study_folder.h"
#include "protocols/study.h"
#include "renderer/imaging/linear_image.h"
#include "renderer/methods/method.h"
#include "renderer/pictures/fitting.h"

#include <tl/expected.hpp>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace experiment::stimuli {

/// stimuli/<scene>/<variant>/<condition>.png, and .exr beside it
std::filesystem::path png_file(const StudyFolder& folder, const protocols::Picture& picture);
std::filesystem::path exr_file(const StudyFolder& folder, const protocols::Picture& picture);

/// The coefficients with which a condition comes nearest to given pictures of a scene.
struct Fit {
    protocols::SceneId scene;
    protocols::ConditionId condition;
    renderer::pictures::ReflectanceFit::Result best;
    std::optional<renderer::pictures::RelativeError> held_out_error; ///< of the light left out
};

/// Needs a current OpenGL context, and has to be gone before that is.
class SceneRenderer {
  public:
    /// Traces the thickness the conditions ask for and prepares every method.
    /// Errors: an unknown material, what the tracing or a method refuses.
    static tl::expected<SceneRenderer, std::string>
    prepare(const protocols::Study& study,
            const protocols::Scene& scene,
            LoadedModel model,
            int samples,
            const std::function<void(double)>& progress);

    /// Draws all rendered conditions under one light, equalises their brightness and writes them.
    tl::expected<std::map<protocols::Picture, PictureRecord>, std::string>
    render(const protocols::Variant& variant, const StudyFolder& folder);

    /// Fits every condition that is drawn to the targets, one for each variant, all lights but the
    /// one held out (none by an empty id) together.
    /// Errors: targets of another size or without a pixel in common.  EXPECTS a target for each.
    tl::expected<std::vector<Fit>, std::string>
    fit(const std::vector<protocols::Variant>& variants,
        const protocols::VariantId& held_out,
        const std::map<protocols::VariantId, renderer::imaging::LinearImage>& targets);

    const ModelRecord& model() const { return model_.record; }

    const std::vector<std::string>& remarks() const { return model_.remarks; }

  private:
    /// A condition that is rendered, ready to draw.
    struct Contender {
        const protocols::Condition* condition = nullptr;
        std::unique_ptr<renderer::methods::Method> method; ///< null: the reference
        std::optional<double> precompute_seconds;
    };

    struct Drawn;

    SceneRenderer(const protocols::Study& study,
                  const protocols::Scene& scene,
                  LoadedModel model,
                  int samples)
        : study_(&study), scene_(&scene), model_(std::move(model)), samples_(samples) {}

    tl::expected<void, std::string> prepare_contenders(const std::function<void(double)>& progress);
    tl::expected<std::vector<Drawn>, std::string> draw_all(const protocols::Variant& variant);
    tl::expected<Drawn, std::string> draw(Contender& contender, const renderer::Scene& scene) const;
    tl::expected<Drawn, std::string> draw_reference(const protocols::Condition& condition,
                                                    const renderer::Scene& scene) const;
    std::optional<double> reference_mean(const std::vector<Drawn>& drawn,
                                         std::span<const std::size_t> mask) const;
    static std::vector<std::size_t> common_mask(const std::vector<Drawn>& drawn);

    const protocols::Study* study_;
    const protocols::Scene* scene_;
    LoadedModel model_;
    int samples_;
    std::vector<Contender> contenders_;
};

} // namespace experiment::stimuli
