// What the viewer shows: a study's scenes, variants and conditions, or one model by itself.
#pragma once

#include "experiment/study_folder.h"
#include "protocols/study.h"
#include "renderer/methods/dials.h"
#include "renderer/scene.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::viewer {

/// A scene, and the material it is made of.
struct Piece {
    protocols::Scene scene;
    renderer::Material material;
};

/// A way to shade that can be chosen: a study's condition, or a method at its presets.
struct Choice {
    std::string label; ///< as people read it
    std::string method;
    renderer::methods::Dials dials; ///< all of the method's
};

struct Exhibit {
    std::string name;
    StudyFolder folder;                       ///< where models are looked for first
    std::vector<Piece> pieces;                ///< at least one
    std::vector<protocols::Variant> variants; ///< at least one
    std::vector<Choice> choices;              ///< a study's conditions, then all methods
    int surround = 128;                       ///< code value of the grey around the model
    std::vector<std::string> remarks;         ///< what of a study cannot be viewed
};

/// A model by itself: how large it is made, and of what.
struct ModelOptions {
    double diameter_mm = 100;
    std::string material = "marble"; ///< a measured one
};

/// Opens the study that `name` (a folder with a study.toml, or that file) means, else the model: a
/// file, a name on the search path, or a body.  Models are read later, scene by scene.
/// Errors: those of the study file; a study without models to render; an unknown material; for a
/// model, where it was looked for.
tl::expected<Exhibit, std::string> open_exhibit(const std::string& name,
                                                const ModelOptions& options);

} // namespace experiment::viewer
