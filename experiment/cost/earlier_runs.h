// Several cost reports as one, chosen from again.
#pragma once

#include "experiment/cost/cost_report.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace experiment::cost {

struct EarlierRun {
    std::string file; ///< for messages
    CostReport report;
};

/// The scenes of all runs, one after the other; subjects that differ are all named.
/// Errors: runs that cannot stand in one table, made by another program or renderer, timed or
/// measured otherwise; a scene under a light that two of them have.
/// EXPECTS at least one.
tl::expected<CostReport, std::string> together(const std::vector<EarlierRun>& runs);

/// That one of the runs measured `subject`, a study's title or a model's name, which was meant by
/// `name`: what is put together is kept under it.
/// Errors: none of them did, with what they did measure.
tl::expected<void, std::string> expect_subject(const std::vector<EarlierRun>& runs,
                                               const std::string& subject,
                                               const std::string& name);

/// Chooses anew in every scene and light.  What was measured of a choice stays with it.
void choose_again(CostReport& report, const Wish& wish);

} // namespace experiment::cost
