// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file saved_state.h
/// The arrays of a snapshot in their order, and a place to read them to before a world takes them.

#include "context/context.h"
#include "world/impl.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace hawser::world {

/// Identifies the world's layout and says how much follows.
struct Header {
    char magic[8] = {'H', 'A', 'W', 'S', 'N', 'P', '2', '7'};
    std::uint64_t layout = 0;       ///< See layout_of().
    std::uint64_t parameters = 0;   ///< See parameters_of().
    std::uint64_t contacts = 0;     ///< Remembered from the last step.
    std::uint64_t resistances = 0;  ///< Those of them that resist rolling or spinning.
    std::uint64_t links = 0;        ///< Pairs of bodies that touched.
    std::uint64_t nodes = 0;        ///< Of the order of elimination.
    std::uint64_t chained = 0, units = 0, chains = 0;  ///< Nodes in chains, and so on.
    std::uint64_t grouped = 0;  ///< Bodies whose groups follow the state: all or none.
    std::uint64_t bytes = 0;    ///< Of the arrays that follow.
    std::uint64_t systems = 0;  ///< Names and sizes of systems, whose states come last.
    std::uint64_t system_bytes = 0;
};

/// Groups that follow the state, which come first: how many images and copies there are depends
/// on them.
template <class Groups, class F>
void visit_groups(Groups& groups, F&& f) {
    f(groups.parts.part.data(), groups.parts.part.size() * sizeof(std::int32_t));
    f(&groups.parts.parts, sizeof groups.parts.parts);
    f(&groups.parts.worse_for, sizeof groups.parts.worse_for);
    f(&groups.made, sizeof groups.made);
    f(&groups.seen, sizeof groups.seen);
}

/// Visit what moves and what remembers, of bodies, interactions and wires: f(array) in a fixed
/// order. Of two worlds with the same definitions that couple otherwise, the arrays agree in front.
template <class Context, class F>
void visit_motion(Context& ctx, F&& f) {
    f(ctx.model.bodies.x);
    f(ctx.model.bodies.q);
    // Kept, not computed anew: the integrator's kernel rounds as its instruction set does.
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
    f(ctx.model.wires.credit);
    f(ctx.model.wires.alert);
    f(ctx.model.wires.recoil);
}

/// Visit the single values of the state: f(value).
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
    f(ctx.state.judge.state);
    f(ctx.work.stats.event_count);
}

/// Visit contacts that are remembered: f(array).
template <class Context, class F>
void visit_contacts(Context& ctx, F&& f) {
    f(ctx.model.collider.kept());
    f(ctx.model.system.contacts.memory);
    f(ctx.model.system.contacts.resistances.memory);
    f(ctx.model.system.contacts.links);
    f(ctx.model.system.contacts.link_used);
}

/// Visit every array of the state with f(pointer, bytes).
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
    value(ctx.model.collider.kept_awake());
    value(ctx.model.cuts.asked);
    // Repaired again and again, the order of elimination depends on the past.
    array(order.elimination.order);
    array(order.between);
    array(order.elimination.chains.nodes);
    array(order.elimination.chains.unit_begin);
    array(order.elimination.chains.begin);
    array(order.elimination.chains.body_size);
    array(order.elimination.chains.reach);
    value(order.planned_flops);
    array(inputs);
    visit_values(ctx, value);
}

/// The state as bytes say it, sized by the header and by the world that is to take it: it has the
/// members of a StepContext that visit_state() visits.
struct SavedState {
    /// @param header  Its counts fit into the bytes that there are. @throws std::bad_alloc.
    SavedState(const stepper::StepContext& ctx, const std::vector<double>& inputs,
               const Header& header);
    /// How many bytes all arrays of the state take.
    [[nodiscard]] std::uint64_t size();
    /// Take all from bytes, of which there are size().
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
            std::vector<double> credit;
            std::vector<std::int32_t> alert, recoil;
        } wires;
        struct {
            base::Array<collide::KeptContact> contacts;
            std::uint64_t awake = 0;
            [[nodiscard]] auto& kept() noexcept { return contacts; }
            [[nodiscard]] auto& kept_awake() noexcept { return awake; }
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
            stepper::JudgeState state;
        } judge;
        base::Array<double> analysed_x, analysed_r;
        std::int64_t step = 0;
        std::uint8_t started = 0;  ///< A byte: any other than 0 and 1 is no bool.
        int refine_unasked = 0;
        stepper::Ledger ledger;
    } state;
    struct {
        struct {
            std::array<std::int64_t, kEventKindCount> event_count{};
        } stats;
    } work;
    factor::AnalysisState order;
    std::vector<double> inputs;
};

/// Arrays for an order of elimination.
[[nodiscard]] factor::AnalysisState room_for_order(const Header& header);

/// Whether a world may go on from a state: indices that exist, numbers that are finite, counts and
/// steps that agree. What is not looked at here is whether the order of elimination is one of the
/// system's pattern, which the analysis tells.
/// @param inputs  Their definitions. @throws DefError that names the quantity.
void check_state(const stepper::StepContext& ctx, const std::vector<InputDef>& inputs,
                 const SavedState& state);

}  // namespace hawser::world
