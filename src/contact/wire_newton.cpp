// SPDX-License-Identifier: Apache-2.0
#include "contact/wire_newton.h"

#include "base/index.h"
#include "contact/convex_phase.h"
#include "contact/newton_laws.h"
#include "contact/wire_solve.h"
#include "context/newton_data.h"
#include "context/view.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::contact {
namespace {

using assembly::View;
using nonsmooth::ChainBlock;
using nonsmooth::Cone;

constexpr int kMaxWireIterations = 60;
constexpr int kExactWireIterations = 8;  ///< Before the convex phase.
constexpr double kUnsettled = 1e-3;      ///< Natural map of a contact whose line is settled.
constexpr double kWireConvexEnd = 5e-3;  ///< Natural map below which the convex phase ends.
constexpr int kWireHalvings = 4;
constexpr std::int64_t kFlopsOfNode = 500;  ///< Flops per node and iteration.

// --- The problem ------------------------------------------------------------------------------

/// Add factor × E to a 3×3 matrix a.
void add_scaled_identity(double factor, double* a) noexcept {
    for (int i = 0; i < 3; ++i) a[4 * i] += factor;
}

/// Compute the stiffness of an element against relative velocities: w (E − uuᵀ) − μE.
void element_block(const View& v, std::int32_t id, double out[9]) noexcept {
    std::fill_n(out, 9, 0.0);
    add_scaled_identity(-assembly::pair_mass_of(v, id), out);
    if (v.geo[id].record < 0) return;
    const double* record = v.geo_record + v.geo[id].record;
    add_scaled_identity(record[0], out);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) out[3 * i + j] -= record[0] * record[1 + i] * record[1 + j];
}

/// Return the node of a body in a chain, −1: fixed.
std::int32_t node_in(const context::WireChains& chains, std::int32_t chain,
                     std::int32_t body) noexcept {
    return body >= 0 && chains.chain_of[at(body)] == chain ? chains.node_of[at(body)] : -1;
}

/// Fill in the elements of a chain and add their stiffness.
/// @return false if one of them has no compliance or is replaced by another force.
bool read_elements(const context::Model& model, context::Newton& newton, const View& v,
                   std::int32_t chain) noexcept {
    const context::WireChains& chains = newton.chains;
    context::WireNewton& wire = newton.wire;
    const std::int32_t begin = chains.begin[at(chain)], end = chains.begin[at(chain) + 1];
    wire.nodes = end - begin + 1;
    std::fill_n(wire.stiffness.begin(), wire.nodes, ChainBlock{});
    for (std::int32_t k = begin; k < end; ++k) {
        context::WireElement& e = wire.elements[at(k - begin)];
        e.index = chains.element[at(k)];
        e.id = model.system.bounded[at(e.index)];
        e.sigma = v.sigma[v.row_begin[e.id]];
        e.mobility = model.system.bounded_mobility[at(e.index)];
        if (!(e.sigma > 0.0) || model.wires.is_replaced(e.id)) return false;
        e.from = e.to = newton.row[at(e.index)];
        e.active = v.active[e.id] != 0.0 && v.parted[e.id] == 0;
        std::fill_n(&e.g[0][0], 6, 0.0);
        double block[9];
        element_block(v, e.id, block);
        const double* columns = v.jacobian + v.jac_begin[e.id];
        std::int32_t node[2] = {-1, -1};
        for (int slot = 0; slot < 2; ++slot) {
            const std::int32_t body = v.body[kMaxInteractionBodies * e.id + slot];
            node[slot] = node_in(chains, chain, body);
            if (node[slot] >= 0) {
                std::copy_n(columns, 3, e.g[node[slot] - (k - begin)]);
                for (int i = 0; i < 9; ++i) wire.stiffness[at(node[slot])].diagonal[i] += block[i];
            }
            columns += v.dof[body];
        }
        if (node[0] < 0 || node[1] < 0) continue;
        for (int i = 0; i < 9; ++i) {
            wire.stiffness[at(k - begin)].block_behind[i] -= block[i];
            wire.stiffness[at(k - begin) + 1].block_before[i] -= block[i];
        }
    }
    return true;
}

