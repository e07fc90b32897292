// SPDX-License-Identifier: Apache-2.0
#include "wire/winch_system.h"

#include <hawser/world.h>

#include "wire/band_brake.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hawser::wire {
namespace {

constexpr double kUnbounded = 1e30;   ///< A torque that nothing overcomes [N m].
constexpr double kStands = 1e-4;      ///< A drum whose wire is slower than this stands [m/s].
constexpr double kLeastShare = 0.02;  ///< Of the element's length, which is not hauled in.
constexpr double kGrown = 1.5, kShrunk = 0.25;  ///< Of `element`, where a node comes and goes.
constexpr double kAnyBend = 1.6;                ///< A node at a drum goes unless the wire folds.
constexpr double kNear = 1e-9;  ///< Of a force at its bound, which rounding has moved.

}  // namespace

WinchSystem::WinchSystem(WinchDef def, const DrumGeometry& drum, const WinchIds& ids,
                         const WinchInputs& inputs, double at_drum)
    : def_(std::move(def)),
      drum_(drum),
      ids_(ids),
      inputs_(inputs),
      mode_(static_cast<double>(def_.mode)),
      speed_(def_.speed),
      tension_(def_.tension),
      stored_(def_.stored),
      at_drum_(at_drum),
      set_{0.0, -kUnbounded, kUnbounded, 0.0, 1.0} {
    const DrumGeometry::Place at = drum_.place(stored_);
    radius_ = drum_.leaving_radius(stored_);
    layer_ = at.layer;
    wraps_ = at.wraps;
    across_ = at.across;
    inertia_ = def_.inertia + def_.motor_inertia + drum_.inertia(stored_, def_.mass_per_length);
    pull_limit_ = def_.torque_haul / radius_;
}

void WinchSystem::visit_state(StateVisitor& v) {
    for (double* x : {&mode_,      &speed_,   &tension_,  &brake_,      &clutch_,   &stored_,
                      &at_drum_,   &angle_,   &radius_,   &clock_,      &slip_,     &heat_,
                      &set_.speed, &set_.low, &set_.high, &set_.hold,   &set_.back, &layer_,
                      &wraps_,     &across_,  &pull_,     &pull_limit_, &inertia_,  &state_})
        v.visit(*x);
    for (std::int32_t* x : {&slipping_, &parted_, &empty_, &released_, &engaged_}) v.visit(*x);
}

void WinchSystem::signals(SignalTable& table) {
    table.input("mode", "1", mode_, 0.0, 5.0);
    table.input("speed", "m/s", speed_, -100.0, 100.0);
    table.input("tension", "N", tension_, 0.0, 1e15);
    table.input("brake", "1", brake_, 0.0, 1.0);
    table.input("clutch", "1", clutch_, 0.0, 1.0);
    table.output("layer", "1", layer_);
    table.output("wraps", "1", wraps_);
    table.output("wire_left", "m", stored_);
    table.output("radius", "m", radius_);
    table.output("across", "m", across_);
    table.output("at_drum", "m", at_drum_);
    table.output("pull", "N", pull_);
    table.output("pull_limit", "N", pull_limit_);
    table.output("inertia", "kg m^2", inertia_);
    table.output("slip", "m", slip_);
    table.output("heat", "J", heat_);
    table.output("state", "1", state_);
}

void WinchSystem::holds(HoldTable& table) const {
    table.hold(ids_.drum);
    for (const InteractionId id : {ids_.line, ids_.motor, ids_.brake}) table.hold(id);
    for (const InputId id : {inputs_.speed, inputs_.low, inputs_.high, inputs_.hold, inputs_.back,
                             inputs_.radius, inputs_.length, inputs_.drum_zero})
        table.hold(id);
}

WinchMode WinchSystem::mode() const noexcept {
    return static_cast<WinchMode>(static_cast<int>(std::lround(mode_)));
}

/// Nothing more is hauled in.
bool WinchSystem::full() const noexcept {
    return hauled_in_ || static_cast<int>(layer_) > drum_.layers() ||
           stored_ >= drum_.capacity() - drum_.wire_diameter;
}

