// What the program knows of a method before it makes one, and what a method is made from.
#pragma once

#include "renderer/expected.h"
#include "renderer/geometry/mesh.h"
#include "renderer/methods/dials.h"
#include "renderer/methods/method.h"
#include "renderer/scene.h"
#include "renderer/shading/surface.h"
#include "renderer/thickness/thickness_field.h"
#include "renderer/transfer/transfer_field.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace renderer::methods {

/// Traces the body's thickness, or has it already.  Fields are shared between methods.
using FieldProvider = std::function<Expected<std::shared_ptr<const thickness::ThicknessField>>(
    const thickness::FieldOptions&)>;

/// Computes a transfer field, or has it already.
using TransferProvider = std::function<Expected<std::shared_ptr<const transfer::TransferField>>(
    const transfer::TransferOptions&)>;

/// What a method is made for.  Everything outlives the making, not the method.
struct Subject {
    const geometry::Mesh& mesh; ///< welded, closed, facing outward
    std::shared_ptr<const shading::Surface> surface;
    Material material;   ///< a method may build the medium in: another one wants it made again
    Placement placement; ///< the same holds for its scale, mm to a model unit
    FieldProvider field;
    thickness::Progress progress;   ///< for what a method computes by itself
    TransferProvider transfer = {}; ///< where several methods share them; else each has its own
};

struct Description {
    std::string name;        ///< in study files
    std::string label;       ///< as people read it, wherever they do
    std::string caveat = {}; ///< a word that it and the labels of conditions must have; or none
    std::string source;      ///< key in docs/bibliography.md; empty for textbook matter
    std::vector<Dial> dials;
    Expected<std::unique_ptr<Method>> (*prepare)(const Dials& complete_dials,
                                                 const Subject&) = nullptr;

    /// What is wrong with dials that are right one by one; may be null.
    std::optional<DialProblem> (*refuse)(const Dials& complete_dials) = nullptr;

    /// Settings whose cost and error are worth knowing, beside the presets: what they change.
    std::vector<Dials> sweep = {};

    /// Its scatter term is k_sc I_p times the law of a thickness toward the light, and nothing
    /// else, so that a picture of that term tells the thickness.
    bool scatters_by_thickness = false;
};

} // namespace renderer::methods
