// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame_writer.h
/// Fill a frame with the present state of a world (docs/live.md, "Frames").
///
/// Poses come from the world's own arrays (hawser/state.h), tensions and forces from each element.
/// Positions are differences from an origin near the scene, computed in double precision. Single
/// precision is enough for the differences: 0.06 mm at 1 km.

#include "live/frame_plan.h"
#include "live/frame_swap.h"
#include "live/protocol.h"

#include <hawser/world.h>

#include <span>
#include <vector>

namespace hawser::live {

/// An output whose value in a frame differs from that of the world: displays of an exercise.
struct ShownOutput {
    std::size_t output = 0;  ///< Index in FramePlan::outputs.
    double value = 0.0;      ///< SI units.
};

/// Data of a frame that the world does not have.
struct FrameNotes {
    std::uint32_t epoch = 0, number = 0, skipped = 0;
    std::uint16_t flags = 0;
    double deadline_ms = 0.0, late_ms = 0.0;
    std::span<const ShownOutput> shown{};
};

class FrameWriter {
  public:
    /// Write a frame to `out`, whose capacity is reused. @param world  World of the plan.
    void write(const World& world, const FramePlan& plan, const Vec3& origin,
               const FrameNotes& notes, Bytes& out);
    /// Return the time that the last frame took to write [s].
    [[nodiscard]] double seconds() const noexcept { return seconds_; }

  private:
    void add_wires(const World& world, const FramePlan& plan, const Vec3& origin);
    void add_wire(const World& world, const WireSource& wire, const StateView& state,
                  const Vec3& origin);
    void add_contacts(const World& world, const Vec3& origin, FrameHeader& head);
    void add_stats(const World& world, const FrameNotes& notes, float* to, FrameHeader& head);

    std::vector<std::uint32_t> counts_;
    std::vector<float> points_, tensions_, forces_;
    std::vector<ContactView> contacts_;
    double seconds_ = 0.0, energy_ = 0.0;
    std::int64_t energy_of_ = -1;  ///< Step of the last energy.
};

}  // namespace hawser::live
