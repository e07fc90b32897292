// SPDX-License-Identifier: Apache-2.0
#include "wire/guide_system.h"

#include <hawser/world.h>

#include "wire/bounds.h"
#include "wire/feed.h"
#include "wire/room.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace hawser::wire {
namespace {

/// Slot of the guide in the elements before and behind it.
constexpr std::size_t kGuideSlot[2] = {1, 0};
/// Change of the elements' material per unit of the slide.
constexpr double kMaterialSign[2] = {-1.0, 1.0};
/// Fraction of `element_length`: a shorter straight part is at the guide.
constexpr double kMinStraightFraction = 0.05;
constexpr std::int32_t kMaxWait = 1000;  ///< Steps.

}  // namespace

GuideSystem::GuideSystem(GuideDef def, const Guide& ids, InputId stop,
                         const std::array<double, 2>& material)
    : def_(std::move(def)), ids_(ids), stop_(stop), material_(material), angle_(ids.angle) {}

void GuideSystem::visit_state(StateVisitor& v) {
    for (double* x : {material_.data(), &material_[1], &slide_, &angle_, &speed_, &bound_,
                      &half_element_weight_, tension_.data(), &tension_[1]})
        v.visit(*x);
    v.visit(parted_);
    v.visit(used_up_side_);
    if (def_.closed) return;
    v.visit(landing_steps_left_);
    visit_geometry(v);
}

void GuideSystem::visit_geometry(StateVisitor& v) {
    const auto visit = [&v](auto& id) {
        v.visit(id.index);
        v.visit(id.generation);
    };
    visit(def_.wire);
    for (BodyId* id : {&ids_.slide, &def_.slide}) visit(*id);
    for (InteractionId* id : {&ids_.before, &ids_.behind, &ids_.friction}) visit(*id);
    visit(stop_);
    v.visit(std::span<double>(def_.point.data(), 3));
    for (double* x : {&def_.radius, &def_.element_length, &def_.mass_per_length})
        v.visit_or_nan(*x);
}

void GuideSystem::check_state(const World& world, StateRules& rules) const {
    constexpr double kMaxWire = 1e7, kMaxAngle = 1e6;  // [m], [rad]
    rules.range(material_[0], -kMaxWire, kMaxWire, "the wire before the guide is out of range");
    rules.range(material_[1], -kMaxWire, kMaxWire, "the wire behind the guide is out of range");
    rules.range(slide_, -1e15, 1e15, "the slide of the guide is out of range");
    rules.range(angle_, -kMaxAngle, kMaxAngle, "the angle at the guide is out of range");
    rules.range(bound_, 0.0, kUnbounded, "the friction of the guide is out of range");
    rules.require(parted_ >= 0 && parted_ <= (def_.closed ? kReportedOff : kLiftedState),
                  "the guide has an invalid condition");
    if (!def_.closed) {
        rules.require(landing_steps_left_ >= 0 && landing_steps_left_ <= kMaxWait,
                      "the wait of the guide is out of range");
        check_position(world, rules);
    }
    rules.require(used_up_side_ >= -1 && used_up_side_ <= 1, "there is no such side of the guide");
}

void GuideSystem::check_position(const World& world, StateRules& rules) const {
    if (has_run_off()) return;  // nothing else is used
    const auto lies = [&](std::size_t side) {
        if (!world.alive(element(side))) return false;
        const InteractionDef& d = world.interaction_def(element(side));
        return kind_info(d.kind).is(kAtGuide) && d.body[kGuideSlot[side]] == def_.body &&
               d.body[2] == ids_.slide;
    };
    rules.require(world.alive(ids_.slide) && def_.slide == ids_.slide &&
                      world.body_def(ids_.slide).kind == BodyKind::scalar,
                  "the guide has no slide");
    rules.require(lies(0) && lies(1), "an element does not run over the guide");
    rules.require(world.alive(ids_.friction) && world.alive(stop_) &&
                      world.find_interaction(def_.name + "/friction") == ids_.friction &&
                      world.find_input(def_.name + "/friction/force") == stop_,
                  "the guide has no friction");
    rules.require(world.alive(def_.wire), "the guide has no wire");
    rules.require(def_.point.allFinite() && def_.point.norm() <= 1e7,
                  "the position of the guide is out of range");
    rules.range(std::abs(def_.radius), 0.0, 1e6, "the radius of the guide is out of range");
    rules.range(def_.element_length, 0.0, 1e7, "the element of the guide is out of range");
    rules.range(def_.mass_per_length, 0.0, 1e9, "the mass of the wire is out of range");
}

