// SPDX-License-Identifier: Apache-2.0
#include "verify/interaction_forces.h"

#include "verify/line_path.h"
#include "verify/step_velocity.h"

#include <cmath>

namespace hawser::verify {

namespace {

std::size_t place(int i) { return static_cast<std::size_t>(i); }

/// True if the rest length of a winch_stretch depends on its drum, because it exceeds the least
/// rest length.
bool pays_out(const InteractionDef& def, double drum) {
    const double length = def.get("length");
    return length + def.get("radius") * (drum - def.get("drum_zero")) >
           kLeastOfDrumElement * length;
}

/// Collects the forces of one interaction.
class Forces : public Attached {
  public:
    using Attached::Attached;
    Wrenches result;

    void push(int slot, const Vec3& force, const Vec3& where) {
        Wrench& w = result.on[place(slot)];
        w.force += force;
        w.torque += (where - center(slot)).cross(force);
    }
    /// Add a force on body 1 and its reaction on body 0.
    void add_force_pair(const Vec3& force, const Vec3& on_0, const Vec3& on_1) {
        push(0, -force, on_0);
        push(1, force, on_1);
    }
    /// Add a torque on body 1 and its reaction on body 0.
    void turn(const Vec3& torque) {
        result.on[0].torque -= torque;
        result.on[1].torque += torque;
    }
    /// Add rows 0-2: both bodies at their own points, which coincide up to the violation.
    void add_coincidence(std::span<const double> f) {
        add_force_pair(Vec3(f[0], f[1], f[2]), point(0), point(1));
    }
    /// Add a force along an axis of body 0, at the point of body 1 for both bodies.
    void add_axis_force(int axis_of_0, double f) {
        add_force_pair(f * axis(0, axis_of_0), point(1), point(1));
    }
    /// Add the row p·q = 0 of an axis of each body: the torque that increases the angle between p
    /// and q.
    void add_perpendicularity(int axis_of_0, int axis_of_1, double f) {
        turn(f * axis(1, axis_of_1).cross(axis(0, axis_of_0)));
    }
    /// Add a torque about the mean of both z axes, scaled so that the rotation of each frame about
    /// its own axis counts fully.
    void add_relative_torque(double f) {
        const Vec3 a = axis(0, 2), b = axis(1, 2);
        turn(f / (1.0 + a.dot(b)) * (a + b));
    }
    /// Add the torques of a gear: two wheels on a carrier (slot 0), in the ratio of their teeth,
    /// each about its own axis.
    void add_gear(double f) {
        const Vec3 a = axis(0, 2);
        for (int k = 1; k <= 2; ++k) {
            const Vec3 b = axis(k, 2);
            const double ratio = k == 1 ? 1.0 : def().get("teeth_2") / def().get("teeth_1");
            const Vec3 torque = f * ratio / (1.0 + a.dot(b)) * (a + b);
            result.on[0].torque -= torque;
            result.on[place(k)].torque += torque;
        }
    }
    void add_scalar_force(int slot, double f) { result.on[place(slot)].force.x() += f; }
    void add_clutch(double f) {
        add_scalar_force(0, -f);
        add_scalar_force(1, f);
    }
    void line(double f) {
        const Vec3 from = point(0), to = point(1), d = to - from;
        const double length = d.norm();
        add_force_pair(f * (length > 1e-12 ? Vec3(d / length) : Vec3(Vec3::UnitX())), from, to);
    }
    void span(double f);
    bool piece_of_line(std::span<const double> f);
    void add_bend(std::span<const double> f);
    void hydrostatic(std::span<const double> f);
};

void Forces::span(double f) {
    const LineEnds ends = line_ends(*this);
    add_force_pair(f * ends.along, ends.at[0], ends.at[1]);
    if (def().kind == InteractionKind::EndSpan)
        return add_scalar_force(2, -f * def().get("radius"));
    for (int k = 0; k < 2; ++k)
        add_scalar_force(2 + k, -f * def().get(k == 0 ? "slide_0" : "slide_1"));
}

// Add the forces of a bend. Its rows are along n₁ and n₂ = t × n₁, perpendicular to the mean
// tangent t. To find n₁, use the world axis with the largest angle to t, minus its component along
// t. The energy of the moment N = Σ f n is N·(e₂ − e₁), whose gradients are the forces on the
// nodes.
void Forces::add_bend(std::span<const double> f) {
    if (f[0] == 0.0 && f[1] == 0.0) return;
    const Vec3 p[3] = {point(0), point(1), point(2)};
    const Vec3 d1 = p[1] - p[0], d2 = p[2] - p[1];
    // Segments shorter than a tenth of the mean length do not rotate as unit vectors do.
    const double shortest = 0.1 * def().get("length");
    const double l1 = std::max(d1.norm(), shortest), l2 = std::max(d2.norm(), shortest);
    const Vec3 e1 = d1 / l1, e2 = d2 / l2, t = (e1 + e2).normalized();
    int least = 0, next = 1, most = 2;
    const auto size = [&](int k) { return std::abs(t[k]); };
    if (size(next) < size(least)) std::swap(next, least);
    if (size(most) < size(next)) std::swap(most, next);
    if (size(next) < size(least)) std::swap(next, least);
    // If two axes are equal up to rounding, or the line is folded back on itself, the choice is
    // ambiguous. Positions of nodes are exact, attachment points of rigid bodies are not.
    const bool exact = is_point(0) && is_point(1) && is_point(2);
    const auto terms = [&](int k) { return std::abs(e1[k]) + std::abs(e2[k]); };
    const double noise = 1e-12 * (exact ? terms(least) + terms(next) : 1.0);
    if (size(next) - size(least) < noise || (e1 + e2).norm() < 1e-6) {
        result.is_known = false;
        return;
    }
    const Vec3 n1 = (Vec3::Unit(least) - t[least] * t).normalized();
    const Vec3 moment = f[0] * n1 + f[1] * t.cross(n1);
    const auto orthogonal = [&](const Vec3& e, double length) -> Vec3 {
        const double along = length > shortest ? moment.dot(e) : 0.0;
        return (moment - along * e) / length;
    };
    const Vec3 first = orthogonal(e1, l1), last = orthogonal(e2, l2);
    push(0, first, p[0]);
    push(1, -first - last, p[1]);
    push(2, last, p[2]);
}

// Apply the moments of roll and pitch. Roll is the height of the body's y axis, pitch minus the
// height of its x axis.
void Forces::hydrostatic(std::span<const double> f) {
    const Quat q = is_point(0) ? Quat::Identity() : Quat(frame(0));
    const Vec3 up = Vec3::UnitZ();
    push(0, f[0] * up, center(0));
    result.on[0].torque += f[1] * (q * Vec3::UnitY()).cross(up);
    result.on[0].torque -= f[2] * (q * Vec3::UnitX()).cross(up);
}

// Add the forces of a part of a route or of a wire at a guide. @return false if the kind is no such
// part.
bool Forces::piece_of_line(std::span<const double> f) {
    switch (def().kind) {
        case InteractionKind::WinchStretch:
            if (pays_out(def(), center(2).x())) add_scalar_force(2, -f[0] * def().get("radius"));
            [[fallthrough]];
        case InteractionKind::Distance:
        case InteractionKind::Stretch:
            line(f[0]);
            break;
        case InteractionKind::Span:
        case InteractionKind::EndSpan:
            span(f[0]);
            break;
        case InteractionKind::BodySpan:
            for (int k = 0; k < 2; ++k)
                add_scalar_force(k, -f[0] * def().get(k == 0 ? "slide_0" : "slide_1"));
            break;
        case InteractionKind::Bend:
            add_bend(f);
            break;
        default:
            return false;
    }
    return result.is_known;
}

}  // namespace

Twist Attached::velocity(int slot) const {
    return step_velocity(world_, def_.body[static_cast<std::size_t>(slot)], at(slot));
}

const Pose& Attached::at(int slot) const {
    return pose_[static_cast<std::size_t>(def_.body[place(slot)].index)];
}

BodyKind Attached::kind(int slot) const { return world_.body_def(def_.body[place(slot)]).kind; }

bool Attached::is_point(int slot) const {
    return kind(slot) == BodyKind::lump || kind(slot) == BodyKind::scalar;
}

Vec3 Attached::point(int slot) const {
    const Pose& pose = at(slot);
    if (is_point(slot)) return pose.position;
    return pose.position + pose.orientation * def_.point[place(slot)];
}

Quat Attached::frame(int slot) const {
    const Quat own =
        kind_info(def_.kind).uses_frames ? def_.frame[place(slot)].normalized() : Quat::Identity();
    return is_point(slot) ? own : at(slot).orientation * own;
}

double parameter(const World& world, InteractionId id, std::string_view name) {
    for (const InputId i : world.inputs()) {
        const InputDef& input = world.input_def(i);
        if (input.interaction == id && input.param == name) return world.input(i);
    }
    return world.interaction_def(id).get(name);
}

Wrenches row_wrenches(const World& world, InteractionId id, std::span<const Pose> pose,
                      std::span<const double> f) {
    Forces on(world, id, pose);
    switch (on.def().kind) {
        case InteractionKind::Ball:
            on.add_coincidence(f);
            break;
        case InteractionKind::Lock:
            on.add_perpendicularity(0, 1, f[5]);
            [[fallthrough]];
        case InteractionKind::Hinge:
            on.add_coincidence(f);
            on.add_perpendicularity(0, 2, f[3]);
            on.add_perpendicularity(1, 2, f[4]);
            break;
        case InteractionKind::Universal:
            on.add_coincidence(f);
            on.add_perpendicularity(2, 2, f[3]);
            break;
        case InteractionKind::Prismatic:
            on.add_perpendicularity(0, 1, f[4]);
            [[fallthrough]];
        case InteractionKind::Cylindrical:
            on.add_axis_force(0, f[0]);
            on.add_axis_force(1, f[1]);
            on.add_perpendicularity(0, 2, f[2]);
            on.add_perpendicularity(1, 2, f[3]);
            break;
        case InteractionKind::HingeRange:
        case InteractionKind::HingeFriction:
        case InteractionKind::Twist:
            on.add_relative_torque(f[0]);
            break;
        case InteractionKind::HingeMotor:
            on.turn(f[0] * on.axis(0, 2));
            break;
        case InteractionKind::SlideMotor:
        case InteractionKind::SlideRange:
        case InteractionKind::SlideFriction:
            on.add_axis_force(2, f[0]);
            break;
        case InteractionKind::Hold:
        case InteractionKind::ScalarMotor:
        case InteractionKind::ScalarFriction:
        case InteractionKind::LineFriction:
            on.add_scalar_force(0, f[0]);
            break;
        case InteractionKind::ScalarClutch:
            on.add_clutch(f[0]);
            break;
        case InteractionKind::Gear:
            on.add_gear(f[0]);
            break;
        case InteractionKind::Hydrostatic:
            on.hydrostatic(f);
            break;
        default:
            on.result.is_known = on.piece_of_line(f);
    }
    return on.result;
}

}  // namespace hawser::verify
