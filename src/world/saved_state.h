// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file saved_state.h
/// Arrays of a snapshot in their order, and buffers to read them into before a world accepts them.

#include "context/context.h"
#include "world/impl.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::world {

/// Identifies the world's layout and contains the sizes of the arrays that follow.
struct Header {
    char magic[8] = {'H', 'A', 'W', 'S', 'N', 'P', '2', '8'};
    std::uint64_t layout = 0;       ///< See layout_of().
    std::uint64_t parameters = 0;   ///< See parameters_of().
    std::uint64_t contacts = 0;     ///< Contacts remembered from the last step.
    std::uint64_t resistances = 0;  ///< Number with rolling or spinning resistance.
    std::uint64_t links = 0;        ///< Pairs of bodies that touched.
    std::uint64_t nodes = 0;        ///< Nodes of the elimination order.
    std::uint64_t chained = 0, units = 0, chains = 0;  ///< Nodes in chains, units, chains.
    std::uint64_t grouped = 0;  ///< Bodies with groups that follow the state: all or none.
    std::uint64_t bytes = 0;    ///< Size of the arrays that follow.
    std::uint64_t systems = 0;  ///< Hash of names and sizes of systems, whose states come last.
    std::uint64_t system_bytes = 0;
};

/// Call f(array) for the data of groups that are part of the state. They come first, because the
/// numbers of ghost bodies and duplicated rows depend on them.
template <class Groups, class F>
void visit_groups(Groups& groups, F&& f) {
    f(groups.parts.part.data(), groups.parts.part.size() * sizeof(std::int32_t));
    f(&groups.parts.parts, sizeof groups.parts.parts);
    f(&groups.parts.worse_for, sizeof groups.parts.worse_for);
    f(&groups.made, sizeof groups.made);
    f(&groups.seen, sizeof groups.seen);
}

/// Visit motion and memory of bodies, interactions and wires: f(array) in a fixed order. For two
/// worlds with the same definitions and other couplings, the leading parts of the arrays agree.
template <class Context, class F>
void visit_motion(Context& ctx, F&& f) {
    f(ctx.model.bodies.x);
    f(ctx.model.bodies.q);
    // Stored, not recomputed: the integrator's kernel rounds differently on each instruction set.
    f(ctx.model.bodies.r);
    f(ctx.model.bodies.v);
    f(ctx.model.bodies.v_start);
    f(ctx.model.bodies.v_fixed);
    f(ctx.model.bodies.spin_change);
    f(ctx.model.bodies.force);
    f(ctx.model.bodies.asleep);
    f(ctx.model.bodies.quiet);
    f(ctx.model.interactions.lambda);
    f(ctx.model.interactions.force);
    f(ctx.model.interactions.active);
    f(ctx.model.interactions.parted);
    f(ctx.model.interactions.coarse);
    f(ctx.model.interactions.repeats);
    f(ctx.model.interactions.saturated);
    f(ctx.model.interactions.anchor);
    f(ctx.model.wires.energy_allowance);
    f(ctx.model.wires.flag_steps);
    f(ctx.model.wires.recoil);
}

/// Call f(value) for each single value of the state.
template <class Context, class F>
void visit_values(Context& ctx, F&& f) {
    f(ctx.state.step);
    f(ctx.state.started);
    f(ctx.state.refine_unasked);
    f(ctx.state.ledger.work);
    f(ctx.state.ledger.drag);
    f(ctx.state.ledger.drive);
    f(ctx.state.ledger.edited);
    f(ctx.state.ledger.friction);
    f(ctx.state.ledger.contact);
    f(ctx.state.ledger.damped);
    f(ctx.state.loads.work);
    f(ctx.state.loads.water);
    f(ctx.state.loads.added);
    f(ctx.state.monitor.state);
    f(ctx.work.stats.event_count);
}

/// Call f(array) for each array of stored contacts.
template <class Context, class F>
void visit_contacts(Context& ctx, F&& f) {
    f(ctx.model.collider.last_contacts());
    f(ctx.model.system.contacts.memory);
    f(ctx.model.system.contacts.resistances.memory);
    f(ctx.model.system.contacts.links);
    f(ctx.model.system.contacts.link_used);
}

