// Rows of analyses of variance as JSON, for every document that has such rows.
#pragma once

#include "analysis/anova/comparisons.h"
#include "analysis/anova/effect_size.h"
#include "analysis/anova/f_test.h"
#include "analysis/anova/sphericity.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace analysis::anova {

using Json = nlohmann::ordered_json;

/// Null when undefined, "inf" and "-inf" for what JSON has no number for.
Json json_number(double value);

/// `reason`, when there is one.
void put_reason(Json& row, const std::string& reason);

/// `SS`, `df`, `MS`; the last is null on no degrees of freedom.
Json variation_json(const Variation& part);

/// `F`, `p`, `log10_p` where p is below a double, and why they are undefined.
void put_test(Json& row, const FTest& test);

/// The test alone, with both degrees of freedom.
Json test_json(const FTest& test);

/// `SS_error`, `df_error`, `MS_error`.
void put_error(Json& row, const Variation& error);

/// `eta2_partial_interval` at one minus `level`; nothing when it is undefined.
void put_eta_interval(Json& row, const EtaInterval& interval, double level);

/// Mauchly's test, Greenhouse-Geisser's and Huynh-Feldt's p; or why there are none.
void put_sphericity(Json& row, const Sphericity& sphericity);

/// Pairs by names of what they compare.
Json range_pairs_json(const std::vector<RangePair>& pairs, const std::vector<std::string>& names);
Json t_pairs_json(const std::vector<TPair>& pairs, const std::vector<std::string>& names);
Json range_test_json(const RangeTest& test, const std::vector<std::string>& names);

} // namespace analysis::anova
