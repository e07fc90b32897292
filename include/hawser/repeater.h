// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeater.h
/// Replay of a recording: applies its changes to a world step by step.

#include <hawser/recording.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace hawser::record {

/// Applies the changes of a recorded run to a world, and makes its steps leave out the same work.
/// The world is that of the recording's scene, in the state of its snapshot, without systems. The
/// recording contains the effects of the recorded systems, and the definition of the sea on wires.
/// If there are loads, Repeater adds two systems of its own.
class Repeater {
  public:
    /// Create a repeater.
    /// @param recording  Must outlive it.
    explicit Repeater(const Recording& recording) : recording_(recording) {}
    /// Apply the changes before a step. Call it before each step.
    /// @throws std::runtime_error if the recording is inconsistent
    /// @throws DefError if the world rejects a change
    void before_step(World& world);
    /// Return the number of entries of Recording::takes that have been applied.
    [[nodiscard]] std::size_t take() const noexcept { return take_; }

  private:
    struct Load;
    class Water;
    class Loader;
    void read_sea(ByteReader& in);
    void read_load(ByteReader& in, const World& world, Load& load) const;
    void repeat_loads(World& world);
    void drop_loader(std::span<const std::byte> change, World& world);
    void enter_branch(World& world);
    [[nodiscard]] std::size_t end_of(std::size_t all, std::size_t RecordedTake::* before) const;

    const Recording& recording_;
    std::size_t input_ = 0, change_ = 0, cut_ = 0, load_ = 0;  ///< Indices of the next entries.
    std::size_t take_ = 0;                                     ///< Number of applied entries.
    Water* water_ = nullptr;                                   ///< System of the world.
    System* loader_ = nullptr;                                 ///< System of the world, behind it.
    std::shared_ptr<LineLoads> lines_;                         ///< Loads of the last sea, …
    std::int32_t sea_ = -1;                                    ///< … Recording::seas[sea_].
};

}  // namespace hawser::record
