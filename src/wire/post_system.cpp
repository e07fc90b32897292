// SPDX-License-Identifier: Apache-2.0
#include "wire/post_system.h"

#include <hawser/guide.h>
#include <hawser/world.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <string>
#include <utility>

namespace hawser::wire {
namespace {

constexpr double kLetGo = -2e-3;     ///< Angle below which a wire would pull at its post [rad].
constexpr double kStrain = 1e-5;     ///< ε of post_system.h.
constexpr double kNearEnd = 0.06;    ///< Of an element: a lump lies on the post.
constexpr double kTouches = 2e-3;    ///< Gap at which a contact bears [m].
constexpr double kBentOnPost = 3.2;  ///< A lump on a post goes however the wire is bent there.
constexpr double kLong = 1.5;        ///< Of element_length: what was let go gets a node.
constexpr std::int32_t kSteady = 3;  ///< Looks running at which a wire touches before it is taken.
constexpr std::int32_t kWait = 15;   ///< Steps.
/// Of the radius: a wire that just touches turns by next to nothing, and not the other way.
constexpr double kInside = 1e-9;

/// Where two lines are closest: share of a–b, and way along the axis from its centre [m].
struct Closest {
    double share, along;
    Vec3 apart;  ///< From the axis to a–b, square to the axis.
};
Closest closest(const Vec3& a, const Vec3& b, const Vec3& centre, const Vec3& axis) noexcept {
    const Vec3 d = b - a;
    const Vec3 from = a - centre;
    const Vec3 d_across = d - d.dot(axis) * axis, from_across = from - from.dot(axis) * axis;
    const double share =
        std::clamp(-from_across.dot(d_across) / std::max(d_across.squaredNorm(), 1e-300), 0.0, 1.0);
    const Vec3 at = from + share * d;
    const double along = at.dot(axis);
    return {share, along, at - along * axis};
}

}  // namespace

PostSystem::PostSystem(PostDef def, const PostPlace& place)
    : def_(std::move(def)), place_(place), on_(static_cast<std::size_t>(def_.wires), 0) {
    for (int k = 0; k < def_.wires; ++k) {
        GuideDef guide;
        guide.name = def_.name + "/" + std::to_string(k + 1);
        guide.body = place_.carrier;
        guide.axis = place_.carried_axis;
        guide.friction = def_.friction;
        guide.efficiency = def_.efficiency;
        guide.inertia = def_.inertia;
        guide.element_length = def_.element_length;
        guides_.push_back(std::make_unique<GuideSystem>(std::move(guide), Guide{}, InputId{},
                                                        std::array<double, 2>{}));
    }
}

void PostSystem::visit_state(StateVisitor& v) {
    v.visit(std::span<std::int32_t>(on_));
    for (std::int32_t* x : {&wait_, &steady_}) v.visit(*x);
    for (double* x : {&taken_, &let_go_, &held_, &angle_, &slide_, &tension_[0], &tension_[1]})
        v.visit(*x);
    for (const auto& guide : guides_) {
        guide->visit_place(v);
        guide->visit_state(v);
    }
}

void PostSystem::signals(SignalTable& table) {
    table.output("held", "1", held_);
    table.output("taken", "1", taken_);
    table.output("let_go", "1", let_go_);
    table.output("angle", "rad", angle_);
    table.output("before", "N", tension_[0]);
    table.output("behind", "N", tension_[1]);
    table.output("slide", "m", slide_);
}

void PostSystem::holds(HoldTable& table) const {
    table.hold(place_.body);
    table.hold(place_.carrier);
    table.hold(def_.shape);
    for (std::size_t k = 0; k < on_.size(); ++k)
        if (on_[k] != 0) guides_[k]->holds(table);
}

double PostSystem::carried_mass(InteractionId element) const noexcept {
    for (std::size_t k = 0; k < on_.size(); ++k)
        if (on_[k] != 0)
            if (const double mass = guides_[k]->carried_mass(element); mass != 0.0) return mass;
    return 0.0;
}

/// The element of a capsule of a wire. @return false: none that could be taken.
bool PostSystem::find(const World& world, ShapeId segment, Touch& out) const {
    const ShapeDef& capsule = world.shape_def(segment);
    if (!capsule.body_b.valid()) return false;
    for (const WireId wire : world.wires()) {
        const auto nodes = world.nodes(wire);
        const auto elements = world.elements(wire);
        const auto at = std::find(nodes.begin(), nodes.end(), capsule.body);
        if (at == nodes.end()) continue;
        for (const std::ptrdiff_t k : {at - nodes.begin(), at - nodes.begin() - 1}) {
            if (k < 0 || k >= std::ssize(elements)) continue;
            const InteractionId id = elements[static_cast<std::size_t>(k)];
            if (!world.alive(id) || !world.intact(id)) continue;
            const InteractionDef& d = world.interaction_def(id);
            const bool its = (d.body[0] == capsule.body && d.body[1] == capsule.body_b) ||
                             (d.body[1] == capsule.body && d.body[0] == capsule.body_b);
            if (!its || kind_info(d.kind).is(kWoundUp) || !(d.get("mass") > 0.0)) continue;
            out.element = id;
            out.wire = wire;
            place_touch(world, capsule.radius, out);
            return true;
        }
    }
    return false;
}

void PostSystem::place_touch(const World& world, double half, Touch& out) const {
    const InteractionDef& d = world.interaction_def(out.element);
    const Pose pose = world.pose(place_.body);
    const Vec3 axis = pose.orientation * place_.axis;
    const Vec3 centre = pose.position + pose.orientation * place_.centre;
    const Vec3 a = world.pose(d.body[0]).position, b = world.pose(d.body[1]).position;
    const Closest near = closest(a, b, centre, axis);
    const Vec3 along = (b - a).normalized();
    const double apart = near.apart.norm();
    out.share = near.share;
    out.point = place_.centre + near.along * place_.axis;
    const double way = axis.dot(near.apart.cross(along)) >= 0.0 ? 1.0 : -1.0;
    out.across_end = std::abs(near.along) > place_.half_length && apart < 0.5 * place_.radius;
    const double touching = place_.radius + half;
    out.radius = way * std::max(touching, apart * (1.0 - kInside));
    const Twist twist = world.velocity(place_.body);
    const Vec3 surface =
        twist.linear + twist.angular.cross(centre + near.along * axis + near.apart - pose.position);
    const Vec3 speed[2] = {world.velocity(d.body[0]).linear - surface,
                           world.velocity(d.body[1]).linear - surface};
    out.along = ((1.0 - near.share) * speed[0] + near.share * speed[1]).dot(along);
    out.strain = 0.0;
    for (const std::size_t end : {0U, 1U}) {
        const double length = (end == 0 ? near.share : 1.0 - near.share) * (b - a).norm();
        const Vec3 moves = world.settings().step * (speed[end] - speed[end].dot(along) * along);
        out.strain += moves.squaredNorm() / (2.0 * std::max(length, 1e-3) * (b - a).norm());
    }
}

/// Wires that touch the post come to lie on it.
void PostSystem::take(NodeEdits& nodes) {
    const World& world = nodes.world;
    if (wait_ > 0) {
        --wait_;
        return;
    }
    if (std::find(on_.begin(), on_.end(), 0) == on_.end()) return;
    const std::int32_t steady = std::min(steady_ + 1, kSteady);
    steady_ = 0;
    world.contacts(contacts_);
    for (const ContactView& contact : contacts_) {
        if (contact.shape[0] != def_.shape && contact.shape[1] != def_.shape) continue;
        const ShapeId other = contact.shape[contact.shape[0] == def_.shape ? 1 : 0];
        Touch touch;
        // Earlier takings of this step have removed shapes.
        if (!world.alive(other) || !(contact.force.norm() > 0.0) || !find(world, other, touch))
            continue;
        const double gap = std::abs(touch.radius) - place_.radius - world.shape_def(other).radius;
        // Across the end of the post it lies on that, not beside the post.
        if (touch.across_end || gap > kTouches || touch.strain > kStrain) continue;
        bool has = false;
        for (std::size_t k = 0; k < on_.size(); ++k)
            has = has || (on_[k] != 0 && guides_[k]->def().wire == touch.wire);
        const auto slot = std::find(on_.begin(), on_.end(), 0);
        if (has || slot == on_.end()) continue;
        steady_ = steady;
        if (steady < kSteady) continue;
        if (!take(nodes, static_cast<std::size_t>(slot - on_.begin()), touch)) wait_ = kWait;
    }
}

/// A lump on the post goes: one element takes the place of the two beside it, its chord through the
/// post. It lies on the side of the post on which the lump was.
bool PostSystem::take_lump(NodeEdits& nodes, Touch& touch) const {
    const World& world = nodes.world;
    const InteractionDef& d = world.interaction_def(touch.element);
    const bool first = touch.share < 0.5;
    const BodyId lump = d.body[first ? 0 : 1];
    if (first) {
        const auto elements = world.elements(touch.wire);
        const auto at = std::find(elements.begin(), elements.end(), touch.element);
        if (at == elements.begin() || at == elements.end()) return false;
        touch.element = *(at - 1);  // which stays
    }
    const double radius = touch.radius, half = std::abs(radius) - place_.radius;
    if (!nodes.remove_node(lump, kBentOnPost)) return false;
    place_touch(world, half, touch);
    touch.radius = radius;
    return touch.share > kNearEnd && touch.share < 1.0 - kNearEnd;
}

bool PostSystem::take(NodeEdits& nodes, std::size_t slot, Touch touch) {
    const World& world = nodes.world;
    if ((touch.share < kNearEnd || touch.share > 1.0 - kNearEnd) && !take_lump(nodes, touch))
        return false;
    const double mass = world.interaction_def(touch.element).get("mass");
    GuideDef def = guides_[slot]->def();
    def.wire = touch.wire;
    def.element = touch.element;
    def.slide = {};
    def.point = world.local_point(place_.carrier, world.world_point(place_.body, touch.point));
    def.radius = touch.radius;
    def.element_length = def_.element_length;
    def.mass_per_length = kDefault;
    Guide made;
    double material[2] = {};
    if (!nodes.lay_over(def, touch.along, made, material)) return false;
    const InputId stop = world.find_input(def.name + "/friction/force");
    // All of the element's mass is on one side or the other.
    const double scale = mass / (def.mass_per_length * (material[0] + material[1]));
    guides_[slot] = std::make_unique<GuideSystem>(
        std::move(def), made, stop,
        std::array<double, 2>{scale * material[0], scale * material[1]});
    guides_[slot]->begin_at(touch.along);
    on_[slot] = 1;
    taken_ += 1.0;
    return true;
}

/// Whether a wire would have to pull at the post, or has passed an end of it.
bool PostSystem::pulls(const World& world, const GuideSystem& guide, bool& past) const {
    if (guide.parted()) return false;
    const Pose pose = world.pose(place_.body);
    const Vec3 a = world.pose(world.interaction_def(guide.ids().before).body[0]).position;
    const Vec3 b = world.pose(world.interaction_def(guide.ids().behind).body[1]).position;
    const Closest near = closest(a, b, pose.position + pose.orientation * place_.centre,
                                 pose.orientation * place_.axis);
    past = std::abs(near.along) > place_.half_length + place_.radius;
    if (place_.carrier != place_.body) {
        const Vec3 lies = world.world_point(place_.carrier, guide.def().point);
        const Vec3 from = lies - world.world_point(place_.body, place_.centre);
        past = past || std::abs(from.dot(pose.orientation * place_.axis)) > place_.half_length;
    }
    return past || (guide.angle() < kLetGo && guide.pressing(world, -kLetGo) < 0.0);
}

bool PostSystem::let_go(NodeEdits& nodes, std::size_t slot) {
    const World& world = nodes.world;
    const GuideSystem& guide = *guides_[slot];
    bool past = false;
    if (!pulls(world, guide, past)) return false;
    const InteractionDef& a = world.interaction_def(guide.ids().before);
    const InteractionDef& b = world.interaction_def(guide.ids().behind);
    const double q = world.pose(guide.ids().slide).position.x();
    const auto rest_of = [&](const InteractionDef& d) {
        return d.get("length") + d.get("radius") * (q - d.get("drum_zero"));
    };
    const double rest = rest_of(a) + rest_of(b);
    const auto way = [&](InteractionId id) {
        const std::array<Vec3, 2> ends = world.ends(id);
        return (ends[1] - ends[0]).norm();
    };
    const Vec3 first = world.world_point(a.body[0], a.point[0]),
               last = world.world_point(b.body[1], b.point[1]);
    const double path = way(guide.ids().before) + way(guide.ids().behind) +
                        std::abs(guide.def().radius) * std::min(0.0, guide.angle());
    InteractionDef element;
    element.kind = InteractionKind::Stretch;
    element.name = a.name;
    element.body = {a.body[0], b.body[1]};
    element.point = {a.point[0], b.point[1], Vec3::Zero(), Vec3::Zero()};
    const double length = past ? rest : rest * (last - first).norm() / path;
    element.set("length", length).set("EA", a.get("EA"));
    element.set("mass", guide.def().mass_per_length * (guide.material()[0] + guide.material()[1]));
    element.set("tension_only", a.get("tension_only"));
    if (const double load = a.get("breaking_load"); !std::isnan(load))
        element.set("breaking_load", load);
    element.damping_time[0] = a.damping_time[0] * length / a.get("length");
    on_[slot] = 0;  // it holds nothing of it
    const InteractionId whole = nodes.lift_off(guide.ids(), element);
    if (!whole.valid()) {
        on_[slot] = 1;
        return false;
    }
    let_go_ += 1.0;
    wait_ = kWait;
    if (guide.material()[0] + guide.material()[1] > kLong * guide.def().element_length)
        (void)nodes.insert_node(whole, 0.5);
    return true;
}

void PostSystem::tell() noexcept {
    held_ = static_cast<double>(std::count(on_.begin(), on_.end(), 1));
    const auto first = std::find(on_.begin(), on_.end(), 1);
    angle_ = slide_ = tension_[0] = tension_[1] = 0.0;
    if (first == on_.end()) return;
    const GuideSystem& guide = *guides_[static_cast<std::size_t>(first - on_.begin())];
    angle_ = guide.angle();
    slide_ = guide.slide();
    for (const std::size_t k : {0U, 1U}) tension_[k] = guide.tension()[k];
}

void PostSystem::before_step(NodeEdits& nodes) noexcept {
    try {
        for (std::size_t k = 0; k < on_.size(); ++k) {
            if (on_[k] == 0) continue;
            guides_[k]->before_step(nodes);
            (void)let_go(nodes, k);
        }
        take(nodes);
    } catch (const std::exception&) {
        steady_ = 0;  // without memory: what touches is looked at anew
    }
    tell();
}

void PostSystem::prestep(Prestep& now, Loads& loads) noexcept {
    for (std::size_t k = 0; k < on_.size(); ++k)
        if (on_[k] != 0) guides_[k]->prestep(now, loads);
}

}  // namespace hawser::wire
