// A scene's picture and what is left of its noise.
#include "renderer/reference/reference_picture.h"

namespace renderer::reference {

Expected<ReferencePicture> reference_picture(const geometry::Mesh& mesh,
                                             const renderer::Scene& scene,
                                             int width,
                                             int height,
                                             const ReferenceRun& run,
                                             const std::function<void(double)>& progress) {
    const auto world = picture_of_scene(mesh, scene, run.settings);
    if (!world)
        return tl::unexpected(world.error());
    Film film = blank_film(width, height, run.seed);
    const auto outcome = render(*world, film, run.rule, {}, [&](const Progress& state) {
        if (progress)
            progress(state.fraction);
    });
    if (!outcome)
        return tl::unexpected(outcome.error());
    return ReferencePicture{picture(film), error_picture(film), halves(film), *outcome,
                            film.batches << film.log2_batch};
}

} // namespace renderer::reference
