// Everything `pairlight cost` found, as one value: files, figures and pages are functions of it.
#pragma once

#include "renderer/cost/quantiles.h"

#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace experiment::cost {

/// Which of the four errors.  All are relative: root mean square of the difference over the root
/// mean square of the truth, over the object's pixels.
enum class ErrorKind {
    Thickness, ///< thickness against traced thickness, under lights that nobody was made for
    Law,       ///< picture against the same law with traced thickness; both of the whole mesh
    Reference, ///< picture against the path-traced one, at equal brightness
    Fitted ///< the same with the coefficients k that suit the method best (docs/fair-parameters.md)
};

inline constexpr std::array all_errors{ErrorKind::Thickness, ErrorKind::Law, ErrorKind::Reference,
                                       ErrorKind::Fitted};

/// As options and columns have it: "thickness", "law", "reference", "fitted".
std::string_view name_of(ErrorKind kind);
std::optional<ErrorKind> error_kind(std::string_view name);

/// One setting under one light.  What was not measured, or means nothing there, is absent.
struct LightErrors {
    std::optional<double> law, reference, fitted;
    std::optional<double> as_drawn; ///< against the path-traced one, brightness as it is
    std::optional<double> flip;     ///< LDR-FLIP against it, at equal brightness
    std::string decision;           ///< what the method chose by itself, and why
    /// What that choice changes in the picture: as the method reckoned, and as two pictures say.
    std::optional<double> predicted_change, measured_change;
    bool operator==(const LightErrors&) const = default;
};

/// One setting of one method on one scene.
struct Row {
    std::string method, label;                ///< its name, and as people read it
    std::map<std::string, std::string> dials; ///< all of them
    std::string setting;                      ///< what is not preset: "bands 3, coefficients int8"
    std::size_t vertices = 0, triangles = 0;  ///< of the mesh that is drawn
    std::size_t mesh_bytes = 0;               ///< its positions, normals and triangles
    std::optional<double> precompute_seconds; ///< alone, on all cores
    std::size_t bytes_per_vertex = 0;
    std::size_t bytes_per_light = 0;
    renderer::cost::Spread frame_ms;   ///< as CostReport::timed_by says, the light moving
    renderer::cost::Spread resting_ms; ///< the light at rest
    renderer::cost::Spread to_bare;    ///< frame time over that of the bare model in the same round
    double clock_ms = 0;               ///< by the clock, the light moving; median
    std::optional<double> thickness;   ///< ErrorKind::Thickness
    std::vector<LightErrors> lights;   ///< as SceneCost::lights
    bool operator==(const Row&) const = default;
};

/// The operating point under one light.
struct Choice {
    std::size_t row = 0;
    std::string why;      ///< in words
    std::string left_out; ///< what it does without, in words
    double predicted = 0; ///< its error in the sweep
    /// The same error of the picture at the study's size; absent where there is no truth of that
    /// size.
    std::optional<double> measured;
    bool operator==(const Choice&) const = default;
};

struct LightCase {
    std::string id, label;
    int width = 0, height = 0;         ///< of the pictures that were compared
    std::optional<double> noise_floor; ///< of the path-traced picture, as the errors are
    std::string reference;             ///< what that is, in words; "" when there is none
    std::optional<Choice> choice;
    bool operator==(const LightCase&) const = default;
};

struct SceneCost {
    std::string id, label, model;
    std::size_t vertices = 0, triangles = 0;
    int frame_width = 0, frame_height = 0; ///< of the pictures that were timed
    std::vector<LightCase> lights;
    std::vector<Row> rows;
    std::vector<std::string> remarks; ///< what could not be measured, and why
    bool operator==(const SceneCost&) const = default;
};

/// What the choice was asked for.
struct Wish {
    ErrorKind error = ErrorKind::Law;
    std::optional<double> tolerance = 0.05;
    std::optional<double> budget_ms;
    bool operator==(const Wish&) const = default;
};

struct CostReport {
    std::string program, renderer, written_on, subject;
    std::string law;
    std::string timed_by; ///< "processor" (time of all its threads) or "clock"
    int rounds = 0;
    int held_out_lights = 0;
    Wish wish;
    std::vector<SceneCost> scenes;
    bool operator==(const CostReport&) const = default;
};

/// Of a row under a light; NaN where there is none.
double error_of(const Row& row, std::size_t light, ErrorKind kind);

/// What is kept to draw it: the mesh, and what the method has at its vertices.
std::size_t bytes_in_all(const Row& row);

/// "SHSS, bands 3" or "SHSS" for the presets.
std::string full_name(const Row& row);

/// Whether any row has that error under that light.
bool has_error(const SceneCost& scene, std::size_t light, ErrorKind kind);

} // namespace experiment::cost
