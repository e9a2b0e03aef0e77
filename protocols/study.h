// A study: what is compared, on what, and how people are asked.
//
// The file's form is documented in docs/study-file.md.  This room knows how a study is asked; what
// its rendering dials mean is the renderer's business, so the names they may take are handed in.
#pragma once

#include "protocols/display.h"
#include "protocols/expected.h"
#include "protocols/key_map.h"
#include "protocols/questionnaire.h"
#include "protocols/vocabulary.h"

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace protocols {

/// A setting of a rendering method, as the study file writes it.
using DialValue = std::variant<std::int64_t, double, std::string>;
using Dials = std::map<std::string, DialValue, std::less<>>;

/// What is wrong with a dial: "bands" and "is 9, expected a whole number from 1 to 6".
struct DialProblem {
    std::string dial;
    std::string what;
};

/// The four terms of the shading model, in the place of those that the material gives; channel by
/// channel.
struct ShadingCoefficients {
    std::array<double, 3> ambient{}, diffuse{}, specular{}, scatter{};
    bool operator==(const ShadingCoefficients&) const = default;
};

/// How a condition's pictures are rendered.  What may stand here is checked by `KnownNames` when
/// the file is read.
struct Rendering {
    std::string method;
    Dials dials; ///< every dial the method has, those that the file leaves out at their presets
    std::map<std::string, ShadingCoefficients> k; ///< by scene; the material's where there is none
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

struct PictureSize {
    int width = 0, height = 0; ///< pixels
    bool operator==(const PictureSize&) const = default;
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
        {};                      ///< of the model's coordinates; instead of `diameter_mm`
    std::string material;        ///< one of the study's own, or a measured one, by name
    bool may_have_holes = false; ///< inside is then where the model winds more than half around
    /// Of its pictures, where they are all made elsewhere; otherwise the study's.
    std::optional<PictureSize> size = {};
    int line = 0;
};

/// A light of a variant, in view axes: x right, y up, z toward the viewer.
struct Light {
    /// Far away, with the unit vector from the surface toward it; or near, at a place in mm from
    /// the centre of the scene.
    enum class Kind { Far, Near } kind = Kind::Far;
    std::array<double, 3> to_light = {0, 0, 1};
    std::array<double, 3> position_mm = {0, 0, 0};
    double reference_mm = 100; ///< where a near light has its intensity
    std::array<double, 3> intensity = {1, 1, 1};
    bool operator==(const Light&) const = default;
};

/// How a scene is lit.
struct Variant {
    VariantId id;
    std::string label;
    std::vector<Light> lights{{}};
    int line = 0;
};

/// What an answer can be.
enum class Response {
    ForcedChoice, ///< left or right
    WithNotSure,  ///< left, right or "not sure", kept as a tie
    SevenGrades   ///< BT.500's comparison scale: the right one is much worse (-3) ... much better
                  ///< (+3)
};

/// How the pictures of a pair come to the screen.  Where they come one after the other, the first
/// is the one that the plan calls left.
enum class Presentation { SideBySide, Sequential, Flip };

/// What becomes of a pair whose `deadline_s` has passed without an answer.
enum class AfterDeadline {
    Again,  ///< it comes once more, later; what is not answered then stays unanswered
    Missing ///< it stays unanswered
};

using ConditionPair = std::array<ConditionId, 2>;

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
    int view_ms = 0; ///< how long a pair, or each of its pictures in turn, is seen; 0: no limit
    int between_ms = 500;     ///< grey between two pictures that come in turn
    int deadline_s = 0;       ///< for an answer, from the onset; 0: none
    int longest_minutes = 30; ///< of a sitting, then the experimenter is asked; 0: no limit
    AfterDeadline after_deadline = AfterDeadline::Again;
    Response response = Response::ForcedChoice;
    Presentation presentation = Presentation::SideBySide;
    /// The condition that is shown beside every pair and never compared.
    std::optional<ConditionId> reference;
    /// Pairs thought to differ most and least, for practice: each is in the training, where that
    /// has room for it.
    std::optional<ConditionPair> easy_pair, hard_pair;
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
    int width = 0, height = 0; ///< of each picture, pixels, where its scene says nothing else
    Surround surround;
    Display display;
    Room room;
    SessionPlan plan;
    KeyMap keys = standard_keys();
    Instructions instructions;
    Panel panel;
    std::vector<OwnMaterial> materials;
    std::vector<Scene> scenes;
    std::vector<Variant>
        variants; ///< empty: scenes are shown one way only, under the variant id ""
    std::vector<Condition> conditions;
};

/// What a study file may name that this module does not know.
struct KnownNames {
    std::vector<std::string> methods;
    std::vector<std::string> materials; ///< the measured ones

    /// A word that people have to read in the label of a condition of this method, by method.
    std::map<std::string, std::string> caveats = {};

    /// The dials of a method with presets for those that are not given, or what is wrong with one.
    std::function<tl::expected<Dials, DialProblem>(const std::string& method, const Dials& given)>
        complete;
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

/// How large the pictures of each scene are.
std::map<SceneId, PictureSize> picture_sizes(const Study& study);

/// Path of a picture below the stimuli folder without its extension: "scene/variant/condition" or
/// "scene/condition".
std::string picture_path(const Picture& picture);

} // namespace protocols
