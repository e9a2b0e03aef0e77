// Pairs times seconds.
#include "protocols/session_length.h"

#include "protocols/questions.h"

namespace protocols {

std::chrono::seconds estimated_length(const Study& study) {
    const auto& plan = study.plan;
    const auto main = static_cast<long>(all_questions(study).size()) * plan.repetitions;
    return (plan.training + plan.warm_ups + main) * planned_pair_time +
           std::chrono::seconds(plan.adapt_s);
}

} // namespace protocols
