// Where chance comes from: every sitting has its own streams, one for each purpose.
#pragma once

#include "protocols/random.h"
#include "protocols/study.h"

namespace protocols {

enum class Purpose { Order, Sides, WarmUp, Training };

/// The first 16 bytes of SHA-256 over "study_id|study_seed|observer|session|purpose", numbers in
/// decimal, purposes named order, sides, warmup, training.  A draw added for one purpose leaves the
/// others alone.  `retry` counts the draws that had to be thrown away; when it is not 0, "|retry"
/// follows.
Seed stream_seed(
    const Study& study, const ObserverId& observer, int session, Purpose purpose, int retry = 0);

} // namespace protocols
