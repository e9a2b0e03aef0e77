// Computed for whoever asks first; what it took is kept, to charge the others with.
#include "experiment/cost/shared_transfers.h"

#include "renderer/stopwatch.h"

namespace experiment::cost {

namespace transfer = renderer::transfer;

namespace {

bool serves(const transfer::TransferOptions& has, transfer::TransferOptions asked) {
    const bool enough = has.bands >= asked.bands;
    asked.bands = has.bands;
    return enough && has == asked;
}

} // namespace

tl::expected<SharedTransfers::Field, std::string>
SharedTransfers::field(const transfer::TransferOptions& options) {
    for (const auto& [has, field, seconds] : computed_)
        if (serves(has, options)) {
            saved_ += seconds;
            return has.bands == options.bands ? field
                                              : std::make_shared<const transfer::TransferField>(
                                                    transfer::first_bands(*field, options.bands));
        }
    const renderer::Stopwatch watch;
    auto field = transfer::compute_transfer_field(mesh_, medium_, mm_per_unit_, options);
    if (!field)
        return tl::unexpected(field.error());
    computed_.push_back({options,
                         std::make_shared<const transfer::TransferField>(std::move(*field)),
                         watch.seconds()});
    return computed_.back().field;
}

} // namespace experiment::cost
