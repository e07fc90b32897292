// SPDX-License-Identifier: Apache-2.0
#include "wire/chaser_system.h"

#include <hawser/world.h>

#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <utility>

namespace hawser::wire {
namespace {

/// Fraction of an element at its ends in which the ring is not placed. A part of almost no length
/// would be rigid.
constexpr double kFromEnd = 0.06;
constexpr std::int32_t kTryAgain = 15;  ///< Steps until the next try after a wire was rejected.

std::unique_ptr<GuideSystem> no_guide(const ChaserDef& def) {
    GuideDef guide;
    guide.name = def.name;
    guide.body = def.body;
    guide.friction = def.friction;
    guide.element_length = def.element;
    return guide_without_wire(std::move(guide));
}

}  // namespace

ChaserSystem::ChaserSystem(ChaserDef def)
    : def_(std::move(def)), guide_(no_guide(def_)), close_(def_.closed ? 1.0 : 0.0) {}

void ChaserSystem::visit_state(StateVisitor& v) {
    for (std::int32_t* x : {&state_, &due_event_, &reached_, &steps_until_retry_}) v.visit(*x);
    for (double* x : {&close_, &value_, &state_output_, &wire_output_, &start_distance_,
                      &end_distance_, &arrived_, &angle_, &speed_, &tension_[0], &tension_[1]})
        v.visit(*x);
    guide_->visit_geometry(v);
    guide_->visit_state(v);
}

void ChaserSystem::check_state(const World& world, StateRules& rules) const {
    rules.require(state_ >= 0 && state_ <= static_cast<std::int32_t>(ChaserState::on),
                  "there is no such state of the chaser");
    rules.require(due_event_ >= 0 && due_event_ <= static_cast<std::int32_t>(Due::let_go),
                  "the chaser has nothing such to report");
    rules.require(reached_ >= 0 && reached_ <= 2, "there is no such end of the wire");
    rules.require(steps_until_retry_ >= 0 && steps_until_retry_ <= kTryAgain,
                  "the wait of the chaser is out of range");
    rules.range(arrived_, 0.0, 2.0, "there is no such end of the wire");
    if (!in_state(ChaserState::on)) return;
    // A removed wire is released before the next step.
    const Guide& ids = guide_->ids();
    if (world.alive(ids.slide) && world.alive(ids.before) && world.alive(ids.behind) &&
        world.alive(ids.friction))
        guide_->check_position(world, rules);
    guide_->check_state(world, rules);
}

void ChaserSystem::signals(SignalTable& table) {
    table.input("close", "1", close_, 0.0, 1.0);
    table.output("state", "1", state_output_);
    table.output("held", "1", wire_output_);
    table.output("at", "m", start_distance_);
    table.output("left", "m", end_distance_);
    table.output("arrived", "1", arrived_);
    table.output("before", "N", tension_[0]);
    table.output("behind", "N", tension_[1]);
    table.output("angle", "rad", angle_);
    table.output("speed", "m/s", speed_);
}

void ChaserSystem::holds(HoldTable& table) const {
    table.hold(def_.body);
    if (in_state(ChaserState::on)) guide_->holds(table);
}

/// Find the nearest point of wires that are not fastened to the ring, on elements whose nodes can
/// run through.
PointOnWire ChaserSystem::nearest_wire_point(const World& world) const {
    const auto loose = [&](WireId wire) {
        const auto nodes = world.wires().nodes(wire);
        return std::find(nodes.begin(), nodes.end(), def_.body) == nodes.end();
    };
    return nearest_on_wire(world, world.world_point(def_.body, def_.point), kFromEnd, loose,
                           [](const InteractionDef& d) { return d.get("mass") > 0.0; });
}

/// Close the ring on the nearest wire. The eye is placed on the wire, so that closing causes no
/// force.
void ChaserSystem::close_on_wire(NodeEdits& nodes) {
    const World& world = nodes.world;
    if (steps_until_retry_ > 0) {
        --steps_until_retry_;
        return;
    }
    const PointOnWire found = nearest_wire_point(world);
    const auto miss = [&] {
        const bool was_waiting = in_state(ChaserState::waiting);
        value_ = found.distance;
        set_state(ChaserState::waiting, was_waiting ? Due::nothing : Due::missed);
    };
    if (!(found.distance <= def_.reach)) return miss();
    const InteractionDef element = world.interaction_def(found.element);
    const std::array<Vec3, 2> ends = world.wires().ends(found.element);
    GuideDef def = no_guide(def_)->def();
    def.wire = found.wire;
    def.element = found.element;
    def.point = world.local_point(def_.body, found.at);
    const Twist ring = world.velocity(def_.body);
    const Vec3 moves = ring.linear + ring.angular.cross(found.at - world.pose(def_.body).position);
    const Vec3 wire = (1.0 - found.fraction) * world.velocity(element.body[0]).linear +
                      found.fraction * world.velocity(element.body[1]).linear;
    const double speed = (wire - moves).dot((ends[1] - ends[0]).normalized());
    auto made = engage_guide(nodes, std::move(def), speed);
    if (made == nullptr) {
        steps_until_retry_ = kTryAgain;
        return miss();
    }
    guide_ = std::move(made);
    value_ = found.distance;
    set_state(ChaserState::on, Due::taken);
}

void ChaserSystem::open_ring(NodeEdits& nodes) {
    if (guide_->parted()) return;
    const InteractionDef element = lifted_element(nodes.world, *guide_, false);
    value_ = std::max(guide_->tension()[0], guide_->tension()[1]);
    set_state(ChaserState::open, Due::let_go);  // the ring holds nothing
    if (!disengage_guide(nodes, *guide_, element)) return set_state(ChaserState::on, Due::nothing);
    guide_ = no_guide(def_);
}

/// Compute the outputs: position of the ring on its wire, tensions, speed.
void ChaserSystem::sample(const World& world) {
    wire_output_ = start_distance_ = end_distance_ = arrived_ = angle_ = speed_ = tension_[0] =
        tension_[1] = 0.0;
    state_output_ = state_;
    if (!in_state(ChaserState::on)) return;
    const WireId wire = world.wires().of(guide_->ids().before);
    wire_output_ = wire_number(world, wire);
    if (!wire.valid()) return;
    bool before = true;
    for (const InteractionId id : world.wires().elements(wire)) {
        if (!world.alive(id)) continue;
        (before ? start_distance_ : end_distance_) += rest_length(world, id);
        if (id == guide_->ids().before) before = false;
    }
    arrived_ = guide_->used_up_side() >= 0      ? 1.0 + guide_->used_up_side()
               : start_distance_ < def_.arrives ? 1.0
               : end_distance_ < def_.arrives   ? 2.0
                                                : 0.0;
    angle_ = guide_->angle();
    speed_ = guide_->speed();
    for (const std::size_t k : {0U, 1U}) tension_[k] = guide_->tension()[k];
}

void ChaserSystem::before_step(NodeEdits& nodes) noexcept {
    try {
        const Guide& ids = guide_->ids();
        const bool guide_exists = nodes.world.alive(ids.slide) && nodes.world.alive(ids.before) &&
                                  nodes.world.alive(ids.behind) && nodes.world.alive(ids.friction);
        if (in_state(ChaserState::on) && !guide_exists) set_state(ChaserState::open, Due::nothing);
        if (in_state(ChaserState::on)) {
            guide_->before_step(nodes);
            if (guide_->has_run_off()) {
                value_ = guide_->tension()[0];
                set_state(close_ < 0.5 ? ChaserState::open : ChaserState::waiting, Due::let_go);
                guide_ = no_guide(def_);
            } else if (close_ < 0.5) {
                open_ring(nodes);
            }
        } else if (close_ >= 0.5) {
            close_on_wire(nodes);
        } else {
            set_state(ChaserState::open, static_cast<Due>(due_event_));
        }
        sample(nodes.world);
    } catch (const std::bad_alloc&) {
        nodes.out_of_memory();
    } catch (const std::exception&) {
        due_event_ = 0;  // out of memory: retried before the next step
    }
}

void ChaserSystem::report_events(Prestep& now) noexcept {
    constexpr EventKind kKinds[] = {EventKind::join, EventKind::missed, EventKind::detach};
    // A modified state may contain any number.
    if (due_event_ > 0 && due_event_ <= 3) now.tell(kKinds[due_event_ - 1], def_.body, value_);
    due_event_ = 0;
    const auto end = static_cast<std::int32_t>(arrived_);
    if (end != reached_ && end != 0)
        now.tell(EventKind::range, def_.body, end == 1 ? start_distance_ : end_distance_);
    reached_ = end;
}

void ChaserSystem::prestep(Prestep& now, Loads& loads) noexcept {
    report_events(now);
    if (in_state(ChaserState::on)) guide_->prestep(now, loads);
}

}  // namespace hawser::wire
