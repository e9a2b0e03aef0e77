// What ITU-R BT.500 asks for, line by line, and what of it a study keeps.  [BT500-15]
#pragma once

#include "protocols/study.h"

#include <optional>
#include <string>
#include <vector>

namespace protocols {

enum class Verdict {
    Met,
    NotMet,
    OnlyTheExperimenterKnows ///< no program can see it, and nobody has recorded it
};

struct ConformityLine {
    std::string asked; ///< what the Recommendation wants, in few words
    Verdict verdict{};
    std::string because; ///< the study's own figure, or what is to be done
};

/// What is known beside the study file; empty where nobody has sat yet.
struct PanelSoFar {
    std::optional<int> screened; ///< people who passed the screening and finished
};

/// Every line, in the order of the Recommendation: conditions of viewing, display, observers,
/// instructions, session, presentation.
std::vector<ConformityLine> bt500_conformity(const Study& study, const PanelSoFar& panel = {});

/// "met", "NOT MET", "only the experimenter can know"
std::string words_of(Verdict verdict);

} // namespace protocols