void GuideSystem::signals(SignalTable& table) {
    table.output("angle", "rad", angle_);
    table.output("before", "N", tension_[0]);
    table.output("behind", "N", tension_[1]);
    table.output("slide", "m", slide_);
    table.output("speed", "m/s", speed_);
    table.output("wire_before", "m", material_[0]);
    table.output("wire_behind", "m", material_[1]);
}

void GuideSystem::holds(HoldTable& table) const {
    table.hold(def_.body);
    if (has_run_off()) return;
    table.hold(ids_.slide);
    for (const InteractionId id : {ids_.before, ids_.behind}) table.hold(id);
    table.hold(ids_.friction);
    table.hold(stop_);
}

double GuideSystem::carried_mass(InteractionId id) const noexcept {
    if (parted_ != 0 || !(def_.element_length > 0.0)) return 0.0;
    for (std::size_t side = 0; side < 2; ++side)
        if (id == element(side)) return def_.mass_per_length * material_[side];
    return 0.0;
}

/// Return the straight distance from the guide to the node on a side, without the arc on the wheel
/// [m].
double GuideSystem::straight(const World& world, std::size_t side) const noexcept {
    const InteractionDef& d = world.interaction_def(element(side));
    const std::size_t node = 1 - kGuideSlot[side];
    const Pose at = world.pose(def_.body);
    const Vec3 to =
        world.world_point(d.body[node], d.point[node]) - world.world_point(def_.body, def_.point);
    if (def_.radius == 0.0) return to.norm();
    const Vec3 axis = at.orientation * def_.axis.normalized();
    const double along = to.dot(axis), separation = (to - along * axis).squaredNorm();
    return std::sqrt(std::max(0.0, separation - def_.radius * def_.radius) + along * along);
}

/// Read tensions and displacement of the last step, before nodes are inserted or removed.
void GuideSystem::sample(const World& world) noexcept {
    if (has_run_off()) {
        tension_ = {};
        return;
    }
    const double slide = world.pose(ids_.slide).position.x(), ran = slide - slide_;
    slide_ = slide;
    const double before = speed_;
    speed_ = world.velocity(ids_.slide).linear.x();
    const double gained = (speed_ - before) / world.settings().step;
    if (!parts_intact(world)) parted_ = 1;
    if (parted_ != 0) {
        tension_ = {};
        return;
    }
    half_element_weight_ = 0.0;
    Vec3 u[2];
    for (std::size_t side = 0; side < 2; ++side) {
        material_[side] += kMaterialSign[side] * ran;
        const std::array<Vec3, 2> ends = world.wires().ends(element(side));
        u[side] = (ends[1] - ends[0]).normalized();
        // At the guide the element also carries the weight of half of it, and accelerates it along
        // the wire.
        const Vec3 weight = weight_at(world, element(side), 1 - kGuideSlot[side], half_mass(side));
        const double more = kMaterialSign[side] * weight.dot(u[side]);
        half_element_weight_ += more;
        tension_[side] = std::max(0.0, more - kMaterialSign[side] * half_mass(side) * gained -
                                           world.force(element(side))[0]);
    }
    double angle = std::atan2(u[0].cross(u[1]).norm(), u[0].dot(u[1]));
    if (def_.radius != 0.0) {
        const Vec3 axis = world.pose(def_.body).orientation * def_.axis.normalized();
        const double across = u[0].dot(u[1]) - u[0].dot(axis) * u[1].dot(axis);
        const double about =
            std::atan2(u[0].cross(u[1]).dot(axis), across) * (def_.radius > 0.0 ? 1 : -1);
        angle = angle_ + std::remainder(about - angle_, 2.0 * std::acos(-1.0));
    }
    angle_ = angle;
}

double GuideSystem::half_mass(std::size_t side) const noexcept {
    return def_.element_length > 0.0 ? 0.5 * def_.mass_per_length * std::max(material_[side], 0.0)
                                     : 0.0;
}

double GuideSystem::pressing_force(const World& world, double slack) const noexcept {
    const Vec3 axis = world.pose(def_.body).orientation * def_.axis.normalized();
    Vec3 along = Vec3::Zero(), weight = Vec3::Zero();
    for (std::size_t side = 0; side < 2; ++side) {
        const std::array<Vec3, 2> ends = world.wires().ends(element(side));
        along += (ends[1] - ends[0]).normalized();
        weight += weight_at(world, element(side), 1 - kGuideSlot[side], half_mass(side));
    }
    const Vec3 outward = (def_.radius > 0.0 ? 1.0 : -1.0) * along.normalized().cross(axis);
    return 0.5 * (tension_[0] + tension_[1]) * (angle_ + slack) - weight.dot(outward);
}

