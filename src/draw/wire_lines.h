// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_lines.h
/// Read the wires of a recorded frame as segments with tensions, for any changes of their nodes.

#include <hawser/recording.h>
#include "draw/parted.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::draw {

/// Element of a wire, straight between its ends.
struct WirePiece {
    Vec3 from, to;         ///< Ends in the world frame [m].
    float tension = 0.0F;  ///< Tension [N]; 0 if broken.
    bool parted = false;
};

struct WireLine {
    std::string_view name;
    double EA = 0.0;             ///< Axial stiffness [N]; 0: unknown.
    double breaking_load = 0.0;  ///< Breaking load [N]; 0: undefined.
    std::vector<WirePiece> segments;
};

/// Reader of wires from frames of one recording, which must outlive it.
class WireReader {
  public:
    explicit WireReader(const record::Recording& recording);
    /// Read the cables of the scene in its order, in their state in the frame. Then pieces that
    /// were cut off follow, and lines other than wires that were added after the start.
    /// @param out  Buffer of the caller.
    void read(const record::Frame& frame, std::vector<WireLine>& out) const;

  private:
    void read_cable(std::size_t index, const record::Frame& frame, WireLine& out) const;
    static void read_wire(const record::RecordedWire& wire, const record::Frame& frame,
                          const std::vector<float>& pulls, WireLine& out);

    const record::Recording& recording_;
    std::map<std::string, std::size_t, std::less<>> cables_;
    std::vector<BrokenElement> broken_;
};

}  // namespace hawser::draw
