// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file interaction_graph.h
/// Bodies and what couples them, drawn where the bodies are.

#include "draw/drawing.h"

#include <hawser/hawser.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::draw {

struct GraphNode {
    BodyId body{};
    std::string name;
    Vec3 position = Vec3::Zero();  ///< Drums have none: the mean of their neighbours' [m].
    BodyKind kind = BodyKind::rigid;
    std::int32_t degree = 0;  ///< Interactions and contact pairs on it: n_b.
    std::int32_t part = -1;   ///< −1: in none.
    bool separator = false;   ///< Between parts.
};

struct GraphEdge {
    InteractionId interaction{};  ///< Invalid: bodies that touch.
    std::string name, kind;
    std::vector<std::int32_t> nodes;  ///< That move, 1-3.
    std::vector<Vec3> fixed;          ///< Where it holds to what does not move [m].
    bool cut = false;                 ///< Nodes in several parts.
};

struct InteractionGraph {
    std::vector<GraphNode> nodes;
    std::vector<GraphEdge> edges;
};

/// All bodies that move and all that acts on them, contacts of the last step included.
[[nodiscard]] InteractionGraph interaction_graph(const World& world);

struct GraphPicture {
    std::string title;
    std::vector<std::string> notes;
    bool parts = false;  ///< Colour by part, mark cuts and separators.
};

/// Seen along the axis that shows most, with the crowded places enlarged below.
[[nodiscard]] Drawing draw_graph(const InteractionGraph& graph, const GraphPicture& picture);

}  // namespace hawser::draw