/// What the last step came to.
void WinchSystem::look(const Prestep& now) noexcept {
    const double angle = now.world.pose(ids_.drum).position.x();
    turned_ = angle - angle_;
    angle_ = angle;
    omega_ = now.world.velocity(ids_.drum).linear.x();
    if (parted_ == 0 && !now.world.intact(ids_.line)) parted_ = 1;
    if (parted_ == 0) {
        stored_ -= radius_ * turned_;
        at_drum_ += radius_ * turned_;
    }
    pull_ = parted_ == 0 ? std::max(0.0, -now.world.force(ids_.line)[0]) : 0.0;
    if (parted_ == 0 && feeds())
        pull_ = std::max(
            0.0, pull_ + weight_of_half(now.world).dot(along_element(now.world).normalized()));
    // An element keeps its law down to a hundredth of its length (interactions.h).
    const InteractionDef& line = now.world.interaction_def(ids_.line);
    const double length = line.get("length");
    const double rest = length + radius_ * (angle_ - line.get("drum_zero"));
    hauled_in_ = rest < kLeastShare * length + 2.0 * now.step * radius_ * std::abs(omega_);
}

/// A brake at its bound, against whose torque the drum turned.
void WinchSystem::count_slip(Prestep& now) noexcept {
    const double torque = now.world.force(ids_.brake)[0];
    const double most = torque < 0.0 ? set_.hold : set_.hold * set_.back;
    const bool slips = empty_ == 0 && most > 0.0 && std::abs(torque) >= most * (1.0 - kNear) &&
                       torque * turned_ < 0.0;
    if (slips) {
        slip_ += radius_ * std::abs(turned_);
        heat_ += std::abs(torque * turned_);
        if (slipping_ == 0 && released_ == 0)
            now.tell(EventKind::brake_slip, ids_.drum, std::abs(torque));
    }
    slipping_ = slips ? 1 : 0;
}

void WinchSystem::follow_layer(Prestep& now) noexcept {
    if (parted_ != 0) return;
    const DrumGeometry::Place at = drum_.place(stored_);
    wraps_ = at.wraps;
    across_ = at.across;
    if (at.layer != static_cast<int>(layer_)) {
        layer_ = at.layer;
        now.tell(EventKind::layer, ids_.drum, layer_);
    }
    const double radius = drum_.leaving_radius(stored_);
    if (radius == radius_) return;
    const InteractionDef& line = now.world.interaction_def(ids_.line);
    const double rest = line.get("length") + radius_ * (angle_ - line.get("drum_zero"));
    radius_ = radius;
    // A rest length that has been wound in altogether has none to be kept.
    now.set_input(inputs_.length, std::max(rest, 1e-6));
    now.set_input(inputs_.drum_zero, angle_);
    now.set_input(inputs_.radius, radius_);
}

/// What of the tension comes to the wire's end on the drum, and whether that holds.
void WinchSystem::check_fastening(Prestep& now) noexcept {
    if (parted_ != 0) return;
    // A drum that its fastening stops springs back a little: it is empty until it has hauled.
    constexpr double kHauled = 0.25;  // wraps
    const bool none = stored_ <= 0.0 || (empty_ != 0 && wraps_ < kHauled);
    if (none && empty_ == 0) now.tell(EventKind::drum_empty, ids_.drum, pull_);
    empty_ = none ? 1 : 0;
    const double there = behind_wraps(pull_, def_.wrap_friction, wraps_);
    const bool breaks = def_.weak_link > 0.0 && there > def_.weak_link;
    if (breaks) now.tell(EventKind::weak_link, ids_.drum, there);
    if (!breaks && !(none && def_.weak_link == 0.0)) return;
    now.edits.part(ids_.line);
    parted_ = 1;
}

void WinchSystem::count_release(Prestep& now) noexcept {
    if (mode() != WinchMode::release) {
        clock_ = 0.0;
        released_ = 0;
        return;
    }
    constexpr double kRounding = 1e-6;  // of a sum of steps
    if (released_ == 0 && clock_ >= def_.release_delay - kRounding * now.step) {
        released_ = 1;
        now.tell(EventKind::release, ids_.drum, pull_);
    }
    clock_ += now.step;
}

