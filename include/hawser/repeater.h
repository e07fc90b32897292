// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file repeater.h
/// Replay of a recording: the class Repeater applies the recorded changes to a world, step by step.
///
/// ```cpp
/// hawser::record::Repeater repeater(recording);
/// while (more steps) {
///     repeater.before_step(world);      // world: scene of the recording in its start state
///     world.step();
/// }
/// ```

#include <hawser/recording.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace hawser::record {

/// Applies the changes of a recorded run to a world, and lets its steps omit the work that the
/// recorded steps omitted for their budget. The world is built from the scene of the recording
/// without systems, and has the state Recording::snapshot. Instead of systems, the recording
/// contains their inputs, edits and loads, and the definition of the sea on wires. To apply loads,
/// Repeater adds two systems to the world.
class Repeater {
  public:
    /// Create a repeater at the start of a recording.
    /// @param recording  Recording; it must outlive the repeater.
    explicit Repeater(const Recording& recording) : recording_(recording) {}
    /// Apply the changes before a step. Call it before each step.
    /// @throws std::runtime_error if the recording is inconsistent
    /// @throws DefError if the world rejects a change
    void before_step(World& world);
    /// Return the number of branches (Recording::takes) that the replay has entered.
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
