// The words of a paired-comparison experiment, as types.  Conventions: docs/conventions.md#votes
#pragma once

#include <chrono>
#include <compare>
#include <string>

namespace protocols {

/// A name given by the study file.  `Tag` keeps the names of different things apart.
template <class Tag>
struct Name {
    std::string value;
    auto operator<=>(const Name&) const = default;
};

using ConditionId =
    Name<struct ConditionTag>;         ///< what is compared: a rendering method with its dials
using SceneId = Name<struct SceneTag>; ///< what is shown: a model
using VariantId =
    Name<struct VariantTag>; ///< how it is shown: a light direction; "" when a study has none
using ObserverId = Name<struct ObserverTag>; ///< a pseudonym, never a name

enum class Side { Left, Right };

/// An answer.  `Tie` exists where the study offers "not sure"; a forced choice never has it.
enum class Choice { Left, Right, Tie };

enum class Phase { Training, WarmUp, Main };

/// One picture: what a stimulus file shows.
struct Picture {
    SceneId scene;
    VariantId variant;
    ConditionId condition;
    auto operator<=>(const Picture&) const = default;
};

/// One question: two pictures of the same scene and variant, `left` on the observer's left.
struct Trial {
    SceneId scene;
    VariantId variant;
    ConditionId left;
    ConditionId right;
    bool operator==(const Trial&) const = default;
};

/// One answer to one trial.
struct Vote {
    Trial trial;
    Choice chosen{};
    std::chrono::milliseconds response_time{}; ///< from the pictures' onset to the key
};

} // namespace protocols
