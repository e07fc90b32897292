// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gltf_layout.h
/// Collect the contents of a glTF from a recording, and their offsets in the file.

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

/// Body with a node.
struct BodyNode {
    std::int32_t body = -1;
    std::vector<record::Triangles> surfaces;
    bool moves = false;         ///< Has a translation channel.
    bool has_rotation = false;  ///< Has an orientation and a rotation channel.
    bool comes = false;         ///< Is absent in some frames: has a scale channel.
    std::size_t data = 0;       ///< Offset of the translation from the start of the buffer [bytes].
    std::size_t rotation_offset = 0,
                size = 0;  ///< Offsets of the rotation and of the scale [bytes].
    int node = -1;         ///< Node index in the glTF.
};

/// Wire with a node for each of its joints.
struct WireNodes {
    std::string name;
    std::size_t segments = 0;  ///< Largest number of segments in any frame.
    /// True if each segment begins at the end of the previous one in all frames.
    bool joined = true;
    std::vector<float> peak;  ///< Largest tension of each segment [N].
    /// Offset of the translations of the first joint [bytes]; the others follow.
    std::size_t data = 0;
    int node = -1;  ///< Node index of the first joint.
    [[nodiscard]] std::size_t joints() const noexcept {
        return segments == 0 ? 0 : joined ? segments + 1 : 2 * segments;
    }
    /// Return the joint at an end (0, 1) of a segment.
    [[nodiscard]] std::size_t joint(std::size_t segment, std::size_t end) const noexcept {
        return joined ? segment + end : 2 * segment + end;
    }
};

/// Straight line between points of two bodies with nodes, such as a rod.
struct Rod {
    std::size_t body[2];  ///< Indices in Layout::bodies.
    Vec3 point[2];        ///< Points in the frames of the bodies [m].
};

struct Layout {
    std::vector<BodyNode> bodies;
    std::vector<WireNodes> wires;
    std::vector<Rod> rods;
    double size = 1.0;         ///< Size of the whole scene [m].
    float max_tension = 1.0F;  ///< Largest tension of all wires [N].
};

/// Compute the layout of the glTF file in one pass over the frames: nodes, channels and offsets.
[[nodiscard]] Layout compute_layout(const record::Recording& recording, const Frames& frames);

/// Compute the positions of a wire's joints in a frame. @param out  joints() entries.
void joint_positions(const WireNodes& wire, const WireLine& line, std::vector<Vec3>& out);

}  // namespace hawser::exporting
