// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_lines.h
/// Lines that are no wires and were added after the start of the recording. Examples are links
/// between ends of wires, legs of hooks and slings. Also joints and lines of the start that were
/// removed since (docs/recording.md).
///
/// A chunk LINE names them from a frame on. A chunk LPUL after each later frame contains their
/// tensions, as WIRE and PULL do for wires (recording_wires.h).

#include "record/bytes.h"

#include <hawser/world.h>

#include <cstdint>
#include <span>
#include <vector>

namespace hawser::record {

class LineFollower {
  public:
    /// Start to record changes of lines. @param joints  Joints of the layout, in its order.
    LineFollower(const World& world, std::vector<InteractionId> joints);
    /// True if lines were added or removed since the last call.
    [[nodiscard]] bool changed(const World& world);
    /// Write the contents of a LINE chunk: lines other than wires. @param bodies  Bodies of a
    /// frame, ascending.
    void write_lines(ByteWriter& out, const World& world, std::span<const BodyId> bodies) const;
    /// Write the contents of an LPUL chunk: the tensions of lines other than wires in one frame.
    void write_pulls(ByteWriter& out, const World& world) const;

  private:
    std::vector<InteractionId> joints_, at_start_, all_;
    std::vector<InteractionId> lines_;
    std::vector<std::int32_t> removed_joints_;  ///< Numbers of the removed joints.
};

}  // namespace hawser::record
