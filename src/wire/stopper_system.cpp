// SPDX-License-Identifier: Apache-2.0
#include "wire/stopper_system.h"

#include <hawser/world.h>

#include "wire/lift.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

namespace hawser::wire {
namespace {

constexpr double kMasslessLinkLength = 1.0;  ///< Link of a chain stopper [m].
constexpr double kRatedDeflection = 1e-3;  ///< Deflection of a chain stopper at its rated load [m].
constexpr double kMaxStraightAngle = 0.05;   ///< Angle below which a node is not needed [rad].
constexpr std::int32_t kMaxIdleSteps = 300;  ///< Steps after which it is removed at any angle.
/// Hauled length after which a chain stopper uses another node [m].
constexpr double kMinHaulForNewNode = 3.0;
constexpr std::int32_t kStepsBetweenRemovals =
    15;  ///< Steps between tries to take an idle node away.

/// Return true if another stopper holds the node.
bool held_by_other_stopper(const World& world, const StopperSystem& by, BodyId lump) noexcept {
    for (const SystemSignal& s : world.system_signals()) {
        if (s.name != "close" || s.system == by.name()) continue;
        const auto* other = dynamic_cast<const StopperSystem*>(world.find_system(s.system));
        if (other != nullptr && other->node() == lump) return true;
    }
    return false;
}

}  // namespace

StopperSystem::StopperSystem(StopperDef def)
    : def_(std::move(def)), joint_name_(def_.name + "/hold"), close_(def_.closed ? 1.0 : 0.0) {}

void StopperSystem::visit_state(StateVisitor& v) {
    const auto visit = [&v](auto& id) {
        v.visit(id.index);
        v.visit(id.generation);
    };
    for (BodyId* id : {&node_, &inserted_}) visit(*id);
    for (BodyId& id : idle_nodes_) visit(id);
    visit(joint_);
    for (std::int32_t* x : {&state_, &after_, &reported_, &idle_steps_}) v.visit(*x);
    for (double* x : {&close_, &closing_distance_, &hauled_length_, &state_output_, &wire_output_,
                      &load_, &at_})
        v.visit(*x);
    v.visit(std::span<double>(closing_position_));
}

void StopperSystem::check_state(const World& world, StateRules& rules) const {
    const auto known = [](std::int32_t state) {
        return state >= 0 && state <= static_cast<std::int32_t>(StopperState::tripped);
    };
    rules.require(known(state_) && known(after_), "there is no such state of the stopper");
    rules.flag(reported_, "whether an event is due is no flag");
    rules.require(idle_steps_ >= 0 && idle_steps_ < 2'000'000'000,
                  "the steps of idle nodes are out of range");
    const auto lump = [&](BodyId id) {
        return !id.valid() || !world.alive(id) || world.body_def(id).kind == BodyKind::lump;
    };
    rules.require(lump(node_) && lump(inserted_), "the stopper holds no node of a wire");
    for (const BodyId id : idle_nodes_) rules.require(lump(id), "an idle node is none of a wire");
    const Vec3 place(closing_position_[0], closing_position_[1], closing_position_[2]);
    rules.require(place.allFinite() && place.norm() <= 1e7, "the position is out of range");
    if (!world.alive(joint_)) return;  // removed by another system
    const InteractionDef& d = world.interaction_def(joint_);
    rules.require(d.name == joint_name_ && d.body[0] == def_.body && d.body[1] == node_,
                  "the stopper's joint is another one");
}

void StopperSystem::signals(SignalTable& table) {
    table.input("close", "1", close_, 0.0, 1.0);
    table.output("state", "1", state_output_);
    table.output("held", "1", wire_output_);
    table.output("load", "N", load_);
    table.output("at", "m", at_);
}

PointOnWire StopperSystem::nearest_wire_point(const World& world) const noexcept {
    const auto all = [](const auto&) { return true; };
    return nearest_on_wire(world, world.world_point(def_.body, def_.point), 0.0, all, all);
}

std::optional<StopperClaim> StopperSystem::node_to_hold(const World& world) const noexcept {
    const PointOnWire found = nearest_wire_point(world);
    if (!(found.distance <= def_.reach)) return std::nullopt;
    StopperClaim out{found.wire, 0.0};
    for (const InteractionId id : world.wires().elements(found.wire)) {
        if (id == found.element) break;
        if (world.alive(id)) out.at += rest_length(world, id);
    }
    // By the rules of node_at().
    const InteractionDef& d = world.interaction_def(found.element);
    const double length = d.get("length"), least = kStopperAtNode / length;
    const double way = length * std::min(found.fraction, 1.0 - found.fraction);
    const bool divides = d.get("mass") > 0.0 && least < 0.5 && way > kStopperAtNode;
    out.at += length * (divides ? found.fraction : std::round(found.fraction));
    return out;
}

/// Return the node to hold; invalid if none is within reach.
BodyId StopperSystem::node_at(NodeEdits& nodes, const PointOnWire& found) noexcept {
    const World& world = nodes.world;
    const InteractionDef& d = world.interaction_def(found.element);
    const double length = d.get("length");
    const std::size_t end = found.fraction < 0.5 ? 0 : 1;
    const auto lump = [&](std::size_t k) {
        return world.body_def(d.body[k]).kind == BodyKind::lump;
    };
    const double way = length * (end == 0 ? found.fraction : 1.0 - found.fraction);
    if (way <= kStopperAtNode && lump(end)) return d.body[end];
    const double least = kStopperAtNode / length;
    if (least < 0.5) {
        const double fraction = std::clamp(found.fraction, least, 1.0 - least);
        inserted_ = nodes.insert_node(found.element, fraction);
        if (inserted_.valid()) return inserted_;
    }
    const Vec3 at = world.world_point(def_.body, def_.point);
    if (lump(end) && (world.pose(d.body[end]).position - at).norm() <= def_.reach)
        return d.body[end];
    return {};
}

/// Set the outputs to the position on the wire at which the stopper holds it.
void StopperSystem::report_joint(const World& world, const PointOnWire& found) noexcept {
    wire_output_ = wire_number(world, found.wire);
    at_ = 0.0;
    for (const InteractionId id : world.wires().elements(found.wire)) {
        if (!world.alive(id)) continue;
        const double rest = rest_length(world, id);
        at_ += id == found.element ? found.fraction * rest : rest;
        if (id == found.element) return;
    }
}

void StopperSystem::close_on_wire(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    const PointOnWire found = nearest_wire_point(world);
    closing_distance_ = found.distance;
    reported_ = 0;
    if (found.distance <= def_.reach) {
        report_joint(world, found);
        node_ = node_at(nodes, found);
    }
    if (node_.valid() && held_by_other_stopper(world, *this, node_)) node_ = {};
    if (!node_.valid()) {
        wire_output_ = at_ = 0.0;
        set_state(StopperState::empty);
        return;
    }
    const Vec3 place = world.local_point(def_.body, world.pose(node_).position);
    std::copy_n(place.data(), 3, closing_position_);
    hauled_length_ = 0.0;
    set_state(StopperState::closing);
}

/// Remove nodes that the stopper inserted and no longer needs. A node at which the wire remains
/// bent is removed after a time limit.
void StopperSystem::remove_idle_nodes(NodeEdits& nodes) noexcept {
    if (++idle_steps_ % kStepsBetweenRemovals != 0) return;
    const double bend = idle_steps_ > kMaxIdleSteps ? std::numbers::pi : kMaxStraightAngle;
    for (BodyId& id : idle_nodes_)
        if (id.valid() && id != node_ && (!nodes.world.alive(id) || nodes.remove_node(id, bend)))
            id = {};
}

void StopperSystem::before_step(NodeEdits& nodes) noexcept {
    remove_idle_nodes(nodes);
    if (in_state(StopperState::open) && close_ >= 0.5) close_on_wire(nodes);
}

/// Create the joint between the body and the node at its current position.
void StopperSystem::make_joint(Prestep& now) noexcept {
    if (!now.world.alive(node_)) {  // removed since by the system that feeds its wire
        node_ = {};
        set_state(StopperState::open);
        return;
    }
    const Vec3 place(closing_position_[0], closing_position_[1], closing_position_[2]);
    InteractionDef def;
    def.name = joint_name_;
    def.body = {def_.body, node_};
    if (def_.pitch > 0.0) {
        def.kind = InteractionKind::Stretch;
        def.point[0] = place - kMasslessLinkLength * def_.outboard.normalized();
        def.set("length", kMasslessLinkLength)
            .set("EA", def_.rated_load * kMasslessLinkLength / kRatedDeflection);
    } else {
        def.kind = InteractionKind::Ball;
        def.point[0] = place;
    }
    (void)now.edits.add_interaction(def);
    set_state(StopperState::holding);
}

void StopperSystem::update_hold(Prestep& now) noexcept {
    const World& world = now.world;
    if (!joint_.valid()) joint_ = world.find_interaction(joint_name_);
    if (!world.alive(joint_)) {  // removed by another system, or with its node
        joint_ = {};
        node_ = inserted_ = {};
        wire_output_ = load_ = at_ = 0.0;
        set_state(StopperState::empty);
        return;
    }
    const bool ratchet = def_.pitch > 0.0;
    const auto force = world.force(joint_);
    load_ = ratchet ? std::max(0.0, -force[0]) : Vec3(force[0], force[1], force[2]).norm();
    if (reported_ == 0) now.tell(EventKind::join, joint_, closing_distance_);
    reported_ = 1;
    const auto go = [&](EventKind kind, StopperState then) {
        now.tell(kind, joint_, load_);
        after_ = static_cast<std::int32_t>(then);
        set_state(StopperState::opening);
    };
    if (close_ < 0.5) return go(EventKind::detach, StopperState::open);
    if (load_ > def_.rated_load) return go(EventKind::overload, StopperState::tripped);
    if (!ratchet) return;
    const Vec3 place = world.local_point(def_.body, world.pose(node_).position);
    const Vec3 came =
        Vec3(closing_position_[0], closing_position_[1], closing_position_[2]) - place;
    const double in = came.dot(def_.outboard.normalized());
    if (in < def_.pitch) return;
    // The pawl falls. The same node is held, farther in, until another one is much nearer.
    hauled_length_ += in;
    std::copy_n(place.data(), 3, closing_position_);
    after_ = static_cast<std::int32_t>(hauled_length_ < kMinHaulForNewNode ? StopperState::closing
                                                                           : StopperState::open);
    set_state(StopperState::opening);
}

void StopperSystem::release_wire(Prestep& now) noexcept {
    if (now.world.alive(joint_)) now.edits.remove_interaction(joint_);
    if (after_ == static_cast<std::int32_t>(StopperState::closing)) {
        joint_ = {};
        state_ = after_;
        return;
    }
    if (inserted_.valid()) {  // the oldest of many stays on its wire
        std::rotate(idle_nodes_.begin(), idle_nodes_.end() - 1, idle_nodes_.end());
        idle_nodes_.front() = inserted_;
        idle_steps_ = 0;
    }
    node_ = inserted_ = {};
    joint_ = {};
    wire_output_ = load_ = at_ = 0.0;
    state_ = after_;
}

void StopperSystem::prestep(Prestep& now, Loads&) noexcept {
    if (close_ < 0.5 && (in_state(StopperState::empty) || in_state(StopperState::tripped)))
        set_state(StopperState::open);
    if (in_state(StopperState::empty) && reported_ == 0) {
        now.tell(EventKind::missed, def_.body, closing_distance_);
        reported_ = 1;
    } else if (in_state(StopperState::closing)) {
        make_joint(now);
    } else if (in_state(StopperState::holding)) {
        update_hold(now);
    } else if (in_state(StopperState::opening)) {
        release_wire(now);
    }
    state_output_ = static_cast<double>(state_);
}

}  // namespace hawser::wire