/// Add the diagonal block of each node to the matrix of a chain. A fixed node gets the identity,
/// which keeps its velocity.
void read_nodes(const context::Newton& newton, context::WireNewton& wire, const View& v,
                std::int32_t chain, const context::Model& model) noexcept {
    const context::WireChains& chains = newton.chains;
    const std::int32_t begin = chains.begin[at(chain)];
    for (std::int32_t node = 0; node < wire.nodes; ++node) {
        ChainBlock& block = wire.stiffness[at(node)];
        std::int32_t body = -1;
        const std::int32_t element = chains.element[at(begin + (node > 0 ? node - 1 : 0))];
        const std::int32_t id = model.system.bounded[at(element)];
        for (int slot = 0; slot < 2; ++slot) {
            const std::int32_t b = v.body[kMaxInteractionBodies * id + slot];
            if (node_in(chains, chain, b) == node) body = b;
        }
        if (body < 0) {
            add_scaled_identity(1.0, block.diagonal);
            continue;
        }
        const double* own = v.body_block + assembly::block_offset(v.dof_begin[body]);
        constexpr int kPacked[9] = {0, 1, 2, 1, 3, 4, 2, 4, 5};
        for (int i = 0; i < 9; ++i) block.diagonal[i] += own[kPacked[i]];
    }
}

/// Return the chain of the first node that a contact acts on, −1: none.
std::int32_t chain_of_contact(const context::WireChains& chains,
                              const assembly::ContactRow& row) noexcept {
    for (int slot = 0; slot < row.slots; ++slot) {
        const std::int32_t body = row.slot[slot].body;
        if (body >= 0 && chains.chain_of[at(body)] >= 0) return chains.chain_of[at(body)];
    }
    return -1;
}

/// List the contacts of each chain of wire elements, by ascending index.
void list_wire_contacts(const context::Model& model, context::Newton& newton) noexcept {
    const assembly::Contacts& contacts = model.system.contacts;
    context::WireNewton& wire = newton.wire;
    std::fill(wire.begin.begin(), wire.begin.end(), 0);
    for (std::size_t k = 0; k < contacts.count(); ++k)
        if (const std::int32_t c = chain_of_contact(newton.chains, contacts.rows[k]); c >= 0)
            ++wire.begin[at(c) + 1];
    for (std::size_t i = 1; i < wire.begin.size(); ++i) wire.begin[i] += wire.begin[i - 1];
    // In reverse order, begin[c + 1] moves from the end of chain c to its start.
    const std::int32_t all = wire.begin.back();
    for (std::size_t k = contacts.count(); k-- > 0;)
        if (const std::int32_t c = chain_of_contact(newton.chains, contacts.rows[k]); c >= 0)
            wire.contact[at(--wire.begin[at(c) + 1])] = static_cast<std::int32_t>(k);
    std::copy(wire.begin.begin() + 1, wire.begin.end(), wire.begin.begin());
    wire.begin.back() = all;
}

void read_contacts(const context::Model& model, context::Newton& newton,
                   std::int32_t chain) noexcept {
    const assembly::Contacts& contacts = model.system.contacts;
    context::WireNewton& wire = newton.wire;
    for (std::size_t i = 0; i < chain_contact_count(wire, chain); ++i) {
        context::WireContact& c = wire.contacts[i];
        c.contact = wire.contact[at(wire.begin[at(chain)]) + i];
        const assembly::ContactRow& row = contacts.rows[at(c.contact)];
        for (int slot = 0; slot < row.slots; ++slot)
            c.node[slot] = node_in(newton.chains, chain, row.slot[slot].body);
        c.cone = contacts.cones[at(c.contact)];
        c.law = newton.laws[at(c.contact)];
        c.changes = 0;
        std::copy_n(c.cone.lambda, 3, std::copy_n(c.cone.u, 3, c.from));
    }
}

// --- An iteration -----------------------------------------------------------------------------

double interpolate(double from, double to, double t) noexcept { return from + t * (to - from); }

