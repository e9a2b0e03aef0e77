// What is asked about an observer before the first sitting, and whether the answers pass.
#pragma once

#include "protocols/expected.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace protocols {

/// One question about the observer.  Nothing that names a person belongs here.
struct ObserverQuestion {
    enum class Kind { Choice, Number };
    std::string id;
    std::string ask; ///< as the experimenter reads it
    Kind kind = Kind::Choice;
    std::vector<std::string> choices;   ///< of Choice
    double least = 0, greatest = 0;     ///< of Number
    std::vector<std::string> passes;    ///< Choice: answers that pass the screening; empty: all
    std::optional<double> passes_from;  ///< Number: the least that passes
    std::optional<double> passes_up_to; ///< Number: the greatest that passes
    int line = 0;
};

/// Who takes part.
struct Panel {
    int required = 15;                       ///< screened observers; BT.500: fewer are informal
    bool consent = false;                    ///< wanted on record before the first sitting
    std::vector<ObserverQuestion> questions; ///< to be answered before the first sitting
};

/// Age band, sex, glasses, acuity, Ishihara plates, expertise: protocol of BT.500.  Passing:
/// decimal acuity 0.67 (20/30) or more, at most 2 errors on the 12 screening plates, no part in
/// making what is compared.
std::vector<ObserverQuestion> standard_questions();

/// The answer in its one spelling ("0.8", not "0.80").
/// Errors: "<id>: <answer>, expected <what>".
Expected<std::string> checked_answer(const ObserverQuestion& question, const std::string& answer);

/// Whether a checked answer passes the screening.
bool passes(const ObserverQuestion& question, const std::string& answer);

/// "passed", or "failed: acuity, ..." by the ids of the questions.  EXPECTS an answer to each.
std::string screening(const std::vector<ObserverQuestion>& questions,
                      const std::map<std::string, std::string>& answers);

} // namespace protocols
