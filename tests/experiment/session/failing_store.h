// A store whose disk fails at some write, as a full disk does, or a power cut.
#pragma once

#include "experiment/store/vote_store.h"

#include <string>

namespace tests {

using namespace experiment;

/// Passes everything on to another store until its `good`-th write was done; then none succeeds.
class FailingStore final : public store::VoteStore {
  public:
    template <class T>
    using Expected = protocols::Expected<T>;

    FailingStore(store::VoteStore& within, int good) : within_(within), left_(good) {}

    /// Writes that were done.
    int writes() const { return writes_; }

    Expected<void> add_observer(const protocols::ObserverId& id, const std::string& utc) override {
        return if_good([&] { return within_.add_observer(id, utc); });
    }

    Expected<void> take_place(const protocols::ObserverId& id,
                              store::ObserverKind kind,
                              const std::string& utc) override {
        return if_good([&] { return within_.take_place(id, kind, utc); });
    }

    Expected<std::optional<protocols::ObserverId>>
    partner(const protocols::ObserverId& observer, store::ObserverKind kind) const override {
        return within_.partner(observer, kind);
    }

    Expected<void> begin_sitting(const store::SittingStart& start,
                                 std::span<const protocols::PlannedTrial> plan) override {
        return if_good([&] { return within_.begin_sitting(start, plan); });
    }

    Expected<void> append_shown(const store::SittingKey& key, const store::Shown& shown) override {
        return if_good([&] { return within_.append_shown(key, shown); });
    }

    Expected<void> append_vote(const store::SittingKey& key, const store::MainVote& vote) override {
        return if_good([&] { return within_.append_vote(key, vote); });
    }

    Expected<void> append_event(const store::SittingKey& key,
                                const store::SittingEvent& event) override {
        return if_good([&] { return within_.append_event(key, event); });
    }

    Expected<void> append_frames(const store::SittingKey& key,
                                 const store::FramesSeen& seen) override {
        return if_good([&] { return within_.append_frames(key, seen); });
    }

    Expected<void> append_answers(const protocols::ObserverId& observer,
                                  std::span<const store::Answer> answers) override {
        return if_good([&] { return within_.append_answers(observer, answers); });
    }

    Expected<store::Tombstone> withdraw(const protocols::ObserverId& observer,
                                        const std::string& utc,
                                        const std::string& reason) override {
        return within_.withdraw(observer, utc, reason);
    }

    Expected<void> finish_sitting(const store::SittingKey& key, const std::string& utc) override {
        return if_good([&] { return within_.finish_sitting(key, utc); });
    }

    Expected<store::StudyIdentity> study() const override { return within_.study(); }

    Expected<std::vector<protocols::ObserverId>> observers() const override {
        return within_.observers();
    }

    Expected<std::vector<store::SittingSummary>> sittings() const override {
        return within_.sittings();
    }

    Expected<std::optional<store::Sitting>> sitting(const store::SittingKey& key) const override {
        return within_.sitting(key);
    }

    Expected<std::vector<store::VoteRow>> votes() const override { return within_.votes(); }

    Expected<std::vector<store::Answer>>
    answers(const protocols::ObserverId& observer) const override {
        return within_.answers(observer);
    }

    Expected<std::vector<store::Tombstone>> tombstones() const override {
        return within_.tombstones();
    }

    Expected<std::vector<std::string>> verify() const override { return within_.verify(); }

  private:
    template <class Write>
    Expected<void> if_good(Write write) {
        if (left_-- <= 0)
            return tl::unexpected(std::string("the disk is full"));
        ++writes_;
        return write();
    }

    store::VoteStore& within_;
    int left_;
    int writes_ = 0;
};

} // namespace tests
