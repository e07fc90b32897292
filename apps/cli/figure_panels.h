// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figure_panels.h
/// Panels of the paper's Figs. 1 and 2, each with its data.

#include "draw/drawing.h"
#include "draw/figures/interaction_graph.h"
#include "figure_matrices.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::cli {

struct Panel {
    std::string name;  ///< Name of its files.
    draw::Drawing drawing;
    nlohmann::ordered_json data;
};

/// Return a panel of a matrix without fill.
[[nodiscard]] Panel matrix_panel(const std::string& name, const std::string& title,
                                 const OrderedMatrix& matrix);
/// Return a panel of a matrix with the fill of its factor, sizes, work and time. Without an order,
/// the panel shows the reason.
[[nodiscard]] Panel fill_panel(const std::string& name, const std::string& title,
                               const OrderedMatrix& matrix);
/// Return a panel of a graph. @param parts  Colour by part, mark cuts and separators.
[[nodiscard]] Panel graph_panel(const std::string& name, const std::string& title,
                                const std::vector<std::string>& notes,
                                const draw::InteractionGraph& graph, bool parts);

}  // namespace hawser::cli