/// Return Σ (W + Σ) ‖λ − P‖² at a fraction t of the way, as merit().
double wire_merit(const context::WireNewton& wire, std::size_t contacts, double t) noexcept {
    double sum = 0.0;
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        const context::WireElement& e = wire.elements[at(k)];
        const double lambda = interpolate(e.from.lambda, e.to.lambda, t),
                     scale = e.mobility + e.sigma;
        const double error =
            lambda - std::min(0.0, lambda + interpolate(e.from.r, e.to.r, t) / scale);
        sum += scale * error * error;
    }
    for (std::size_t i = 0; i < contacts; ++i) {
        const Cone& c = wire.contacts[i].cone;
        const double* from = wire.contacts[i].from;
        double u[3], lambda[3], e[3];
        for (int j = 0; j < 3; ++j) {
            u[j] = interpolate(from[j], c.u[j], t);
            lambda[j] = interpolate(from[3 + j], c.lambda[j], t);
        }
        nonsmooth::residual(c, u, lambda, e);
        sum += (c.mobility + c.sigma_n) * e[0] * e[0] +
               (c.mobility + c.sigma_t) * (e[1] * e[1] + e[2] * e[2]);
    }
    return sum;
}

/// Return the slope ψ of convex_phase.h for one line.
double wire_slope(const context::WireNewton& wire, std::size_t contacts, double t) noexcept {
    double sum = 0.0;
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        const context::WireElement& e = wire.elements[at(k)];
        const double from = e.from.r + e.sigma * e.from.lambda, to = e.to.r + e.sigma * e.to.lambda;
        const double impulse = std::min(0.0, interpolate(from, to, t) / e.sigma);
        sum += (interpolate(e.from.lambda, e.to.lambda, t) - impulse) * (from - to);
    }
    for (std::size_t i = 0; i < contacts; ++i)
        sum += contact_slope(wire.contacts[i].cone, wire.contacts[i].from, t);
    return sum;
}

double wire_line_search(const context::WireNewton& wire, std::size_t contacts,
                        double before) noexcept {
    if (wire.convex)
        return zero_slope_fraction([&](double t) { return wire_slope(wire, contacts, t); });
    double now = wire_merit(wire, contacts, 1.0), best = now, best_t = 1.0, t = 1.0;
    for (int k = 0; k < kWireHalvings && !(now <= before * (1.0 - 1e-4 * t)); ++k) {
        t *= 0.5;
        now = wire_merit(wire, contacts, t);
        if (!(now < best)) continue;
        best = now;
        best_t = t;
    }
    return best_t;
}

void save_wire_iterate(context::WireNewton& wire, std::size_t contacts, double t) noexcept {
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        context::WireElement& e = wire.elements[at(k)];
        e.from = {interpolate(e.from.lambda, e.to.lambda, t), interpolate(e.from.r, e.to.r, t)};
    }
    for (std::size_t i = 0; i < contacts; ++i) {
        context::WireContact& c = wire.contacts[i];
        for (int j = 0; j < 3; ++j) {
            c.from[j] = c.cone.u[j] = interpolate(c.from[j], c.cone.u[j], t);
            c.from[3 + j] = c.cone.lambda[j] = interpolate(c.from[3 + j], c.cone.lambda[j], t);
        }
    }
}

/// Switch elements whose status (taut or slack) does not match the solution.
/// @return number of such elements.
std::int32_t switch_elements(const context::Model& model, const View& v,
                             context::WireNewton& wire) noexcept {
    std::int32_t switch_count = 0;
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        context::WireElement& e = wire.elements[at(k)];
        if (v.parted[e.id] != 0) continue;
        const double scale = e.sigma + (wire.convex ? context::kConvexFraction : 1.0) * e.mobility;
        const double target_impulse =
            std::min(0.0, (e.active ? e.from.lambda : 0.0) + e.from.r / scale);
        if ((target_impulse < 0.0) == e.active) continue;
        if (std::fabs(target_impulse - e.from.lambda) <= model.contact_floor) continue;
        e.active = !e.active;
        ++switch_count;
    }
    return switch_count;
}

double largest_wire_residual(const context::Model& model, const context::WireNewton& wire,
                             std::size_t contacts) noexcept {
    double largest = 0.0;
    for (std::size_t i = 0; i < contacts; ++i) {
        const double e = nonsmooth::natural_map(wire.contacts[i].cone, model.contact_floor);
        if (!(e <= largest)) largest = e;
    }
    return largest;
}

void renew_wire_laws(context::WireNewton& wire, std::size_t contacts) noexcept {
    for (std::size_t i = 0; i < contacts; ++i) {
        context::WireContact& c = wire.contacts[i];
        if (wire.convex)
            c.law = nonsmooth::linearise(convex_cone(c.cone), c.cone.touch);
        else
            renew_law(c.cone, c.law, c.changes);
    }
}

