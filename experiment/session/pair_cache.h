// Pairs of pictures on their way from files to the graphics card.
#pragma once

#include "experiment/session/views.h"
#include "protocols/expected.h"
#include "protocols/study.h"
#include "renderer/gpu/pixel_canvas.h"

#include <functional>
#include <future>
#include <map>
#include <optional>

namespace experiment::session {

using protocols::Expected;

/// Decodes one picture to the code values the display is sent.  Called on other threads.
using LoadPicture = std::function<Expected<renderer::gpu::Picture8>(const protocols::Picture&)>;

struct UploadedPair {
    renderer::gpu::UploadedPicture left;
    renderer::gpu::UploadedPicture right;
    std::optional<renderer::gpu::UploadedPicture> reference;
};

/// Holds the pair on the screen and the next one.
class PairCache {
  public:
    using Sizes = std::map<protocols::SceneId, protocols::PictureSize>;

    PairCache(LoadPicture load, Sizes sizes, std::optional<protocols::ConditionId> reference = {})
        : load_(std::move(load)), sizes_(std::move(sizes)), reference_(std::move(reference)) {}

    /// Begins to decode a pair, and forgets the others but the one got last.
    void prepare(const PairView& pair);

    /// Uploads what has been decoded meanwhile; never waits for the rest.
    void upload_what_is_ready();

    /// The pair, now.  EXPECTS a scene that has a size.
    /// Errors: those of `load`; a picture of another size than its scene's.
    Expected<const UploadedPair*> get(const PairView& pair);

  private:
    using Decoded = Expected<renderer::gpu::Picture8>;

    struct Slot {
        std::future<Decoded> left;
        std::future<Decoded> right;
        std::future<Decoded> reference; ///< invalid where there is none
        std::optional<Expected<UploadedPair>> uploaded;
    };

    protocols::PictureSize size_of(const protocols::SceneId& scene) const;
    std::future<Decoded> decode(const protocols::Trial& trial,
                                const protocols::ConditionId& condition) const;
    static Expected<UploadedPair> upload(Slot& slot);

    LoadPicture load_;
    Sizes sizes_;
    std::optional<protocols::ConditionId> reference_;
    int got_last_ = 0;
    std::map<int, Slot> slots_; ///< by number of the trial
};

} // namespace experiment::session
