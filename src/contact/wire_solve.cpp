// SPDX-License-Identifier: Apache-2.0
#include "contact/wire_solve.h"

#include "context/newton_data.h"

#include <algorithm>

namespace hawser::contact {
namespace {

using nonsmooth::ChainBlock;

/// Add element e, between nodes k and k + 1, to the matrix and the right-hand side.
void add_element(const context::WireElement& e, ChainBlock* nodes) noexcept {
    const double inverse = e.active ? 1.0 / e.sigma : 0.0;
    const double impulse = e.active ? e.from.r * inverse : -e.from.lambda;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            nodes[0].diagonal[3 * i + j] += inverse * e.g[0][i] * e.g[0][j];
            nodes[1].diagonal[3 * i + j] += inverse * e.g[1][i] * e.g[1][j];
            nodes[0].block_behind[3 * i + j] += inverse * e.g[0][i] * e.g[1][j];
            nodes[1].block_before[3 * i + j] += inverse * e.g[1][i] * e.g[0][j];
        }
        nodes[0].x[i] += e.g[0][i] * impulse;
        nodes[1].x[i] += e.g[1][i] * impulse;
    }
}

void multiply3(const double* a, const double* x, double* out) noexcept {
    for (int i = 0; i < 3; ++i)
        out[i] = a[3 * i] * x[0] + a[3 * i + 1] * x[1] + a[3 * i + 2] * x[2];
}

/// Add a contact: Jᵀ S J and Jᵀ(p − S u − λ), with J = w E for a slot.
void add_contact(const context::WireContact& c, const assembly::ContactRow& row,
                 std::vector<ChainBlock>& nodes) noexcept {
    const double* e = row.axis;
    double se[9] = {}, ese[9] = {}, su[3], f[3];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) se[3 * i + j] += c.law.s[3 * i + k] * e[3 * k + j];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) ese[3 * i + j] += e[3 * k + i] * se[3 * k + j];
    multiply3(c.law.s, c.from, su);
    for (int i = 0; i < 3; ++i) f[i] = c.law.p[i] - su[i] - c.from[3 + i];
    for (int s = 0; s < row.slots; ++s) {
        if (c.node[s] < 0) continue;
        ChainBlock& node = nodes[at(c.node[s])];
        const double weight = row.slot[s].weight;
        for (int i = 0; i < 3; ++i)
            node.x[i] += weight * (e[i] * f[0] + e[3 + i] * f[1] + e[6 + i] * f[2]);
        for (int t = 0; t < row.slots; ++t) {
            const std::int32_t separation = c.node[t] - c.node[s];
            if (c.node[t] < 0 || separation < -1 || separation > 1) continue;
            double* block = separation == 0  ? node.diagonal
                            : separation < 0 ? node.block_before
                                             : node.block_behind;
            for (int i = 0; i < 9; ++i) block[i] += weight * row.slot[t].weight * ese[i];
        }
    }
}

/// Compute λ and r of the elements, and u and λ of the contacts, from the velocity changes δv of
/// the nodes.
void complete_chain_solution(const context::Model& model, context::WireNewton& wire,
                             std::int32_t chain) noexcept {
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        context::WireElement& e = wire.elements[at(k)];
        double speed = 0.0;
        for (int i = 0; i < 3; ++i)
            speed += e.g[0][i] * wire.matrix[at(k)].x[i] + e.g[1][i] * wire.matrix[at(k) + 1].x[i];
        const double right_side = e.from.r + e.sigma * e.from.lambda - speed;
        e.to = e.active ? context::BoundedRow{right_side / e.sigma, 0.0}
                        : context::BoundedRow{0.0, right_side};
    }
    for (std::size_t i = 0; i < chain_contact_count(wire, chain); ++i) {
        context::WireContact& c = wire.contacts[i];
        const assembly::ContactRow& row = model.system.contacts.rows[at(c.contact)];
        double change[3] = {}, along[3], su[3];
        for (int s = 0; s < row.slots; ++s) {
            if (c.node[s] < 0) continue;
            for (int j = 0; j < 3; ++j)
                change[j] += row.slot[s].weight * wire.matrix[at(c.node[s])].x[j];
        }
        multiply3(row.axis, change, along);
        for (int j = 0; j < 3; ++j) c.cone.u[j] = c.from[j] + along[j];
        multiply3(c.law.s, c.cone.u, su);
        for (int j = 0; j < 3; ++j) c.cone.lambda[j] = c.law.p[j] - su[j];
    }
}

}  // namespace

bool solve_wire(const context::Model& model, context::WireNewton& wire,
                std::int32_t chain) noexcept {
    std::copy_n(wire.stiffness.begin(), wire.nodes, wire.matrix.begin());
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k)
        add_element(wire.elements[at(k)], &wire.matrix[at(k)]);
    for (std::size_t i = 0; i < chain_contact_count(wire, chain); ++i) {
        const context::WireContact& c = wire.contacts[i];
        add_contact(c, model.system.contacts.rows[at(c.contact)], wire.matrix);
    }
    if (!nonsmooth::solve_block_chain(at(wire.nodes), wire.matrix.data())) return false;
    complete_chain_solution(model, wire, chain);
    return true;
}

}  // namespace hawser::contact
