// SPDX-License-Identifier: Apache-2.0
#include "wire/post_system.h"

#include <hawser/guide.h>
#include <hawser/world.h>

#include "wire/guide_on_off.h"
#include "wire/lift.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <new>
#include <string>
#include <utility>

namespace hawser::wire {
namespace {

constexpr double kDefaultStrain = 1e-5;  ///< ε of post_system.h.
/// Fraction of an element at its end: the node lies on the bollard.
constexpr double kNearEnd = 0.06;
constexpr double kContactGap = 2e-3;  ///< Gap at which a contact bears [m].
constexpr double kBentOnPost = 3.2;   ///< Bend limit: a node on a bollard is removed at any bend.
/// Consecutive samples with contact after which a wire engages.
constexpr std::int32_t kSteadySamples = 3;
constexpr std::int32_t kStepsBetweenTries = 15;  ///< Steps.
/// Return the element before or behind another element of a wire. Invalid if there is none, or if
/// it is at a drum or guide.
InteractionId neighbour(const World& world, WireId wire, InteractionId element, bool behind) {
    const auto elements = world.wires().elements(wire);
    const auto at = std::find(elements.begin(), elements.end(), element);
    if (at == elements.end() || at == (behind ? elements.end() - 1 : elements.begin())) return {};
    const InteractionId out = *(behind ? at + 1 : at - 1);
    return world.alive(out) && !kind_info(world.interaction_def(out).kind).is(kWoundUp)
               ? out
               : InteractionId{};
}

/// Return the length of elements to insert at a bollard that defines none [m]. It is the length of
/// the touched element or of its longest neighbour, because other bollards may have shortened the
/// element (room.h).
double usual_length(const World& world, WireId wire, InteractionId element) {
    const double own = world.interaction_def(element).get("length");
    double longest = own;
    bool alone = true;
    for (const bool behind : {false, true}) {
        const InteractionId next = neighbour(world, wire, element, behind);
        if (next.valid())
            longest = std::max(longest, world.interaction_def(next).get("length"));
        else
            alone = false;
    }
    return alone ? own : longest;
}

}  // namespace

PostSystem::PostSystem(PostDef def, const PostPosition& place)
    : def_(std::move(def)), position_(place), occupied_(static_cast<std::size_t>(def_.wires), 0) {
    for (int k = 0; k < def_.wires; ++k) {
        GuideDef guide;
        guide.name = def_.name + "/" + std::to_string(k + 1);
        guide.body = position_.carrier;
        guide.axis = position_.carried_axis;
        guide.friction = def_.friction;
        guide.efficiency = def_.efficiency;
        guide.inertia = def_.inertia;
        guide.element_length = def_.element_length;
        guides_.push_back(guide_without_wire(std::move(guide)));
    }
}

void PostSystem::visit_state(StateVisitor& v) {
    v.visit(std::span<std::int32_t>(occupied_));
    for (std::int32_t* x : {&steps_until_next_, &contact_samples_}) v.visit(*x);
    for (double* x : {&engaged_count_, &disengaged_count_, &held_count_, &angle_, &slide_,
                      &tension_[0], &tension_[1]})
        v.visit(*x);
    // Visited only for bollards with sliding wires; others keep the hashes of earlier versions.
    if (def_.slides)
        for (double* x : {&slid_length_, &along_}) v.visit(*x);
    for (const auto& guide : guides_) {
        guide->visit_geometry(v);
        guide->visit_state(v);
    }
}

void PostSystem::check_state(const World& world, StateRules& rules) const {
    for (const std::int32_t on : occupied_)
        rules.flag(on, "the flag of an engaged wire of the bollard is invalid");
    rules.require(steps_until_next_ >= 0 && steps_until_next_ <= kStepsBetweenTries,
                  "the wait of the post is out of range");
    rules.require(contact_samples_ >= 0 && contact_samples_ <= kSteadySamples,
                  "the counter of checks of the bollard is out of range");
    for (std::size_t k = 0; k < occupied_.size(); ++k) {
        if (occupied_[k] != 1) continue;
        guides_[k]->check_position(world, rules);
        guides_[k]->check_state(world, rules);
    }
}

void PostSystem::signals(SignalTable& table) {
    table.output("held", "1", held_count_);
    table.output("taken", "1", engaged_count_);
    table.output("let_go", "1", disengaged_count_);
    table.output("angle", "rad", angle_);
    table.output("before", "N", tension_[0]);
    table.output("behind", "N", tension_[1]);
    table.output("slide", "m", slide_);
    if (!def_.slides) return;
    table.output("along", "m", along_);
    table.output("slid", "m", slid_length_);
}

void PostSystem::holds(HoldTable& table) const {
    table.hold(position_.body);
    table.hold(position_.carrier);
    table.hold(def_.shape);
    for (std::size_t k = 0; k < occupied_.size(); ++k)
        if (occupied_[k] != 0) guides_[k]->holds(table);
}

double PostSystem::carried_mass(InteractionId element) const noexcept {
    for (std::size_t k = 0; k < occupied_.size(); ++k)
        if (occupied_[k] != 0)
            if (const double mass = guides_[k]->carried_mass(element); mass != 0.0) return mass;
    return 0.0;
}

bool PostSystem::carries(WireId wire) const noexcept {
    for (std::size_t k = 0; k < occupied_.size(); ++k)
        if (occupied_[k] != 0 && guides_[k]->def().wire == wire) return true;
    return false;
}

/// Engage wires that touch the bollard.
void PostSystem::engage_wires(NodeEdits& nodes) {
    const World& world = nodes.world;
    if (steps_until_next_ > 0) {
        --steps_until_next_;
        return;
    }
    if (std::find(occupied_.begin(), occupied_.end(), 0) == occupied_.end()) return;
    const std::int32_t steady = std::min(contact_samples_ + 1, kSteadySamples);
    contact_samples_ = 0;
    world.pressing(def_.shape, pressing_);
    for (const ShapeId other : pressing_) {
        Touch touch;
        // Wires engaged earlier in this step have lost their shapes.
        if (!world.alive(other) || !find(world, other, touch)) continue;
        const double gap =
            std::abs(touch.radius) - position_.radius - world.shape_def(other).radius;
        // A wire across the end of the bollard lies on the end, not beside it.
        if (touch.across_end || gap > kContactGap || touch.strain > kDefaultStrain) continue;
        const auto slot = std::find(occupied_.begin(), occupied_.end(), 0);
        if (carries(touch.wire) || slot == occupied_.end()) continue;
        contact_samples_ = steady;
        if (steady < kSteadySamples) continue;
        if (!engage_wire(nodes, static_cast<std::size_t>(slot - occupied_.begin()), touch))
            steps_until_next_ = kStepsBetweenTries;
    }
}

/// Remove a node that lies on the bollard. One element replaces its two elements, on the node's
/// side of the bollard; its chord passes through the bollard.
bool PostSystem::remove_node_at(NodeEdits& nodes, Touch& touch) const {
    const World& world = nodes.world;
    const InteractionDef& d = world.interaction_def(touch.element);
    const bool first = touch.fraction < 0.5;
    const BodyId lump = d.body[first ? 0 : 1];
    // Elements loaded by a guide and their nodes belong to that guide.
    const InteractionId next = neighbour(world, touch.wire, touch.element, !first);
    if (!next.valid()) return false;
    if (first) touch.element = next;  // this element stays
    const double radius = touch.radius, half = std::abs(radius) - position_.radius;
    if (!nodes.remove_node(lump, kBentOnPost)) return false;
    complete_touch(world, half, touch);
    touch.radius = radius;
    return touch.fraction > kNearEnd && touch.fraction < 1.0 - kNearEnd;
}

bool PostSystem::engage_wire(NodeEdits& nodes, std::size_t slot, Touch touch) {
    const World& world = nodes.world;
    if ((touch.fraction < kNearEnd || touch.fraction > 1.0 - kNearEnd) &&
        !remove_node_at(nodes, touch))
        return false;
    GuideDef def = guides_[slot]->def();
    def.wire = touch.wire;
    def.element = touch.element;
    def.slide = {};
    def.point =
        world.local_point(position_.carrier, world.world_point(position_.body, touch.point));
    def.radius = touch.radius;
    def.element_length = std::isnan(def_.element_length)
                             ? usual_length(world, touch.wire, touch.element)
                             : def_.element_length;
    def.mass_per_length = kDefault;
    auto made = engage_guide(nodes, std::move(def), touch.along);
    if (made == nullptr) return false;
    guides_[slot] = std::move(made);
    occupied_[slot] = 1;
    engaged_count_ += 1.0;
    return true;
}

/// Return the position of a wire on the bollard, along the axis from its middle [m].
double PostSystem::along(const GuideSystem& guide) const noexcept {
    return (guide.def().point - position_.centre).dot(position_.axis);
}

/// Slide a wire along the axis of a bollard.
/// @return true if the wire has reached an end of the bollard and would slide over it.
bool PostSystem::move_along_axis(NodeEdits& nodes, std::size_t slot) noexcept {
    const double at = along(*guides_[slot]), half = position_.half_length;
    const auto went = guides_[slot]->slide_sideways(nodes, {-half - at, half - at});
    slid_length_ += std::abs(went.by);
    return went.reached_end;
}

bool PostSystem::disengage(NodeEdits& nodes, std::size_t slot, bool reached_end) {
    const World& world = nodes.world;
    const GuideSystem& guide = *guides_[slot];
    bool past = reached_end;
    if (!guide.has_run_off() && !must_disengage(world, guide, past)) return false;
    occupied_[slot] = 0;  // the slot holds no wire any more
    if (!guide.has_run_off() &&
        !disengage_guide(nodes, guide, lifted_element(world, guide, past))) {
        occupied_[slot] = 1;
        return false;
    }
    disengaged_count_ += 1.0;
    steps_until_next_ = kStepsBetweenTries;
    return true;
}

void PostSystem::report_signals() noexcept {
    held_count_ = static_cast<double>(std::count(occupied_.begin(), occupied_.end(), 1));
    const auto first = std::find(occupied_.begin(), occupied_.end(), 1);
    angle_ = slide_ = along_ = tension_[0] = tension_[1] = 0.0;
    if (first == occupied_.end()) return;
    const GuideSystem& guide = *guides_[static_cast<std::size_t>(first - occupied_.begin())];
    angle_ = guide.angle();
    along_ = along(guide);
    slide_ = guide.slide();
    for (const std::size_t k : {0U, 1U}) tension_[k] = guide.tension()[k];
}

void PostSystem::before_step(NodeEdits& nodes) noexcept {
    try {
        for (std::size_t k = 0; k < occupied_.size(); ++k) {
            if (occupied_[k] == 0) continue;
            guides_[k]->before_step(nodes);
            const bool reached_end = def_.slides && move_along_axis(nodes, k);
            (void)disengage(nodes, k, reached_end);
        }
        engage_wires(nodes);
    } catch (const std::bad_alloc&) {
        nodes.out_of_memory();
    } catch (const std::exception&) {
        contact_samples_ = 0;  // out of memory: contacts are sampled again in the next step
    }
    report_signals();
}

void PostSystem::prestep(Prestep& now, Loads& loads) noexcept {
    for (std::size_t k = 0; k < occupied_.size(); ++k)
        if (occupied_[k] != 0) guides_[k]->prestep(now, loads);
}

}  // namespace hawser::wire
