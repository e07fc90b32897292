// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gltf_layout.h
/// What a glTF of a recording is made of, and where it stands in the file.

#include "draw/wire_lines.h"
#include "export/export.h"
#include "record/solids.h"

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::exporting {

using draw::WireLine;
using draw::WirePiece;
using draw::WireReader;

/// A body that has a node.
struct BodyNode {
    std::int32_t body = -1;
    std::vector<record::Triangles> surfaces;
    bool moves = false;              ///< Has channels of translation and rotation.
    bool turns = false;              ///< Has an orientation.
    bool comes = false;              ///< Is not there in all frames: has a channel of scale.
    std::size_t data = 0;            ///< Bytes from the start of the buffer: of the translation, …
    std::size_t turn = 0, size = 0;  ///< … the rotation, the scale.
    int node = -1;                   ///< In the glTF.
};

/// A wire with a node for each of its joints.
struct WireNodes {
    std::string name;
    std::size_t segments = 0;  ///< The most in any frame.
    bool joined = true;        ///< Each segment begins where the one before ends, in all frames.
    std::vector<float> peak;   ///< Largest tension of each segment [N].
    std::size_t data = 0;      ///< Of the translations of the first joint, others follow.
    int node = -1;             ///< Of the first joint.
    [[nodiscard]] std::size_t joints() const noexcept {
        return segments == 0 ? 0 : joined ? segments + 1 : 2 * segments;
    }
    /// Joint of an end (0, 1) of a segment.
    [[nodiscard]] std::size_t joint(std::size_t segment, std::size_t end) const noexcept {
        return joined ? segment + end : 2 * segment + end;
    }
};

/// A straight line between points of two bodies that have nodes, such as a rod.
struct Rod {
    std::size_t body[2];  ///< In Layout::bodies.
    Vec3 point[2];        ///< In their frames [m].
};

struct Layout {
    std::vector<BodyNode> bodies;
    std::vector<WireNodes> wires;
    std::vector<Rod> rods;
    double size = 1.0;          ///< Of the whole scene [m].
    float most_tension = 1.0F;  ///< Of all wires [N].
};

/// One pass over the frames.
[[nodiscard]] Layout lay_out(const record::Recording& recording, const Frames& frames);

/// Where the joints of a wire are in a frame. @param out  joints() places.
void place_joints(const WireNodes& wire, const WireLine& line, std::vector<Vec3>& out);

}  // namespace hawser::exporting
