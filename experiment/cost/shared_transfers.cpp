// Computed for whoever asks first; what it took is kept, to charge the others with.
#include "experiment/cost/shared_transfers.h"

#include <algorithm>
#include <chrono>

namespace experiment::cost {

namespace transfer = renderer::transfer;
using Clock = std::chrono::steady_clock;

tl::expected<SharedTransfers::Field, std::string>
SharedTransfers::field(const transfer::TransferOptions& options) {
    if (const auto found = std::ranges::find(computed_, options, &Computed::options);
        found != computed_.end()) {
        saved_ += found->seconds;
        return found->field;
    }
    const auto start = Clock::now();
    auto field = transfer::compute_transfer_field(mesh_, medium_, mm_per_unit_, options);
    if (!field)
        return tl::unexpected(field.error());
    computed_.push_back({options,
                         std::make_shared<const transfer::TransferField>(std::move(*field)),
                         std::chrono::duration<double>(Clock::now() - start).count()});
    return computed_.back().field;
}

} // namespace experiment::cost