/// Iterate one line to convergence.
/// @return false if the iterations did not converge.
bool iterate_wire(const context::Model& model, context::Work& work, const View& v,
                  std::int32_t chain) noexcept {
    context::WireNewton& wire = work.newton.wire;
    const std::size_t contacts = chain_contact_count(wire, chain);
    const double tolerance = 0.1 * model.def.contact_tolerance;
    wire.convex = false;
    double before = wire_merit(wire, contacts, 0.0);
    for (int it = 0, exact = 0; it < kMaxWireIterations; ++it) {
        work.solve.step_flops += kFlopsOfNode * wire.nodes;
        if (!solve_wire(model, wire, chain)) return false;
        save_wire_iterate(wire, contacts, wire_line_search(wire, contacts, before));
        const double map = largest_wire_residual(model, wire, contacts);
        const std::int32_t switch_count = switch_elements(model, v, wire);
        if (!std::isfinite(map)) return false;
        const bool done = map <= tolerance && switch_count == 0;
        if (wire.convex && map <= kWireConvexEnd && switch_count == 0) {
            wire.convex = false;
            exact = 0;
            for (std::size_t i = 0; i < contacts; ++i) wire.contacts[i].changes = 0;
        } else if (!wire.convex && ++exact >= kExactWireIterations) {
            wire.convex = true;
        }
        if (done) wire.convex = false;
        renew_wire_laws(wire, contacts);
        if (done) return true;
        before = wire_merit(wire, contacts, 0.0);
    }
    return false;
}

void adopt_wire(context::Model& model, context::Work& work, const View& v,
                std::int32_t chain) noexcept {
    context::WireNewton& wire = work.newton.wire;
    for (std::int32_t k = 0; k + 1 < wire.nodes; ++k) {
        const context::WireElement& e = wire.elements[at(k)];
        if (v.parted[e.id] != 0 || e.active == (v.active[e.id] != 0.0)) continue;
        v.active[e.id] = e.active ? 1.0 : 0.0;
        work.solve.losses_known = false;
        if (e.active) continue;
        model.interactions.held[at(e.id)] = 0.0;
        v.lambda[v.row_begin[e.id]] = 0.0;
    }
    for (std::size_t i = 0; i < chain_contact_count(wire, chain); ++i) {
        const context::WireContact& c = wire.contacts[i];
        work.newton.laws[at(c.contact)] = c.law;
        model.system.contacts.cones[at(c.contact)].touch = c.cone.touch;
    }
}

/// True if the residual of a chain exceeds that of converged lines in the global iterate.
bool is_unsettled(const context::Model& model, const context::Work& work, const View& v,
                  std::int32_t chain) noexcept {
    const context::WireChains& chains = work.newton.chains;
    for (std::int32_t k = chains.begin[at(chain)]; k < chains.begin[at(chain) + 1]; ++k) {
        const std::int32_t i = chains.element[at(k)];
        if (v.active[model.system.bounded[at(i)]] != work.solve.factored_active[at(i)]) return true;
    }
    const context::WireNewton& wire = work.newton.wire;
    return std::any_of(wire.contact.begin() + wire.begin[at(chain)],
                       wire.contact.begin() + wire.begin[at(chain) + 1], [&](std::int32_t k) {
                           const Cone& c = model.system.contacts.cones[at(k)];
                           return !(nonsmooth::natural_map(c, model.contact_floor) <= kUnsettled);
                       });
}

}  // namespace

void reserve_wire_newton(const context::Model& model, context::Newton& newton) {
    newton.wire.contacts.resize(model.system.contacts.count());
    newton.wire.contact.resize(model.system.contacts.count());
}

void settle_wire_contacts(context::Model& model, context::Work& work) noexcept {
    context::Newton& newton = work.newton;
    if (newton.chains.begin.size() < 2) return;
    const View v = context::row_view(model);
    list_wire_contacts(model, newton);
    for (std::int32_t chain = 0; chain + 1 < static_cast<std::int32_t>(newton.chains.begin.size());
         ++chain) {
        if (chain_contact_count(newton.wire, chain) == 0 || !is_unsettled(model, work, v, chain))
            continue;
        if (!read_elements(model, newton, v, chain)) continue;
        read_nodes(newton, newton.wire, v, chain, model);
        read_contacts(model, newton, chain);
        if (iterate_wire(model, work, v, chain)) adopt_wire(model, work, v, chain);
    }
}

}  // namespace hawser::contact
