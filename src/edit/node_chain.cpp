// SPDX-License-Identifier: Apache-2.0
#include "edit/node_chain.h"

#include "base/index.h"
#include "edit/node_pieces.h"

#include <algorithm>

namespace hawser::edit {
namespace {

NodeChain::Piece piece_of(const context::StepContext& ctx, std::int32_t id) noexcept {
    const model::Interactions& in = ctx.model.interactions;
    NodeChain::Piece p;
    p.id = id;
    p.one_sided = (in.flags[at(id)] & model::kOneSided) != 0;
    p.mass = mass_of_element(ctx, id);
    if (is_free_node(ctx, end_of(ctx, id, 0)) && is_free_node(ctx, end_of(ctx, id, 1)) &&
        ctx.model.system.consistent_mass)
        p.pair = in.pair_mass[at(id)];
    p.EA = stiffness_of(ctx, id);
    p.rest = in.rest_length[at(id)];
    p.pull = tension_of(ctx, id);
    return p;
}

NodeChain::ChainNode node_at(const context::StepContext& ctx, std::int32_t id,
                             std::size_t slot) noexcept {
    NodeChain::ChainNode l;
    l.body = end_of(ctx, id, slot);
    l.point = is_free_node(ctx, l.body);
    if (l.point) l.mass = ctx.model.bodies.mass[at(l.body)];
    l.v = speed_of(ctx, id, slot, ctx.model.bodies.v);
    l.y = point_of(ctx, id, slot) - 0.5 * ctx.model.def.step * l.v;
    return l;
}

bool chain_contains(const NodeChain& chain, std::int32_t id) noexcept {
    const auto end = chain.piece.begin() + static_cast<std::ptrdiff_t>(chain.count - 1);
    return std::any_of(chain.piece.begin(), end, [&](const auto& p) { return p.id == id; });
}

}  // namespace

NodeChain nearby_chain(const context::StepContext& ctx, const NodeSurroundings& place) noexcept {
    NodeChain out;
    out.half = 0.5 * ctx.model.def.step;
    std::size_t pieces = 0;
    const auto add = [&](std::int32_t id) {
        if (id < 0) return;
        if (pieces == 0) out.lump[0] = node_at(ctx, id, 0);
        out.piece[pieces++] = piece_of(ctx, id);
        out.lump[pieces] = node_at(ctx, id, 1);
    };
    for (std::size_t k = kNodeReach; k-- > 0;) add(place.before[k]);
    add(place.first);
    out.middle = pieces;
    add(place.second);
    for (const std::int32_t id : place.after) add(id);
    out.count = pieces + 1;
    for (std::size_t k = 0; k < pieces; ++k)
        out.piece[k].rate = out.separation(k).normalized().dot(out.lump[k + 1].v - out.lump[k].v);
    const auto fits = [&](std::int32_t id) {
        return id < 0 || (chain_contains(out, id) && is_of_material(ctx, id));
    };
    for (std::size_t k = 0; k < out.count; ++k) {
        NodeChain::ChainNode& l = out.lump[k];
        if (!l.point) continue;
        const NodeLinks links = adjacent_elements(ctx, l.body);
        l.moves = links.has_only_bends && fits(links.before) && fits(links.after);
    }
    return out;
}

NodeChain without_node(const NodeChain& chain) noexcept {
    NodeChain out = chain;
    const std::size_t n = chain.middle;
    const NodeChain::Piece &e = chain.piece[n - 1], &f = chain.piece[n];
    NodeChain::ChainNode &a = out.lump[n - 1], &b = out.lump[n + 1];
    a.mass += 0.5 * f.mass;
    b.mass += 0.5 * e.mass;
    NodeChain::Piece& one = out.piece[n - 1];
    one.mass = e.mass + f.mass;
    one.pair = a.point && b.point ? (e.pair + f.pair) : 0.0;
    one.rest = e.rest + f.rest;
    // The law is linear in the strain, so its mean over the material is the mean of the forces.
    one.EA = (e.rest + f.rest) / (e.rest / e.EA + f.rest / f.EA);
    one.pull = (e.rest * e.pull + f.rest * f.pull) / one.rest;
    one.rate = e.rate + f.rate;
    for (std::size_t k = n; k + 1 < chain.count; ++k) out.lump[k] = out.lump[k + 1];
    for (std::size_t k = n; k + 2 < chain.count; ++k) out.piece[k] = chain.piece[k + 1];
    --out.count;
    return out;
}

double energy_of(const NodeChain& chain) noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k < chain.count; ++k)
        sum += 0.5 * chain.lump[k].mass * chain.lump[k].v.squaredNorm();
    for (std::size_t k = 0; k + 1 < chain.count; ++k) {
        const NodeChain::Piece& p = chain.piece[k];
        sum -= 0.5 * p.pair * (chain.lump[k + 1].v - chain.lump[k].v).squaredNorm();
    }
    return sum + stretch_energy_of(chain);
}

double stretch_energy_of(const NodeChain& chain) noexcept {
    double sum = 0.0;
    for (std::size_t k = 0; k + 1 < chain.count; ++k) {
        const NodeChain::Piece& p = chain.piece[k];
        const double longer = chain.separation(k).norm() - p.rest;
        if (longer > 0.0 || !p.one_sided) sum += 0.5 * p.EA / p.rest * longer * longer;
    }
    return sum;
}

NodeMomentum momentum_of(const NodeChain& chain, const Vec3& about) noexcept {
    NodeMomentum sum;
    for (std::size_t k = 0; k < chain.count; ++k) {
        const Vec3 p = chain.lump[k].mass * chain.lump[k].v;
        sum.linear += p;
        sum.angular += (chain.lump[k].y - about).cross(p);
    }
    for (std::size_t k = 0; k + 1 < chain.count; ++k)
        sum.angular -=
            chain.piece[k].pair * chain.separation(k).cross(chain.lump[k + 1].v - chain.lump[k].v);
    return sum;
}

void fit_lengths(NodeChain& chain) noexcept {
    for (std::size_t k = 0; k + 1 < chain.count; ++k) {
        if (!chain.lump[k].moves && !chain.lump[k + 1].moves && k + 1 != chain.middle) continue;
        NodeChain::Piece& p = chain.piece[k];
        const double length = chain.separation_at_pose(k).norm();
        if (p.pull == 0.0 && p.one_sided)
            p.rest = std::max(p.rest, length);
        else
            p.rest = length / (1.0 + p.pull / p.EA);
    }
}

}  // namespace hawser::edit
