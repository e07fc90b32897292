// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_lines.h
/// Lines that are no wires and have come since the recording began: links between ends of wires,
/// legs of hooks, slings; and joints and lines of the start that have gone (docs/recording.md).
///
/// A chunk LINE names them from a frame on, a chunk LPUL behind each frame from then on has their
/// tensions, as WIRE and PULL do of wires (recording_wires.h).

#include "record/bytes.h"

#include <hawser/world.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::record {

class LineFollower {
  public:
    /// @param joints  Of the layout, in its order.
    LineFollower(const World& world, std::vector<InteractionId> joints);
    /// Whether other lines have come or gone than when it was asked last.
    [[nodiscard]] bool changed(const World& world);
    /// Contents of LINE. @param bodies  Those of a frame, ascending.
    void put_lines(ByteWriter& out, const World& world, std::span<const BodyId> bodies) const;
    /// Contents of LPUL.
    void put_pulls(ByteWriter& out, const World& world) const;

  private:
    std::vector<InteractionId> joints_, at_start_, all_;
    std::vector<InteractionId> lines_;
    std::vector<std::int32_t> gone_;  ///< Numbers of joints.
};

}  // namespace hawser::record
