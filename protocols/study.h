// A study: what is compared, on what, and how people are asked.
//
// The file's form is documented in docs/study-file.md.  This room knows how a study is asked; what
// its rendering dials mean is the renderer's business, so the names they may take are handed in.
#pragma once

#include "protocols/expected.h"
#include "protocols/vocabulary.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace protocols {

/// How a condition's pictures are rendered.  Names are checked against `KnownNames` when the file
/// is read.
struct Rendering {
    std::string method; ///< "phong", "green", "shss"
    int bands = 5;      ///< SHSS: spherical-harmonic bands, 1..6, n bands are n^2 coefficients
    std::string law = "physical";  ///< attenuation: "paper" (1 - d) or "physical" exp(-sigma_tr d)
    std::string thickness = "sum"; ///< SHSS: "sum", "first" or "span"
    int directions = 1024;         ///< SHSS: rays per vertex
    int depth_map = 2048;          ///< Green: texels along an edge of the depth map
};

/// Pictures made elsewhere, already lying at stimuli/<scene>/[<variant>/]<condition>.png
struct OwnImages {};

struct Condition {
    ConditionId id;
    std::string label; ///< as people read it
    std::variant<Rendering, OwnImages> source;
    int line = 0; ///< in the study file, for messages
};

/// A medium by its coefficients, per millimetre and colour channel.
struct Coefficients {
    std::array<double, 3> sigma_a = {};
    std::array<double, 3> sigma_s_reduced = {}; ///< (1 - g) sigma_s
    double index = 1.3;                         ///< inside over outside
};

/// A medium by the colour of a thick layer of it in diffuse light, linear, 0..1.
struct Colour {
    std::array<double, 3> reflectance = {};
    std::array<double, 3> mean_free_path_mm = {}; ///< how far light spreads, per channel
};

using MaterialId = Name<struct MaterialTag>;

/// A material of the study's own, beside the measured ones.
struct OwnMaterial {
    MaterialId id; ///< as scenes name it
    std::variant<Coefficients, Colour> medium;
    int line = 0;
};

/// A named analytic body or a model file, and how it is looked at.
struct Scene {
    SceneId id;
    std::string label;
    std::string
        model; ///< a name on the model search path, a path, or a body ("sphere", "torus", ...)
    double turn_degrees =
        0; ///< turntable rotation about the vertical, counter-clockwise seen from above
    double elevation_degrees = 0;         ///< the camera's height above the horizon
    std::array<double, 3> up = {0, 1, 0}; ///< which way is up in the model's coordinates
    double diameter_mm = 100;             ///< diameter of the model's bounding sphere in the world
    std::optional<double> mm_per_unit =
        {};               ///< of the model's coordinates; instead of `diameter_mm`
    std::string material; ///< one of the study's own, or a measured one, by name
    int line = 0;
};

/// How a scene is lit.
struct Variant {
    VariantId id;
    std::string label;
    /// Unit vector from the surface toward the light, in view axes: x right, y up, z toward the
    /// viewer.
    std::array<double, 3> to_light = {0, 0, 1};
    int line = 0;
};

/// The grey around the pictures, as the code value written to the frame buffer, 0..255 per channel.
struct Surround {
    int code = 128;
};

struct SessionPlan {
    int sessions = 3;     ///< sittings of one observer
    int days_apart = 1;   ///< least distance of two sittings, in local calendar days
    int warm_ups = 3;     ///< main-like trials at the start whose answers are discarded
    int training = 4;     ///< practice trials
    int repetitions = 1;  ///< how often each pair is shown in one sitting
    int grey_ms = 500;    ///< grey before every pair
    int closed_ms = 300;  ///< input closed after onset
    int adapt_s = 60;     ///< grey before the warm-ups
    int break_every = 50; ///< trials between offered breaks; 0: none
    int gap_px = 32;      ///< grey between the two pictures
};

/// The file of the instructions, relative to the study folder; UTF-8, pages separated by lines of
/// `---`.
struct Instructions {
    std::string language = "en";
    std::string file = "instructions.md";
};

struct Study {
    std::string id;
    std::string title;
    std::string question; ///< what the observer is asked, on the pages and in the report
    std::uint64_t seed = 0;
    int width = 0, height = 0; ///< of each picture, pixels
    Surround surround;
    SessionPlan plan;
    Instructions instructions;
    std::vector<OwnMaterial> materials;
    std::vector<Scene> scenes;
    std::vector<Variant>
        variants; ///< empty: scenes are shown one way only, under the variant id ""
    std::vector<Condition> conditions;
};

/// The names a study file may use for things this module does not know.
struct KnownNames {
    std::vector<std::string> methods;
    std::vector<std::string> laws;
    std::vector<std::string> thickness_kinds;
    std::vector<std::string> materials; ///< the measured ones
};

/// Reads and validates a study from the text of its file.
/// Errors: the first offence as "<file_name>:<line>: <what> <value>, expected <remedy>": malformed
/// TOML,
///         unknown or missing keys, wrong types, values out of range, names twice, fewer than two
///         conditions.
Expected<Study>
parse_study(std::string_view text, std::string_view file_name, const KnownNames& known);

/// The study's own material of that name; null for a measured one.
const OwnMaterial* own_material(const Study& study, std::string_view name);

/// The variants to show: those of the file, or the single nameless one.
std::vector<Variant> shown_variants(const Study& study);

/// Path of a picture below the stimuli folder without its extension: "scene/variant/condition" or
/// "scene/condition".
std::string picture_path(const Picture& picture);

} // namespace protocols
