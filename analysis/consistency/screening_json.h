// The screening part of the findings as JSON text.
#pragma once

#include "analysis/consistency/screening.h"

#include <span>
#include <string>

namespace analysis::consistency {

/// The array `screening` of the findings, one object per observer; null for what is undefined.
std::string screening_json(std::span<const ObserverScreening> observers);

} // namespace analysis::consistency
