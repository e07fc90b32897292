// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_lines.h
/// Wires of a recorded frame as segments with their tension, however their nodes have come and
/// gone.

#include <hawser/recording.h>
#include "draw/parted.h"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::draw {

/// An element of a wire, straight between its ends.
struct WirePiece {
    Vec3 from, to;         ///< World frame [m].
    float tension = 0.0F;  ///< [N]; of what has parted 0.
    bool parted = false;
};

struct WireLine {
    std::string_view name;
    double EA = 0.0;             ///< [N]; 0: not known.
    double breaking_load = 0.0;  ///< [N]; 0: not given.
    std::vector<WirePiece> segments;
};

/// Takes wires from frames of one recording, which has to outlive it.
class WireReader {
  public:
    explicit WireReader(const record::Recording& recording);
    /// Cables of the scene in its order, each as it is in the frame; then pieces that were cut off,
    /// and lines that are no wires and have come since the start.
    /// @param out  In the caller's memory.
    void read(const record::Frame& frame, std::vector<WireLine>& out) const;

  private:
    void read_cable(std::size_t index, const record::Frame& frame, WireLine& out) const;
    static void read_wire(const record::RecordedWire& wire, const record::Frame& frame,
                          const std::vector<float>& pulls, WireLine& out);

    const record::Recording& recording_;
    std::map<std::string, std::size_t, std::less<>> cables_;
    std::vector<PartedElement> parted_;
};

}  // namespace hawser::draw