void WinchSystem::order_motor(Orders& out) noexcept {
    const double at_speed = def_.power / std::max(std::abs(omega_), 1e-12);
    const double haul = std::min(def_.torque_haul, at_speed);
    const double pay = std::min(def_.torque_pay, at_speed);
    const double in = -def_.max_speed / radius_;
    const double least = std::max(tension_ - def_.deadband, 0.0) * radius_;
    pull_limit_ = haul / radius_;
    out.low = -haul;
    out.high = pay;
    switch (mode()) {
        case WinchMode::speed:
            out.speed = speed_ / radius_;
            if (wraps_ <= def_.dead_wraps && out.speed > 0.0) out.speed = 0.0;
            break;
        case WinchMode::tension:
            // It pulls with its torque until it takes in as fast as it may.
            out.speed = in;
            out.low = -std::min(tension_ * radius_, haul);
            break;
        case WinchMode::render:
            if (omega_ < 0.999 * in) {  // taking in as fast as it may
                out.speed = in;
                out.low = -std::min(least, haul);
            } else {
                out.low = -std::min((tension_ + def_.deadband) * radius_, haul);
                out.high = -std::min(least, haul);
            }
            break;
        default:
            out.low = out.high = 0.0;
    }
    if (full()) out.speed = std::max(out.speed, 0.0);
    if (clutch_ < 0.5 || parted_ != 0) out.low = out.high = out.speed = 0.0;
}

WinchSystem::Orders WinchSystem::orders() noexcept {
    Orders out;
    order_motor(out);
    const double slips = std::isnan(def_.brake_dynamic) ? def_.brake_static : def_.brake_dynamic;
    out.back = band_ratio(def_.band_friction, def_.band_angle);
    const WinchMode m = mode();
    if (parted_ != 0 || m == WinchMode::brake || (m == WinchMode::release && released_ == 0))
        out.hold = brake_ * (slipping_ != 0 ? slips : def_.brake_static);
    else if (m == WinchMode::release)
        out.hold = def_.release_load * radius_;
    if (empty_ != 0 && parted_ == 0) {  // the fastening holds: no further out, but in
        out.hold = kUnbounded;
        out.back = 0.0;
    }
    const double speed = radius_ * omega_;
    WinchState state = speed > kStands    ? WinchState::paying
                       : speed < -kStands ? WinchState::hauling
                                          : WinchState::standing;
    const bool asks_out = m == WinchMode::speed && speed_ > 0.0;
    const bool asks_in =
        (m == WinchMode::speed && speed_ < 0.0) || (m == WinchMode::tension && speed <= kStands);
    if (asks_out && wraps_ <= def_.dead_wraps) state = WinchState::last_wraps;
    if (asks_in && full()) state = WinchState::full;
    if (slipping_ != 0) state = WinchState::slipping;
    if (m == WinchMode::release)
        state = released_ != 0 ? WinchState::released : WinchState::waiting;
    if (empty_ != 0) state = WinchState::empty;
    if (parted_ != 0) state = WinchState::parted;
    state_ = static_cast<double>(state);
    return out;
}

void WinchSystem::give(Prestep& now, const Orders& o) noexcept {
    const auto set = [&](InputId id, double& last, double value) {
        if (value != last) now.set_input(id, value);
        last = value;
    };
    set(inputs_.speed, set_.speed, o.speed);
    set(inputs_.low, set_.low, o.low);
    set(inputs_.high, set_.high, o.high);
    set(inputs_.hold, set_.hold, o.hold);
    set(inputs_.back, set_.back, o.back);
}

void WinchSystem::turn_along(const Prestep& now, Loads& loads) noexcept {
    const bool engaged = clutch_ >= 0.5;
    double added = drum_.inertia(stored_, def_.mass_per_length);
    if (engaged) added += def_.motor_inertia;
    if (engaged && engaged_ == 0)  // what stood is taken along
        loads.add_force(ids_.drum, {-def_.motor_inertia * omega_ / now.step, 0.0, 0.0});
    engaged_ = engaged ? 1 : 0;
    inertia_ = def_.inertia + added;
    loads.add_mass(ids_.drum, Eigen::Matrix<double, 1, 1>(added));
}