/// Apply the mass, weight and drag of the elements at the guide that no node carries to their ends.
void GuideSystem::load_end_masses(const World& world, Loads& loads) const noexcept {
    if (!(def_.element_length > 0.0) || parted_ != 0) return;
    double moved = 0.0, pull = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
        const InteractionId line = element(side);
        const std::size_t node = 1 - kGuideSlot[side];
        const double half = half_mass(side);
        const std::array<Vec3, 2> ends = world.wires().ends(line);
        const Vec3 weight = weight_at(world, line, node, half);
        const Vec3 u = (ends[node] - ends[kGuideSlot[side]]).normalized();
        load_ends(world, loads, line, node, half, weight,
                  ends[kGuideSlot[side]] - world.pose(def_.body).position);
        pull += kMaterialSign[side] * weight.dot(u);
        moved += half;
    }
    loads.add_force(ids_.slide, {pull, 0.0, 0.0});
    loads.add_mass(ids_.slide, Eigen::Matrix<double, 1, 1>(moved));
}

bool GuideSystem::is_nearly_used_up(const World& world, std::size_t side) const noexcept {
    const double least = kMinStraightFraction * (def_.element_length > 0.0 ? length_[side] : 1.0) +
                         world.settings().step * std::abs(speed_);
    // At an angle below 0 the straight part is longer than the material.
    return std::min(straight(world, side), material_[side]) < least && runs_out(side);
}

/// Hold the slide when a side is used up, until the force pulls it the other way. If the wire has
/// broken at the guide, hold the slide permanently, because no force balances the intact part.
void GuideSystem::stop(Prestep& now) noexcept {
    if (has_run_off()) return;
    if (parted_ != 0) {
        if (bound_ != kUnbounded) now.set_input(stop_, kUnbounded);
        bound_ = kUnbounded;
        return;
    }
    const std::int32_t was = used_up_side_;
    if (used_up_side_ >= 0) {
        // Against running out of the side before it, which is up the slide, the stop pushes down.
        const double force = now.world.force(ids_.friction)[0];
        if (force * kMaterialSign[static_cast<std::size_t>(used_up_side_)] < 0.0)
            used_up_side_ = -1;
    }
    for (std::size_t side = 0; side < 2 && used_up_side_ < 0 && was < 0; ++side)
        if (is_nearly_used_up(now.world, side)) used_up_side_ = static_cast<std::int32_t>(side);
    // The weight at the guide adds to the pressure like the tensions of the elements.
    const double exponent = def_.friction * std::max(0.0, angle_) - std::log(def_.efficiency);
    const double least = std::tanh(0.5 * exponent) * std::max(0.0, half_element_weight_);
    const double required_bound = used_up_side_ >= 0 ? kUnbounded : least;
    if (required_bound != bound_) now.set_input(stop_, required_bound);
    bound_ = required_bound;
}

void GuideSystem::prestep(Prestep& now, Loads& loads) noexcept {
    if (parted_ == kRunsOff) {
        now.tell(EventKind::detach, def_.body, tension_[0]);
        parted_ = kReportedOff;
    }
    stop(now);
    load_end_masses(now.world, loads);
    damp_landing(now.world, loads);
}

void GuideSystem::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    sample(world);
    if (lifted()) return return_to_wheel(nodes);
    if (parted_ != 0) return;
    def_.wire = world.wires().of(ids_.before);  // a cut or splice may have changed the wire
    for (std::size_t side = 0; side < 2 && def_.element_length > 0.0; ++side) {
        const double out = straight(world, side), there = material_[side];
        const double length = length_[side] =
            element_length_at_guide(world, def_, element(side), side, out);
        Feed feed{element(side), side == 1, def_.element_length, def_.mass_per_length};
        // If the next guide or bollard is near, the node is placed as near.
        if (length < def_.element_length) feed.element = std::max(length, there - length);
        if (out > kInsertRatio * length && there > length)
            (void)insert_feed_node(nodes, feed, there, material_[side]);
        else if (out < kRemoveRatio * length)
            (void)feed_in_node(nodes, feed, 1 - kGuideSlot[side], material_[side]);
    }
    release_at_end(nodes);
    if (!def_.closed) update_lift(nodes);
}

}  // namespace hawser::wire
