// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_wires.h
/// Pieces of wires from a frame on, written if nodes were added or removed since the start.
///
/// A chunk WIRE lists the pieces of each wire by the indices of their end bodies in a frame, with
/// the points of attachment. A chunk PULL after each later frame contains their tensions, −1 for a
/// broken piece.

#include "record/bytes.h"

#include <hawser/recording.h>
#include <hawser/world.h>

#include <span>
#include <vector>

namespace hawser::record {

/// Detects changes of the elements of a world's wires.
class WireFollower {
  public:
    explicit WireFollower(const World& world);
    /// True if the elements of the wires changed since the last call.
    [[nodiscard]] bool changed(const World& world);
    /// Write the contents of a WIRE chunk: the elements of all wires. @param bodies  Bodies of a
    /// frame, ascending.
    void put_wires(ByteWriter& out, const World& world, std::span<const BodyId> bodies) const;
    /// Write the contents of a PULL chunk: the tensions of all wire elements in one frame.
    void write_pulls(ByteWriter& out, const World& world) const;

  private:
    std::vector<std::vector<InteractionId>>
        elements_;  ///< Elements of each wire at the last call of changed().
};

/// Write both ends of an element: the index of each body in a frame and the point of attachment
/// [m]. @param bodies  Bodies of a frame, ascending.
void write_piece(ByteWriter& out, const World& world, InteractionId element,
                 std::span<const BodyId> bodies);
/// Write the tension of an element [N]; −1: broken.
void write_pull(ByteWriter& out, const World& world, InteractionId element);

/// Read the wires of a WIRE or LINE chunk. @param bodies  Bodies of a frame, as indices of the
/// recording. @param pieces  Set to the number of elements. @throws BadBytes
[[nodiscard]] std::vector<RecordedWire> get_wires(ByteReader& in,
                                                  std::span<const std::int32_t> bodies,
                                                  std::size_t& pieces);

}  // namespace hawser::record
