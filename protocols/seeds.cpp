// Names of streams, digested into seeds.
#include "protocols/seeds.h"

#include "protocols/digest.h"

#include <fmt/format.h>

namespace protocols {

namespace {

std::string_view name(Purpose purpose) {
    switch (purpose) {
    case Purpose::Order:
        return "order";
    case Purpose::Sides:
        return "sides";
    case Purpose::WarmUp:
        return "warmup";
    case Purpose::Training:
        return "training";
    }
    EXPECTS(!"a purpose that has a name");
    return {};
}

} // namespace

Seed stream_seed(
    const Study& study, const ObserverId& observer, int session, Purpose purpose, int retry) {
    auto text =
        fmt::format("{}|{}|{}|{}|{}", study.id, study.seed, observer.value, session, name(purpose));
    if (retry > 0)
        text += fmt::format("|{}", retry);
    const auto digest = sha256(text);
    Seed seed;
    std::copy_n(digest.begin(), seed.size(), seed.begin());
    return seed;
}

} // namespace protocols
