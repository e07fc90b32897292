// SPDX-License-Identifier: Apache-2.0
/// Checks of a state read from bytes. A valid checksum does not make the content valid, and a later
/// step uses indices from a file as addresses.
#include "base/index.h"
#include "context/wire_alerts.h"
#include "solve/wires.h"
#include "world/saved_state.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace hawser::world {
namespace {

/// Far beyond any scene; below it no product of a few of them overflows [m, m/s].
constexpr double kMaxPosition = 1e15;
/// Limit of forces, impulses, energies [N, N s, J].
constexpr double kMaxForce = 1e40;
/// Largest number of steps that a double represents exactly.
constexpr std::int64_t kMaxSteps = std::int64_t{1} << 53;
constexpr double kUnitTolerance =
    1e-6;  ///< Tolerance of quaternion norms and entries of rotations.
/// Largest number of steps at rest, see step/sleep.cpp.
constexpr std::int32_t kMaxQuiet = 1'000'000'000;

[[noreturn]] void throw_state_error(const std::string& what) {
    throw DefError("snapshot: not a state that a world can have: " + what);
}

std::string entry(std::size_t i) { return " (entry " + std::to_string(i) + ")"; }

void check_numbers(std::span<const double> array, const char* what, double most) {
    for (std::size_t i = 0; i < array.size(); ++i)
        if (!(std::abs(array[i]) <= most))
            throw_state_error(
                std::string(what) +
                (std::isfinite(array[i]) ? " is out of range" : " is not a finite number") +
                entry(i));
}

void check_number(double value, const char* what, double most = kMaxForce) {
    check_numbers(std::span(&value, 1), what, most);
}

template <class A>
void check_flags(const A& array, const char* what) {
    for (std::size_t i = 0; i < array.size(); ++i)
        if (array[i] != 0 && array[i] != 1)
            throw_state_error(std::string(what) + " is no flag" + entry(i));
}

/// Return true if the norm of a quaternion is 1 to within `off`.
bool unit(const double* q, double off) {
    const double n = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    return std::abs(n - 1.0) <= off;
}

bool rotation_matches(const double* r, const double* q) {
    const Mat3 m = Quat(q[0], q[1], q[2], q[3]).toRotationMatrix();
    for (int i = 0; i < 9; ++i)
        if (!(std::abs(r[i] - m(i / 3, i % 3)) <= kUnitTolerance)) return false;
    return true;
}

void check_bodies(const context::StepContext& ctx, const SavedState& s) {
    check_numbers(s.model.bodies.x, "a position", kMaxPosition);
    check_numbers(s.model.bodies.v, "a velocity", kMaxPosition);
    check_numbers(s.model.bodies.v_start, "a predicted velocity", kMaxPosition);
    check_numbers(s.model.bodies.v_fixed, "a prescribed velocity", kMaxPosition);
    check_numbers(s.model.bodies.spin_change, "a change of spin", kMaxPosition);
    check_numbers(s.model.bodies.force, "an applied force", 1e300);  // the limit of the setters
    check_numbers(s.state.analysed_x, "an analysed position", kMaxPosition);
    check_numbers(s.state.analysed_r, "an analysed rotation", 2.0);
    check_flags(s.model.bodies.asleep, "sleep");
    for (std::size_t b = 0; b < at(ctx.model.bodies.count()); ++b) {
        const double* q = &s.model.bodies.q[4 * b];
        if (!unit(q, kUnitTolerance)) throw_state_error("an orientation is no rotation" + entry(b));
        // Also for nodes, because ghost bodies of cut lines copy theirs.
        if (!rotation_matches(&s.model.bodies.r[9 * b], q))
            throw_state_error("a rotation is not that of the orientation" + entry(b));
        if (s.model.bodies.asleep[b] != 0 && ctx.model.bodies.dof(static_cast<int>(b)) == 0)
            throw_state_error("a body that cannot move is asleep" + entry(b));
        if (s.model.bodies.quiet[b] < 0 || s.model.bodies.quiet[b] > kMaxQuiet)
            throw_state_error("a time at rest is out of range" + entry(b));
    }
    check_numbers(s.model.bodies.r, "a rotation", 2.0);
}

void check_interactions(const context::StepContext& ctx, const SavedState& s) {
    check_numbers(s.model.interactions.lambda, "an impulse", kMaxForce);
    check_numbers(s.model.interactions.force, "a force", kMaxForce);
    check_numbers(s.model.interactions.anchor, "an anchor of friction, or turns of a line",
                  kMaxPosition);
    for (const std::int32_t id : ctx.model.interactions.spans)
        if (const double turns = s.model.interactions.anchor[at(id)]; turns != std::round(turns))
            throw_state_error("turns of a line on its wheel are no whole number");
    check_numbers(s.model.wires.energy_allowance, "the energy allowance of a wire", kMaxForce);
    for (std::size_t k = 0; k < s.model.wires.energy_allowance.size(); ++k)
        if (s.model.wires.energy_allowance[k] < 0.0 || s.model.wires.flag_steps[k] < 0 ||
            s.model.wires.flag_steps[k] > context::max_flag_steps(ctx.model.def.step) ||
            s.model.wires.recoil[k] < context::Wires::kBeginsToRecoil ||
            s.model.wires.recoil[k] > context::max_recoil(ctx.model.def.step))
            throw_state_error("a wire's guard is out of range" + entry(k));
    check_flags(s.model.interactions.active, "which rows act");
    check_flags(s.model.interactions.parted, "the flag of a broken line");
    check_flags(s.model.interactions.saturated, "which motors are at a limit");
    check_flags(s.model.interactions.repeats, "the flag of a redundant joint");
    for (std::size_t i = 0; i < s.model.interactions.parted.size(); ++i)
        if (s.model.interactions.parted[i] != 0 &&
            (ctx.model.interactions.gone(static_cast<int>(i)) ||
             !kind_info(ctx.model.interactions.def[i].kind).is(kWireElement)))
            throw_state_error("an interaction that cannot break is broken" + entry(i));
}

/// Return true if the bodies that a contact stores for a side are those of the shape.
bool fits_shape(const std::int32_t (&body)[2], const collide::Shape& shape) {
    const auto of_shape = [&](std::int32_t b) { return b == shape.body[0] || b == shape.body[1]; };
    return body[0] >= 0 && of_shape(body[0]) &&
           (body[1] == -1 || (body[1] >= 0 && of_shape(body[1])));
}

bool is_sorted_after(const collide::KeptContact& a, const collide::KeptContact& b) {
    return a.shape[0] != b.shape[0] ? a.shape[0] > b.shape[0] : a.shape[1] > b.shape[1];
}

void check_contacts(const context::StepContext& ctx, const SavedState& s) {
    const auto& kept = s.model.collider.contacts;
    const auto& memory = s.model.system.contacts.memory;
    const std::vector<collide::Shape>& shapes = ctx.model.collider.shapes();
    if (s.model.collider.awake > kept.size())
        throw_state_error("the number of active contacts exceeds the number of contacts");
    for (std::size_t i = 0; i < kept.size(); ++i) {
        const collide::KeptContact& k = kept[i];
        const auto count = static_cast<std::int32_t>(shapes.size());
        if (k.shape[0] < 0 || k.shape[0] >= k.shape[1] || k.shape[1] >= count || k.zero != 0)
            throw_state_error("a contact is of shapes that there are not" + entry(i));
        if (i > 0 && i != s.model.collider.awake && is_sorted_after(kept[i - 1], k))
            throw_state_error("contacts are not in their order" + entry(i));
        check_numbers(k.at, "the position of a contact", kMaxPosition);
        const assembly::ContactMemory& m = memory[i];
        check_numbers(m.fraction, "the fraction of a contact between the nodes of its wire", 2.0);
        check_numbers(m.anchor[0], "the anchor of a contact", kMaxPosition);
        check_numbers(m.anchor[1], "the anchor of a contact", kMaxPosition);
        check_numbers(m.rolled, "the violation of a contact", kMaxPosition);
        check_numbers(m.lambda, "the impulse of a contact", kMaxForce);
        const bool nothing =
            std::equal(&m.body[0][0], &m.body[0][0] + 4, &assembly::kNoMemory.body[0][0]);
        const bool known = fits_shape(m.body[0], shapes[at(k.shape[0])]) &&
                           fits_shape(m.body[1], shapes[at(k.shape[1])]);
        if (!nothing && !known)
            throw_state_error("a contact remembers bodies that it has not" + entry(i));
    }
}

void check_resistances(const SavedState& s) {
    std::int32_t before = -1;
    std::size_t i = 0;
    for (const assembly::ResistanceMemory& m : s.model.system.contacts.resistances.memory) {
        if (m.contact <= before || at(m.contact) >= s.model.collider.contacts.size())
            throw_state_error("a resistance is of a contact that there is not" + entry(i));
        before = m.contact;
        if (m.renewed != 0 && m.renewed != 1)
            throw_state_error("a resistance has no such flag" + entry(i));
        check_numbers(m.reference, "the reference of a resistance", 2.0);
        if (m.renewed == 0 && !unit(m.reference, kUnitTolerance))
            throw_state_error("the reference of a resistance is no rotation" + entry(i));
        check_numbers(m.turned, "the turn of a resistance", kMaxPosition);
        check_numbers(m.lambda, "the impulse of a resistance", kMaxForce);
        ++i;
    }
}

void check_links(const context::StepContext& ctx, const SavedState& s) {
    std::vector<std::uint8_t> touches(at(ctx.model.bodies.count()), 0);
    for (const collide::Shape& shape : ctx.model.collider.shapes())
        for (const std::int32_t b : shape.body)
            if (b >= 0) touches[at(b)] = ctx.model.bodies.dof(b) > 0 ? 1 : 0;
    const auto& links = s.model.system.contacts.links;
    for (std::size_t i = 0; i < links.size(); ++i) {
        const auto [first, second] = links[i];
        if (first < 0 || first >= second || at(second) >= touches.size() ||
            touches[at(first)] == 0 || touches[at(second)] == 0)
            throw_state_error("bodies are linked that cannot touch" + entry(i));
        if (i > 0 && !(links[i - 1] < links[i]))
            throw_state_error("links are not in their order" + entry(i));
        const std::int64_t used = s.model.system.contacts.link_used[i];
        if (used < 0 || used > s.state.step)
            throw_state_error("a link was used at no step" + entry(i));
    }
}

/// Check an elimination order as far as possible without the pattern.
void check_order(const factor::AnalysisState& order) {
    check_flags(order.at_branch_meeting, "an index in the order of elimination");
    std::vector<std::uint8_t> seen(order.elimination.order.size(), 0);
    for (const std::int32_t node : order.elimination.order) {
        if (node < 0 || at(node) >= seen.size() || seen[at(node)] != 0)
            throw_state_error("the order of elimination is none");
        seen[at(node)] = 1;
    }
    if (order.planned_flops < 0) throw_state_error("work is negative");
}

void check_counts(const context::StepContext& ctx, const SavedState& s) {
    if (s.state.step < 0 || s.state.step > kMaxSteps) throw_state_error("the step is out of range");
    if (s.state.started > 1) throw_state_error("the start is no flag");
    const auto sleeps = [](std::uint8_t flag) { return flag != 0; };
    if (s.state.started == 0 &&
        (s.state.step != 0 || !s.model.collider.contacts.empty() ||
         std::any_of(s.model.bodies.asleep.begin(), s.model.bodies.asleep.end(), sleeps)))
        throw_state_error("something has happened before the start");
    if (s.state.refine_unasked < 0 || s.state.refine_unasked > 1'000'000)
        throw_state_error("refinements are out of range");
    for (const std::int64_t n : s.work.stats.event_count)
        if (n < 0) throw_state_error("a count of events is negative");
    const context::MonitorState& j = s.state.monitor.state;
    check_numbers(std::array{j.kinetic, j.potential, j.elastic, j.by_length, j.by_force, j.posed,
                             j.held, j.given, j.exchanged, j.counted, j.age, j.closed,
                             j.closed_elastic, j.unsolved, j.open_start, j.held_time},
                  "a value of the monitors", 1e300);
    check_numbers(j.mean, "a value of the monitors", 1e300);
    check_numbers(j.work, "a value of the monitors", 1e300);
    check_numbers(j.stretched, "a value of the monitors", 1e300);
    check_numbers(j.lasting_rise, "a value of the monitors", 1e300);
    check_numbers(j.overlong, "a value of the monitors", 1e300);
    check_numbers(j.wound, "a value of the monitors", 1e300);
    check_numbers(j.beyond, "a value of the monitors", 1e300);
    check_numbers(j.deep, "a value of the monitors", 1e300);
    for (const auto& extremes : {j.now_extremes, j.mean_extremes})
        for (const context::DecayingExtremes& tide : extremes)
            check_numbers(std::array{tide.least, tide.most}, "a value of the monitors", 1e300);
    check_flags(std::span(j.reported).first(kJudgeCount), "a flag of the monitors");
    if (j.step < 0 || j.step > s.state.step || j.begun < 0 || j.begun > s.state.step + 1)
        throw_state_error("the monitors have checked no step");
    const double energies[] = {
        s.state.ledger.work,         s.state.ledger.drag,           s.state.ledger.drive,
        s.state.ledger.friction,     s.state.ledger.contact,        s.state.ledger.damped,
        s.state.loads.work,          s.state.loads.water,           s.state.loads.added,
        s.state.ledger.edited.given, s.state.ledger.edited.strained};
    check_numbers(energies, "an energy", 1e300);
    const auto& r = s.model.regroup;
    if (r.made < 0 || r.made > s.state.step || r.seen < -1 || r.seen > s.state.step ||
        r.parts.worse_for < 0 || r.parts.worse_for > kMaxQuiet ||
        r.parts.parts != ctx.model.regroup.parts.parts)
        throw_state_error("groups were made at no step");
}

}  // namespace

void check_state(const context::StepContext& ctx, const std::vector<InputDef>& inputs,
                 const SavedState& state) {
    check_counts(ctx, state);
    check_bodies(ctx, state);
    check_interactions(ctx, state);
    check_contacts(ctx, state);
    check_resistances(state);
    check_links(ctx, state);
    check_order(state.order);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        check_number(state.inputs[i], "an input", 1e300);
        // Without a set input the value may lie outside the input's range.
        const InteractionDef* d = inputs[i].interaction.valid()
                                      ? &ctx.model.interactions.def[at(inputs[i].interaction.index)]
                                      : nullptr;
        if (d == nullptr) continue;
        for (const ParamInfo& p : kind_info(d->kind).params)
            if (inputs[i].param == p.name &&
                !(state.inputs[i] >= p.min && state.inputs[i] <= p.max))
                throw_state_error("input '" + inputs[i].name +
                                  "' is outside the range of its parameter");
    }
}

}  // namespace hawser::world
