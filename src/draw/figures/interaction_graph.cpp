// SPDX-License-Identifier: Apache-2.0
#include "draw/figures/interaction_graph.h"

#include "draw/figures/index.h"

#include <algorithm>
#include <set>
#include <utility>

namespace hawser::draw {
namespace {

bool moves(const BodyDef& def) {
    return def.kind != BodyKind::fixed && def.kind != BodyKind::kinematic;
}

/// Place drums at the mean position of their neighbours.
void place_drums(InteractionGraph& g, std::vector<std::int32_t>& number) {
    std::vector<Vec3> sum(g.nodes.size(), Vec3::Zero());
    std::vector<double> count(g.nodes.size(), 0.0);
    for (const GraphEdge& e : g.edges)
        for (const std::int32_t n : e.nodes)
            for (const std::int32_t other : e.nodes)
                if (g.nodes[at(other)].kind != BodyKind::scalar) {
                    sum[at(n)] += g.nodes[at(other)].position;
                    count[at(n)] += 1.0;
                }
    for (GraphNode& n : g.nodes) {
        const std::size_t k = at(number[at(n.body.index)]);
        if (n.kind == BodyKind::scalar)
            n.position = count[k] > 0.0 ? Vec3(sum[k] / count[k]) : Vec3(Vec3::Zero());
    }
}

void add_contacts(const World& world, const std::vector<std::int32_t>& number,
                  InteractionGraph& g) {
    std::set<std::pair<std::int32_t, std::int32_t>> seen;
    for (const ContactView& c : world.contacts()) {
        if (!seen.emplace(c.shape[0].index, c.shape[1].index).second) continue;
        GraphEdge e{.interaction = {}, .name = "", .kind = "contact", .nodes = {}, .fixed = {}};
        for (const ShapeId shape : c.shape) {
            const ShapeDef& def = world.shape_def(shape);
            for (const BodyId b : {def.body, def.body_b})
                if (b.valid() && number[at(b.index)] >= 0)
                    e.nodes.push_back(number[at(b.index)]);
                else if (b.valid() && e.fixed.empty())
                    e.fixed.push_back(c.point);
        }
        std::sort(e.nodes.begin(), e.nodes.end());
        e.nodes.erase(std::unique(e.nodes.begin(), e.nodes.end()), e.nodes.end());
        if (!e.nodes.empty()) g.edges.push_back(std::move(e));
    }
}

}  // namespace

InteractionGraph interaction_graph(const World& world) {
    InteractionGraph g;
    std::vector<std::int32_t> number(at(world.body_count()), -1);
    for (const BodyId id : world.bodies()) {
        const BodyDef& def = world.body_def(id);
        if (!moves(def)) continue;
        number[at(id.index)] = static_cast<std::int32_t>(g.nodes.size());
        g.nodes.push_back(
            {.body = id, .name = def.name, .position = world.pose(id).position, .kind = def.kind});
    }
    for (const InteractionId id : world.interactions()) {
        const InteractionDef& def = world.interaction_def(id);
        const KindInfo& info = kind_info(def.kind);
        GraphEdge e{
            .interaction = id, .name = def.name, .kind = info.name, .nodes = {}, .fixed = {}};
        for (int k = 0; k < info.bodies; ++k) {
            const BodyId b = def.body[at(k)];
            if (!b.valid()) continue;
            if (number[at(b.index)] >= 0)
                e.nodes.push_back(number[at(b.index)]);
            else if (info.bodies > 1)
                e.fixed.push_back(world.world_point(b, def.point[at(k)]));
        }
        if (!e.nodes.empty()) g.edges.push_back(std::move(e));
    }
    add_contacts(world, number, g);
    for (const GraphEdge& e : g.edges)
        for (const std::int32_t n : e.nodes) ++g.nodes[at(n)].degree;
    place_drums(g, number);
    return g;
}

}  // namespace hawser::draw
