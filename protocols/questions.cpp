// All pairs, by counting them.
#include "protocols/questions.h"

namespace protocols {

std::vector<Question> all_questions(const Study& study) {
    const auto scenes = static_cast<int>(study.scenes.size());
    const auto variants = static_cast<int>(shown_variants(study).size());
    const auto conditions = static_cast<int>(study.conditions.size());
    const auto is_reference = [&](int condition) {
        return study.conditions[static_cast<std::size_t>(condition)].id == study.plan.reference;
    };
    std::vector<Question> questions;
    for (int scene = 0; scene < scenes; ++scene)
        for (int variant = 0; variant < variants; ++variant)
            for (int first = 0; first < conditions; ++first)
                for (int second = first + 1; second < conditions; ++second)
                    if (!is_reference(first) && !is_reference(second))
                        questions.push_back({scene, variant, first, second});
    return questions;
}

Trial trial(const Study& study, const Question& question, Side side_of_first) {
    const auto index = [](int i) { return static_cast<std::size_t>(i); };
    const auto& first = study.conditions[index(question.first)].id;
    const auto& second = study.conditions[index(question.second)].id;
    const auto& variant =
        study.variants.empty() ? VariantId{} : study.variants[index(question.variant)].id;
    const auto& scene = study.scenes[index(question.scene)].id;
    return side_of_first == Side::Left ? Trial{scene, variant, first, second}
                                       : Trial{scene, variant, second, first};
}

} // namespace protocols
