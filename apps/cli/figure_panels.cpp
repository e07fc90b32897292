// SPDX-License-Identifier: Apache-2.0
#include "figure_panels.h"

#include "draw/figures/matrix.h"
#include "draw/figures/panel.h"

#include <fmt/format.h>

#include <array>

namespace hawser::cli {
namespace {

using nlohmann::ordered_json;

/// Format 12345 as 12,345.
std::string with_thousands(std::int64_t value) {
    std::string digits = std::to_string(value);
    for (auto k = static_cast<std::ptrdiff_t>(digits.size()) - 3; k > 0; k -= 3)
        digits.insert(static_cast<std::size_t>(k), ",");
    return digits;
}

double fill_ratio(const OrderedMatrix& m) {
    return m.counts.nnz > 0
               ? static_cast<double>(m.counts.factor_nnz) / static_cast<double>(m.counts.nnz)
               : 0.0;
}

std::string size_note(const OrderedMatrix& m) {
    return fmt::format("n = {}   nnz(K) = {} (lower triangle)   {} bodies and interactions",
                       with_thousands(m.counts.scalars), with_thousands(m.counts.nnz),
                       with_thousands(m.counts.nodes));
}

ordered_json matrix_data(const OrderedMatrix& m) {
    ordered_json d;
    d["ordering"] = name_of(m.ordering);
    d["n"] = m.counts.scalars;
    d["nodes"] = m.counts.nodes;
    d["nnz"] = m.counts.nnz;
    d["permutation"] = m.order;
    d["node_size"] = m.graph->size;
    d["node_sign"] = m.graph->sign;
    d["node_origin"] = m.graph->origin;
    d["node_part"] = m.graph->part;
    ordered_json edges = ordered_json::array();
    for (const BlockEdge& e : draw::pattern_of(*m.graph).edges) edges.push_back({e.row, e.column});
    d["edges"] = std::move(edges);
    return d;
}

}  // namespace

Panel matrix_panel(const std::string& name, const std::string& title, const OrderedMatrix& m) {
    return {name,
            draw::draw_matrix(*m.graph, m.order, m.factor,
                              {.title = title, .notes = {size_note(m)}, .fill = false}),
            matrix_data(m)};
}

Panel fill_panel(const std::string& name, const std::string& title, const OrderedMatrix& m) {
    if (!m.missing.empty()) {
        draw::Drawing d = draw::make_panel(draw::kFigureWidth, draw::kFigureHeight, title,
                                           {"not drawn: " + m.missing});
        d.box(draw::panel_square(), draw::kNoColor, draw::kSoft);
        return {name, std::move(d), {{"ordering", name_of(m.ordering)}, {"missing", m.missing}}};
    }
    const bool timed = m.samples > 0;
    std::string time = timed ? fmt::format("factor {:.3g} ms", 1e3 * m.seconds())
                             : std::string("not factored: too much work");
    if (timed && m.part_seconds.size() > 1)
        time += fmt::format(", longest part {:.3g} ms", 1e3 * m.longest_seconds());
    const std::string work = fmt::format("nnz(L) = {} ({:.2f} x nnz(K))   {:.3g} Mflop   {}",
                                         with_thousands(m.counts.factor_nnz), fill_ratio(m),
                                         1e-6 * static_cast<double>(m.counts.flops), time);
    ordered_json d = matrix_data(m);
    d["factor_nnz"] = m.counts.factor_nnz;
    d["fill"] = fill_ratio(m);
    d["flops"] = m.counts.flops;
    d["factor_samples"] = m.samples;
    if (timed) {
        d["factor_ms"] = 1e3 * m.seconds();
        ordered_json parts = ordered_json::array();
        for (const double seconds : m.part_seconds) parts.push_back(1e3 * seconds);
        d["part_factor_ms"] = std::move(parts);
        // The solver merges fronts if that is faster; their zeros are stored and multiplied.
        d["solver"] = {
            {"nnz", m.solver_matrix_nnz}, {"factor_nnz", m.solver_nnz}, {"flops", m.solver_flops}};
    }
    return {name,
            draw::draw_matrix(*m.graph, m.order, m.factor,
                              {.title = title, .notes = {size_note(m), work}, .fill = true}),
            std::move(d)};
}

Panel graph_panel(const std::string& name, const std::string& title,
                  const std::vector<std::string>& notes, const draw::InteractionGraph& graph,
                  bool parts) {
    static constexpr std::array<const char*, 5> kKinds{"rigid", "lump", "scalar", "fixed",
                                                       "kinematic"};
    ordered_json bodies = ordered_json::array(), edges = ordered_json::array();
    for (const draw::GraphNode& n : graph.nodes) {
        ordered_json b{{"name", n.name},
                       {"kind", kKinds.at(static_cast<std::size_t>(n.kind))},
                       {"position", {n.position.x(), n.position.y(), n.position.z()}},
                       {"interactions", n.degree}};
        if (parts) {
            b["part"] = n.part;
            b["separator"] = n.separator;
        }
        bodies.push_back(std::move(b));
    }
    std::int64_t cuts = 0;
    for (const draw::GraphEdge& e : graph.edges) {
        ordered_json i{{"name", e.name}, {"kind", e.kind}, {"bodies", e.nodes}};
        if (parts) i["cut"] = e.cut;
        cuts += e.cut;
        edges.push_back(std::move(i));
    }
    ordered_json d{{"bodies", std::move(bodies)}, {"interactions", std::move(edges)}};
    if (parts) d["cut_count"] = cuts;
    return {name, draw::draw_graph(graph, {.title = title, .notes = notes, .parts = parts}),
            std::move(d)};
}

}  // namespace hawser::cli