/// Call f(pointer, bytes) for every array of the state.
template <class Context, class Order, class F>
void visit_state(Context& ctx, std::vector<double>& inputs, Order& order, F&& f) {
    auto array = [&](auto& a) { f(a.data(), a.size() * sizeof(a[0])); };
    auto value = [&](auto& v) { f(&v, sizeof v); };
    visit_groups(ctx.model.regroup, f);
    visit_motion(ctx, array);
    // Forms and the floors of rigid rows were chosen at these poses.
    array(ctx.state.analysed_x);
    array(ctx.state.analysed_r);
    visit_contacts(ctx, array);
    value(ctx.model.collider.last_awake_count());
    value(ctx.model.cuts.asked);
    // After repeated repairs the order of elimination depends on the past.
    array(order.elimination.order);
    array(order.at_branch_meeting);
    array(order.elimination.chains.nodes);
    array(order.elimination.chains.unit_begin);
    array(order.elimination.chains.begin);
    array(order.elimination.chains.body_size);
    array(order.elimination.chains.reach);
    value(order.planned_flops);
    array(inputs);
    visit_values(ctx, value);
}

/// The state read from bytes, sized by the header and the target world. It has the members of a
/// StepContext that visit_state() visits.
struct SavedState {
    /// Allocate the arrays.
    /// @param header  With counts that fit into the available bytes.
    /// @throws std::bad_alloc.
    SavedState(const context::StepContext& ctx, const std::vector<double>& inputs,
               const Header& header);
    /// Return the size of all arrays of the state [bytes].
    [[nodiscard]] std::uint64_t size();
    /// Read all arrays from a saved state of size() bytes.
    void read(std::span<const std::byte> from);

    struct {
        struct {
            base::Array<double> x, q, r, v, v_start, v_fixed, spin_change, force;
            base::Array<std::uint8_t> asleep;
            base::Array<std::int32_t> quiet;
        } bodies;
        struct {
            base::Array<double> lambda, force, active, anchor;
            base::Array<std::uint8_t> parted, coarse, repeats;
            std::vector<std::uint8_t> saturated;
        } interactions;
        struct {
            std::vector<double> energy_allowance;
            std::vector<std::int32_t> flag_steps, recoil;
        } wires;
        struct {
            base::Array<collide::KeptContact> contacts;
            std::uint64_t awake = 0;
            [[nodiscard]] auto& last_contacts() noexcept { return contacts; }
            [[nodiscard]] auto& last_awake_count() noexcept { return awake; }
        } collider;
        struct {
            struct {
                base::Array<assembly::ContactMemory> memory;
                struct {
                    base::Array<assembly::ResistanceMemory> memory;
                } resistances;
                std::vector<assembly::Contacts::Link> links;
                std::vector<std::int64_t> link_used;
            } contacts;
        } system;
        struct {
            std::uint64_t asked = 0;
        } cuts;
        struct {
            struct {
                std::vector<std::int32_t> part;
                std::int32_t parts = 0, worse_for = 0;
            } parts;
            std::int64_t made = 0, seen = 0;
        } regroup;
    } model;
    struct {
        struct {
            double work = 0.0, water = 0.0, added = 0.0;
        } loads;
        struct {
            context::MonitorState state;
        } monitor;
        base::Array<double> analysed_x, analysed_r;
        std::int64_t step = 0;
        /// A byte, because values other than 0 and 1 are not a valid bool.
        std::uint8_t started = 0;
        int refine_unasked = 0;
        context::Ledger ledger;
    } state;
    struct {
        struct {
            std::array<std::int64_t, kEventKindCount> event_count{};
        } stats;
    } work;
    factor::AnalysisState order;
    std::vector<double> inputs;
};

/// Allocate the arrays of an elimination order with the sizes of a header.
[[nodiscard]] factor::AnalysisState allocate_order(const Header& header);

/// Check that a world can continue from a state: valid indices, finite numbers, consistent counts
/// and steps. The analysis checks that the elimination order belongs to the system's pattern.
/// @param inputs  Their definitions.
/// @throws DefError with the name of the quantity.
void check_state(const context::StepContext& ctx, const std::vector<InputDef>& inputs,
                 const SavedState& state);

}  // namespace hawser::world
