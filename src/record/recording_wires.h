// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file recording_wires.h
/// What wires are made of from a frame on: written where nodes have come or gone since the start.
///
/// A chunk WIRE names the pieces of each wire by the places that their ends have in a frame, with
/// the points where they are held; a chunk PULL behind each frame from then on has their tensions,
/// −1 of what has parted.

#include "record/bytes.h"

#include <hawser/recording.h>
#include <hawser/world.h>

#include <span>
#include <vector>

namespace hawser::record {

/// Follows the elements of a world's wires.
class WireFollower {
  public:
    explicit WireFollower(const World& world);
    /// Whether other elements make them up than when it was asked last.
    [[nodiscard]] bool changed(const World& world);
    /// Contents of WIRE. @param bodies  Those of a frame, ascending.
    void put_wires(ByteWriter& out, const World& world, std::span<const BodyId> bodies) const;
    /// Contents of PULL.
    void put_pulls(ByteWriter& out, const World& world) const;

  private:
    std::vector<std::vector<InteractionId>> elements_;  ///< Of each wire, what there is.
};

/// Both ends of an element: the body of each by its place in a frame, and where it is held [m].
/// @param bodies  Those of a frame, ascending.
void put_piece(ByteWriter& out, const World& world, InteractionId element,
               std::span<const BodyId> bodies);
/// Its tension [N], −1: parted.
void put_pull(ByteWriter& out, const World& world, InteractionId element);

/// @param bodies  Of a frame, as numbers of the recording. @param pieces  How many there are.
/// @throws BadBytes
[[nodiscard]] std::vector<RecordedWire> get_wires(ByteReader& in,
                                                  std::span<const std::int32_t> bodies,
                                                  std::size_t& pieces);

}  // namespace hawser::record
