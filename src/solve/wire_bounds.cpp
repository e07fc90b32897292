// SPDX-License-Identifier: Apache-2.0
#include "solve/wire_bounds.h"

#include "base/index.h"
#include "context/newton_data.h"
#include "context/view.h"

#include <algorithm>
#include <array>

namespace hawser::solve {
namespace {

using assembly::View;
using nonsmooth::ChainRow;

/// True for elements that act between two bodies and carry tension only.
bool is_chain_element(const model::Interactions& in, std::int32_t id) noexcept {
    constexpr int kOther = model::kRange | model::kMotor | model::kFriction;
    return (in.flags[at(id)] & (model::kOneSided | kOther)) == model::kOneSided &&
           in.bodies[at(id)] == 2 && in.rows[at(id)] == 1;
}

/// Return the other element of a node with exactly two elements; −1 for other nodes.
std::int32_t neighbour_of(const context::NodeElements& lump, std::int32_t element) noexcept {
    if (lump.count != 2) return -1;
    return lump.element[0] == element ? lump.element[1] : lump.element[0];
}

std::int32_t body_of(const context::Model& model, std::int32_t element, int slot) noexcept {
    const std::int32_t id = model.system.bounded[at(element)];
    return model.interactions.body[at(kMaxInteractionBodies * id + slot)];
}

/// List the elements of each node, and mark all other rows as listed.
void list_nodes(const context::Model& model, context::WireChains& chains) {
    const std::vector<std::int32_t>& bounded = model.system.bounded;
    chains.lumps.assign(at(model.bodies.count()), {});
    chains.listed.assign(bounded.size(), 0);
    const model::Interactions& in = model.interactions;
    for (std::int32_t id = 0; id < static_cast<std::int32_t>(in.count()); ++id)
        for (int slot = 0; slot < in.bodies[at(id)] && !in.gone(id); ++slot)
            if (const std::int32_t b = in.body[at(kMaxInteractionBodies * id + slot)]; b >= 0)
                ++chains.lumps[at(b)].attached;
    for (std::size_t i = 0; i < bounded.size(); ++i) {
        chains.listed[i] = is_chain_element(model.interactions, bounded[i]) ? 0 : 1;
        for (int slot = 0; slot < 2 && chains.listed[i] == 0; ++slot) {
            const std::int32_t b = body_of(model, static_cast<std::int32_t>(i), slot);
            if (model.bodies.kind[at(b)] != BodyKind::lump) continue;
            context::NodeElements& lump = chains.lumps[at(b)];
            if (lump.count < 2) lump.element[at(lump.count)] = static_cast<std::int32_t>(i);
            ++lump.count;
        }
    }
}

/// True if one of the ends of an element has no neighbour.
bool is_chain_end(const context::Model& model, const context::WireChains& chains,
                  std::int32_t element) noexcept {
    for (int slot = 0; slot < 2; ++slot)
        if (neighbour_of(chains.lumps[at(body_of(model, element, slot))], element) < 0) return true;
    return false;
}

/// Number the nodes of the chain that begins at entry `first` of the list.
void number_nodes(const context::Model& model, context::WireChains& chains,
                  std::size_t first) noexcept {
    const auto chain = static_cast<std::int32_t>(chains.begin.size()) - 2;
    const std::size_t count = chains.element.size() - first;
    for (std::size_t i = 0; i <= count; ++i) {
        // The first body is the one that the first two elements do not share.
        std::int32_t b = i > 0 && i < count ? chains.lump[first + i - 1] : -1;
        for (int slot = 0; slot < 2 && b < 0; ++slot) {
            const std::int32_t end =
                body_of(model, chains.element[first + (i > 0 ? i - 1 : 0)], slot);
            const std::int32_t shared = chains.lump[first + (i > 0 ? count - 2 : 0)];
            if (end != shared) b = end;
        }
        const context::NodeElements& lump = chains.lumps[at(b)];
        const std::int32_t held_by = i > 0 && i < count ? 2 : 1;
        if (model.bodies.kind[at(b)] != BodyKind::lump || lump.attached != held_by) continue;
        chains.chain_of[at(b)] = chain;
        chains.node_of[at(b)] = static_cast<std::int32_t>(i);
    }
}

/// Add the chain that begins with an element, if the chain has more than one element.
void add_chain(const context::Model& model, context::WireChains& chains, std::int32_t element) {
    const std::size_t first = chains.element.size();
    while (element >= 0) {
        chains.listed[at(element)] = 1;
        chains.element.push_back(element);
        std::int32_t next = -1, shared = -1;
        for (int slot = 0; slot < 2 && next < 0; ++slot) {
            shared = body_of(model, element, slot);
            next = neighbour_of(chains.lumps[at(shared)], element);
            if (next >= 0 && chains.listed[at(next)] != 0) next = -1;
        }
        chains.lump.push_back(next >= 0 ? shared : -1);
        element = next;
    }
    if (chains.element.size() - first < 2) {
        chains.element.resize(first);
        chains.lump.resize(first);
        return;
    }
    chains.begin.push_back(static_cast<std::int32_t>(chains.element.size()));
    number_nodes(model, chains, first);
}

/// Sum the contact terms Σ w² Eᵀ S E of each node: weight w of the node at the contact, contact
/// axes E, slope S of the contact law. The coupling of normal and tangential directions in S is
/// omitted, because it is not symmetric.
void add_contacts_to_nodes(const context::Model& model, context::WireChains& chains) noexcept {
    std::fill(chains.block.begin(), chains.block.end(), std::array<double, 9>{});
    const assembly::Contacts& contacts = model.system.contacts;
    for (std::size_t k = 0; k < contacts.count(); ++k) {
        const assembly::ContactRow& row = contacts.rows[k];
        const double* s = contacts.cones[k].s;
        const double part[9] = {s[0], 0.0, 0.0, 0.0, s[4], s[5], 0.0, s[7], s[8]};
        for (int slot = 0; slot < row.slots; ++slot) {
            if (row.slot[slot].dof != 3) continue;
            const double weight = row.slot[slot].weight * row.slot[slot].weight;
            std::array<double, 9>& block = chains.block[at(row.slot[slot].body)];
            for (int i = 0; i < 3; ++i)
                for (int j = 0; j < 3; ++j)
                    for (int a = 0; a < 3; ++a)
                        for (int b = 0; b < 3; ++b)
                            block[at(3 * i + j)] += weight * row.axis[3 * a + i] * part[3 * a + b] *
                                                    row.axis[3 * b + j];
        }
    }
}

/// Return Â_n⁻¹ g of node n by Cramer's rule; Â is positive definite.
std::array<double, 3> mobility_times(const context::Model& model, const context::WireChains& chains,
                                     std::int32_t body, const double* g) noexcept {
    std::array<double, 9> a = chains.block[at(body)];
    for (int i = 0; i < 3; ++i) a[at(4 * i)] += model.bodies.mass[at(body)];
    const double c0 = a[4] * a[8] - a[5] * a[7], c1 = a[5] * a[6] - a[3] * a[8],
                 c2 = a[3] * a[7] - a[4] * a[6];
    const double inverse = 1.0 / (a[0] * c0 + a[1] * c1 + a[2] * c2);
    return {
        inverse *
            (c0 * g[0] + (a[2] * a[7] - a[1] * a[8]) * g[1] + (a[1] * a[5] - a[2] * a[4]) * g[2]),
        inverse *
            (c1 * g[0] + (a[0] * a[8] - a[2] * a[6]) * g[1] + (a[2] * a[3] - a[0] * a[5]) * g[2]),
        inverse *
            (c2 * g[0] + (a[1] * a[6] - a[0] * a[7]) * g[1] + (a[0] * a[4] - a[1] * a[3]) * g[2])};
}

double product(const double* g, const std::array<double, 3>& x) noexcept {
    return g[0] * x[0] + g[1] * x[1] + g[2] * x[2];
}

/// Return the Jacobian columns of an element's row for one of its two bodies.
const double* columns_at(const View& v, std::int32_t id, std::int32_t body) noexcept {
    const std::int32_t first = v.body[kMaxInteractionBodies * id];
    return v.jacobian + v.jac_begin[id] + (first == body ? 0 : v.dof[first]);
}

/// Set up the tridiagonal problem for the chain of elements [begin, end) from the current solution.
void read_chain(context::Model& model, context::Newton& newton, const View& v, std::int32_t begin,
                std::int32_t end) noexcept {
    context::WireChains& chains = newton.chains;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t index = chains.element[at(k)], id = model.system.bounded[at(index)];
        ChainRow& row = chains.rows[at(k - begin)];
        row.diagonal = v.sigma[v.row_begin[id]];
        for (int slot = 0; slot < 2; ++slot) {
            const std::int32_t body = v.body[kMaxInteractionBodies * id + slot];
            if (model.bodies.kind[at(body)] != BodyKind::lump) continue;
            const double* g = columns_at(v, id, body);
            row.diagonal += product(g, mobility_times(model, chains, body, g));
        }
        row.next = 0.0;
        if (k + 1 < end) {
            const std::int32_t lump = chains.lump[at(k)];
            const std::int32_t behind = model.system.bounded[at(chains.element[at(k + 1)])];
            row.next = product(columns_at(v, id, lump),
                               mobility_times(model, chains, lump, columns_at(v, behind, lump)));
        }
        row.residual = newton.row[at(index)].r;
        row.start = -newton.row[at(index)].lambda;
        row.active = v.active[id] != 0.0;
        row.fixed = v.parted[id] != 0 || model.wires.is_replaced(id) || model.system.rests(id);
    }
}

void adopt_chain(context::Model& model, context::Work& work, const View& v, std::int32_t begin,
                 std::int32_t end) noexcept {
    const context::WireChains& chains = work.newton.chains;
    for (std::int32_t k = begin; k < end; ++k) {
        const std::int32_t id = model.system.bounded[at(chains.element[at(k)])];
        const ChainRow& row = chains.rows[at(k - begin)];
        if (row.fixed || row.active == (v.active[id] != 0.0)) continue;
        v.active[id] = row.active ? 1.0 : 0.0;
        work.solve.losses_known = false;
        if (row.active) continue;
        model.interactions.held[at(id)] = 0.0;
        v.lambda[v.row_begin[id]] = 0.0;
    }
}

}  // namespace

