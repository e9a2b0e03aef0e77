// Pairs of pictures on their way from files to the graphics card.
#include "experiment/session/pair_cache.h"

#include "protocols/contract.h"
#include "protocols/study.h"

#include <fmt/format.h>

#include <chrono>

namespace experiment::session {

using renderer::gpu::Picture8;
using renderer::gpu::UploadedPicture;

namespace {

template <class T>
bool is_ready(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

} // namespace

protocols::PictureSize PairCache::size_of(const protocols::SceneId& scene) const {
    const auto found = sizes_.find(scene);
    EXPECTS(found != sizes_.end());
    return found->second;
}

std::future<PairCache::Decoded> PairCache::decode(const protocols::Trial& trial,
                                                  const protocols::ConditionId& condition) const {
    const protocols::Picture wanted{trial.scene, trial.variant, condition};
    return std::async(
        std::launch::async, [=, load = load_, size = size_of(trial.scene)]() -> Decoded {
            auto picture = load(wanted);
            if (picture && (picture->width != size.width || picture->height != size.height))
                return tl::unexpected(
                    fmt::format("{}: the picture has {} x {} pixels, expected {} x {}",
                                protocols::picture_path(wanted), picture->width, picture->height,
                                size.width, size.height));
            return picture;
        });
}

void PairCache::prepare(const PairView& pair) {
    if (slots_.contains(pair.number))
        return;
    std::erase_if(slots_, [&](const auto& slot) { return slot.first != got_last_; });
    slots_[pair.number] = {
        decode(pair.trial, pair.trial.left), decode(pair.trial, pair.trial.right),
        reference_ ? decode(pair.trial, *reference_) : std::future<Decoded>(), std::nullopt};
}

Expected<UploadedPair> PairCache::upload(Slot& slot) {
    const auto left = slot.left.get();
    const auto right = slot.right.get();
    if (!left)
        return tl::unexpected(left.error());
    if (!right)
        return tl::unexpected(right.error());
    UploadedPair pair{UploadedPicture(*left), UploadedPicture(*right), std::nullopt};
    if (slot.reference.valid()) {
        const auto reference = slot.reference.get();
        if (!reference)
            return tl::unexpected(reference.error());
        pair.reference.emplace(*reference);
    }
    return pair;
}

void PairCache::upload_what_is_ready() {
    for (auto& [number, slot] : slots_)
        if (!slot.uploaded && is_ready(slot.left) && is_ready(slot.right) &&
            (!slot.reference.valid() || is_ready(slot.reference)))
            slot.uploaded.emplace(upload(slot));
}

Expected<const UploadedPair*> PairCache::get(const PairView& pair) {
    prepare(pair);
    auto& slot = slots_.at(pair.number);
    if (!slot.uploaded)
        slot.uploaded.emplace(upload(slot));
    if (!*slot.uploaded)
        return tl::unexpected(slot.uploaded->error());
    got_last_ = pair.number;
    return &**slot.uploaded;
}

} // namespace experiment::session