/// From the fairlead to the first node.
Vec3 WinchSystem::along_element(const World& world) const noexcept {
    const InteractionDef& line = world.interaction_def(ids_.line);
    const std::size_t node = node_slot();
    return world.world_point(line.body[node], line.point[node]) -
           world.world_point(line.body[1 - node], line.point[1 - node]);
}

/// Of the element at the drum, by what acts on its first node beside forces of interactions.
Vec3 WinchSystem::weight_of_half(const World& world) const noexcept {
    const BodyDef& node = world.body_def(world.interaction_def(ids_.line).body[node_slot()]);
    Vec3 each = node.gravity ? world.settings().gravity : Vec3::Zero().eval();
    if (node.kind == BodyKind::lump) each += node.force / node.mass;
    return 0.5 * def_.mass_per_length * std::max(at_drum_, 0.0) * each;
}

/// What no lump has of the element at the drum acts on both of its ends.
void WinchSystem::weigh_element(const World& world, Loads& loads) const noexcept {
    if (!feeds() || parted_ != 0) return;
    const InteractionDef& line = world.interaction_def(ids_.line);
    const double half = 0.5 * def_.mass_per_length * std::max(at_drum_, 0.0);
    const Vec3 weight = weight_of_half(world), u = along_element(world).normalized();
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const BodyId body = line.body[slot];
        const BodyDef& def = world.body_def(body);
        if (def.kind != BodyKind::lump && def.kind != BodyKind::rigid) continue;
        const Pose pose = world.pose(body);
        const Vec3 arm = pose.orientation * line.point[slot];
        loads.add_force(
            body, weight,
            def.kind == BodyKind::rigid ? arm.cross(weight).eval() : Vec3::Zero().eval());
        if (def.kind != BodyKind::lump) continue;
        loads.add_mass(body, (half * Mat3::Identity()).eval());
        loads.add_damping(body,
                          (half / def.mass * def.linear_damping).asDiagonal().toDenseMatrix());
    }
    loads.add_force(ids_.drum, {radius_ * weight.dot(u), 0.0, 0.0});
    loads.add_mass(ids_.drum, Eigen::Matrix<double, 1, 1>(half * radius_ * radius_));
}

void WinchSystem::before_step(NodeEdits& nodes) noexcept {
    const World& world = nodes.world;
    if (!feeds() || parted_ != 0 || !world.intact(ids_.line)) return;
    const double angle = world.pose(ids_.drum).position.x();
    const double there = at_drum_ + radius_ * (angle - angle_);
    if (there > kGrown * def_.element) {
        const double beyond = def_.element / there, share = def_.end == 0 ? 1.0 - beyond : beyond;
        const double mass = def_.mass_per_length * there;
        // By the bits that the world takes.
        const double taken = def_.end == 0 ? 1.0 - share : share;
        if (nodes.insert_node(ids_.line, share, mass).valid()) at_drum_ -= taken * there;
    } else if (there < kShrunk * def_.element) {
        const BodyId node = world.interaction_def(ids_.line).body[node_slot()];
        if (world.body_def(node).kind != BodyKind::lump) return;
        const auto elements = world.elements(world.wire_of(ids_.line));
        if (elements.size() < 2) return;
        const InteractionId next = def_.end == 0 ? elements[1] : elements[elements.size() - 2];
        if (!world.alive(next) || !world.intact(next)) return;
        const double mass = world.interaction_def(next).get("mass");
        if (mass > 0.0 && nodes.remove_node(node, kAnyBend))
            at_drum_ += mass / def_.mass_per_length;
    }
}

void WinchSystem::prestep(Prestep& now, Loads& loads) noexcept {
    look(now);
    count_slip(now);
    follow_layer(now);
    check_fastening(now);
    count_release(now);
    give(now, orders());
    turn_along(now, loads);
    weigh_element(now.world, loads);
}

}  // namespace hawser::wire
