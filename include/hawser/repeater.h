// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeater.h
/// A recorded run again: the changes of a recording, entered into a world step by step.

#include <hawser/recording.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace hawser::record {

/// Does to a world again what was done to the recorded one, and lets its steps leave out what those
/// of the recording left out. The world is that of the scene in the recording, in the state of its
/// snapshot, without systems: what those of the recorded world did is in the recording. Adds a
/// system of its own where there are loads.
class Repeater {
  public:
    /// @param recording  Has to outlive it.
    explicit Repeater(const Recording& recording) : recording_(recording) {}
    /// Before each step. @throws std::runtime_error where the recording says what makes no sense,
    ///                            DefError where the world refuses a change.
    void before_step(World& world);
    /// Entries of Recording::takes that have been entered.
    [[nodiscard]] std::size_t take() const noexcept { return take_; }

  private:
    class Loader;
    void repeat_loads(World& world);
    void drop_loader(std::span<const std::byte> change, World& world);
    void enter_take(World& world);
    [[nodiscard]] std::size_t end_of(std::size_t all, std::size_t RecordedTake::* before) const;

    const Recording& recording_;
    std::size_t input_ = 0, change_ = 0, cut_ = 0, load_ = 0;  ///< The next ones.
    std::size_t take_ = 0;                                     ///< Those entered.
    Loader* loader_ = nullptr;                                 ///< A system of the world.
};

}  // namespace hawser::record
