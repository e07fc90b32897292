// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interaction_graph.h
/// Draw bodies and their couplings at the positions of the bodies.

#include "draw/drawing.h"

#include <hawser/hawser.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::draw {

struct GraphNode {
    BodyId body{};
    std::string name;
    /// Position [m]; for drums the mean of their neighbours' positions.
    Vec3 position = Vec3::Zero();
    BodyKind kind = BodyKind::rigid;
    std::int32_t degree = 0;  ///< Number n_b of interactions and contact pairs of the body.
    std::int32_t part = -1;   ///< Part; −1: none.
    bool separator = false;   ///< True if the node is between parts.
};

struct GraphEdge {
    InteractionId interaction{};  ///< Invalid for bodies in contact.
    std::string name, kind;
    std::vector<std::int32_t> nodes;  ///< Moving nodes, 1 to 3.
    std::vector<Vec3> fixed;          ///< Attachment points on bodies that do not move [m].
    bool cut = false;                 ///< True if its nodes are in several parts.
};

struct InteractionGraph {
    std::vector<GraphNode> nodes;
    std::vector<GraphEdge> edges;
};

/// Return the graph of all moving bodies and of all couplings, with the contacts of the last step.
[[nodiscard]] InteractionGraph interaction_graph(const World& world);

struct GraphPicture {
    std::string title;
    std::vector<std::string> notes;
    bool parts = false;  ///< Colour by part, mark cuts and separators.
};

/// Draw the graph along the axis that shows most, with dense groups enlarged below.
[[nodiscard]] Drawing draw_graph(const InteractionGraph& graph, const GraphPicture& picture);

}  // namespace hawser::draw