void reserve_wire_bounds(const context::Model& model, context::Newton& newton) {
    context::WireChains& chains = newton.chains;
    chains.element.clear();
    chains.lump.clear();
    chains.begin.assign(1, 0);
    chains.chain_of.assign(at(model.bodies.count()), -1);
    chains.node_of.assign(at(model.bodies.count()), -1);
    list_nodes(model, chains);
    for (const bool closed : {false, true})
        for (std::size_t i = 0; i < chains.listed.size(); ++i) {
            const auto element = static_cast<std::int32_t>(i);
            if (chains.listed[i] == 0 && (closed || is_chain_end(model, chains, element)))
                add_chain(model, chains, element);
        }
    std::size_t longest = 0;
    for (std::size_t k = 0; k + 1 < chains.begin.size(); ++k)
        longest = std::max(longest, at(chains.begin[k + 1] - chains.begin[k]));
    chains.rows.resize(longest);
    newton.wire.stiffness.resize(longest + 1);
    newton.wire.matrix.resize(longest + 1);
    newton.wire.elements.resize(longest);
    newton.wire.begin.resize(chains.begin.size());
    chains.block.resize(longest > 0 ? at(model.bodies.count()) : 0);
}

void settle_wire_bounds(context::Model& model, context::Work& work) noexcept {
    context::WireChains& chains = work.newton.chains;
    const View v = context::row_view(model);
    bool knows_contacts = false;
    for (std::size_t k = 0; k + 1 < chains.begin.size(); ++k) {
        const std::int32_t begin = chains.begin[k], end = chains.begin[k + 1];
        const bool switched = std::any_of(
            chains.element.begin() + begin, chains.element.begin() + end, [&](std::int32_t i) {
                return v.active[model.system.bounded[at(i)]] != work.solve.factored_active[at(i)];
            });
        if (!switched) continue;
        if (!knows_contacts) add_contacts_to_nodes(model, chains);
        knows_contacts = true;
        read_chain(model, work.newton, v, begin, end);
        if (nonsmooth::solve_chain(at(end - begin), chains.rows.data()))
            adopt_chain(model, work, v, begin, end);
    }
}

}  // namespace hawser::solve
