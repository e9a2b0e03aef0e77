// The exact law of agreement when every answer is a coin's.  [KendallBabingtonSmith1940]
#pragma once

#include <cstdint>
#include <optional>

namespace analysis::consistency {

/// P(Sigma >= sigma) for `judges` who each toss a coin on every pair of `conditions`; Sigma is the
/// number of agreeing pairs of judges, over all pairs of conditions.  By convolution over the
/// pairs, terms of one sign: relative error below 1e-14 down to 1e-300.
/// Nothing where that takes more than about 2e7 multiplications.
/// Errors: EXPECTS at least 2 judges and 2 conditions.
std::optional<double>
agreement_p_exact(std::int64_t sigma, std::int64_t judges, std::int64_t conditions);

} // namespace analysis::consistency
