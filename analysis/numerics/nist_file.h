// NIST's Statistical Reference Datasets for analysis of variance, in NIST's own text form.
#pragma once

#include "analysis/numerics/decimal.h"
#include "protocols/expected.h"

#include <string>
#include <string_view>
#include <vector>

namespace analysis::numerics {

/// The values NIST certifies, correct to the 15 digits that stand in the file.
struct NistCertified {
    double df_between = 0;
    double ss_between = 0;
    double ms_between = 0;
    double f = 0;
    double df_within = 0;
    double ss_within = 0;
    double ms_within = 0;
    double r_squared = 0;
    double residual_sd = 0;
};

struct NistOneWay {
    std::string factor_name; ///< as the file heads its columns
    std::string response_name;
    std::vector<std::string> labels;          ///< of the groups, in order of first appearance
    std::vector<std::vector<Decimal>> groups; ///< as many as labels
    NistCertified certified;
};

/// Reads the whole text of a file; certified lines and data are found by their words.
/// Errors: a line naming `name`, the line number, what stands there and what was expected.
protocols::Expected<NistOneWay> read_nist_one_way(std::string_view text, std::string_view name);

} // namespace analysis::numerics
