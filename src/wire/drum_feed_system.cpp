// SPDX-License-Identifier: Apache-2.0
#include "wire/drum_feed_system.h"

#include <hawser/world.h>

#include "wire/feed.h"

#include <utility>

namespace hawser::wire {
namespace {

/// Damping of the end stop, in units of the drum's inertia per step.
constexpr double kStopDamping = 1000.0;

}  // namespace

DrumFeedSystem::DrumFeedSystem(DrumFeedDef def, InteractionId line, double material, double angle)
    : def_(std::move(def)), line_(line), start_(angle), at_drum_(material), angle_(angle) {}

std::size_t DrumFeedSystem::node_slot(const World& world) const noexcept {
    return wire::node_slot(world, line_, def_.end == 0 ? 1 : 0);
}

void DrumFeedSystem::visit_state(StateVisitor& v) {
    if (!makes_nodes()) return;
    v.visit(at_drum_);
    v.visit(angle_);
    v.visit(paid_);
}

void DrumFeedSystem::check_state(const World& world, StateRules& rules) const {
    static_cast<void>(world);
    constexpr double kMaxWire = 1e7, kMaxAngle = 1e15;  // [m], [rad]: as for positions of bodies
    rules.range(at_drum_, -kMaxWire, kMaxWire, "the wire at the drum is out of range");
    rules.range(paid_, -kMaxAngle, kMaxAngle, "the wire paid out is out of range");
    rules.range(angle_, -kMaxAngle, kMaxAngle, "the angle of the drum is out of range");
}

void DrumFeedSystem::signals(SignalTable& table) {
    if (!makes_nodes()) return;
    table.output("at_drum", "m", at_drum_);
    table.output("paid_out", "m", paid_);
}

void DrumFeedSystem::holds(HoldTable& table) const { table.hold(line_); }

double DrumFeedSystem::paid_out(const World& world, InteractionId element) const noexcept {
    if (element != line_ || !makes_nodes() || !world.alive(line_)) return kDefault;
    const InteractionDef& line = world.interaction_def(line_);
    return line.get("radius") * (world.pose(line.body[2]).position.x() - start_);
}

/// Return the rest length l at which hauling stops [m].
double DrumFeedSystem::min_hauled_length(const World& world, double length) const noexcept {
    const double least = kLeastOfDrumElement * length;
    if (!makes_nodes()) return least;  // version 1 of scenes: one element, whose stop stays
    return std::max(least, wire::min_hauled_length(world, line_, def_.element));
}

/// Brake a drum that hauls although its element has reached its least length. Send an event in the
/// first step in which this happens.
void DrumFeedSystem::stop_at_fairlead(Prestep& now, Loads& loads,
                                      const InteractionDef& line) noexcept {
    const World& world = now.world;
    const BodyId drum = line.body[2];
    const double radius = line.get("radius"), length = line.get("length");
    const double least = min_hauled_length(world, length);
    const double rest = length + radius * (world.pose(drum).position.x() - line.get("drum_zero"));
    const double speed = radius * world.velocity(drum).linear.x();
    if (rest > least || speed >= 0.0) return;
    if (rest - speed * now.step > least)
        now.tell(EventKind::hauled_in, drum, std::max(0.0, -world.force(line_)[0]));
    const double damping = kStopDamping * world.body_def(drum).mass / now.step;
    loads.add_damping(drum, Eigen::Matrix<double, 1, 1>(damping));
}

void DrumFeedSystem::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (!makes_nodes() || !world.alive(line_) || !world.intact(line_)) return;
    const InteractionDef& line = world.interaction_def(line_);
    const double turned = world.pose(line.body[2]).position.x() - angle_;
    const double drum_side_length = at_drum_ + line.get("radius") * turned;
    const std::size_t node = node_slot(world);
    const Feed feed{line_, node == 1, def_.element, def_.mass_per_length};
    if (drum_side_length > kInsertRatio * def_.element)
        (void)insert_feed_node(nodes, feed, drum_side_length, at_drum_);
    else if (drum_side_length < kRemoveRatio * def_.element)
        (void)feed_in_node(nodes, feed, node, at_drum_);
}

void DrumFeedSystem::prestep(Prestep& now, Loads& loads) noexcept {
    const World& world = now.world;
    if (!world.alive(line_) || !world.intact(line_)) return;
    const InteractionDef& line = world.interaction_def(line_);
    const BodyId drum = line.body[2];
    const double radius = line.get("radius");
    if (makes_nodes()) {
        const double angle = world.pose(drum).position.x();
        at_drum_ += radius * (angle - angle_);
        angle_ = angle;
        paid_ = radius * (angle - start_);
        load_element(world, loads, {line_, drum, radius, def_.mass_per_length, at_drum_},
                     node_slot(world));
    }
    stop_at_fairlead(now, loads, line);
}

}  // namespace hawser::wire
