// SPDX-License-Identifier: Apache-2.0
#include <hawser/lines.h>
#include <hawser/world.h>

#include "world/checks.h"
#include "world/define.h"

#include <cmath>
#include <utility>

namespace hawser {
namespace {

using world::set_if_given;

/// Attach to a point of a body. A node must have the point 0.
void attach(InteractionDef& def, const World& in, std::size_t slot, BodyId body,
            const Vec3& point) {
    def.body[slot] = body;
    def.point[slot] = point;
    if (!point.isZero(0.0) && in.body_def(body).kind == BodyKind::lump)
        throw DefError(std::string(kind_info(def.kind).name) + " " +
                       (def.name.empty() ? "(unnamed)" : "'" + def.name + "'") +
                       ": a point mass has no attachment points; leave the point at 0");
}

template <class Def>
InteractionDef line(const World& in, InteractionKind kind, const Def& def) {
    InteractionDef out;
    out.kind = kind;
    out.name = def.name;
    attach(out, in, 0, def.a, def.point_a);
    attach(out, in, 1, def.b, def.point_b);
    set_if_given(out, "length", def.length);
    out.damping_time[0] = def.damping_time;
    return out;
}

template <class Def>
void set_stretch(InteractionDef& out, const Def& def) {
    set_if_given(out, "EA", def.EA);
    set_if_given(out, "breaking_load", def.breaking_load);
    if (def.tension_only) out.set("tension_only", *def.tension_only ? 1.0 : 0.0);
}

}  // namespace

InteractionId define(World& world, const DistanceDef& def) {
    InteractionDef out = line(world, InteractionKind::Distance, def);
    out.compliance[0] = def.compliance;
    return world.add_interaction(out);
}

InteractionId define(World& world, const StretchDef& def) {
    InteractionDef out = line(world, InteractionKind::Stretch, def);
    set_stretch(out, def);
    out.set("mass", def.mass);
    return world.add_interaction(out);
}

InteractionId define(World& world, const WinchStretchDef& def) {
    InteractionDef out = line(world, InteractionKind::WinchStretch, def);
    out.body[2] = def.drum;
    set_stretch(out, def);
    set_if_given(out, "radius", def.radius);
    return world.add_interaction(out);
}

InteractionId define(World& world, const BendDef& def) {
    InteractionDef out;
    out.kind = InteractionKind::Bend;
    out.name = def.name;
    attach(out, world, 0, def.first, def.point_first);
    attach(out, world, 1, def.middle, def.point_middle);
    attach(out, world, 2, def.last, def.point_last);
    set_if_given(out, "EI", def.EI);
    set_if_given(out, "length", def.length);
    out.damping_time.fill(def.damping_time);
    return world.add_interaction(out);
}

InteractionId define(World& world, const TwistDef& def) {
    InteractionDef out;
    out.kind = InteractionKind::Twist;
    out.name = def.name;
    out.body = {def.a, def.b};
    world::set_frames(out, world, 2, def.axis, JointFrame::world);
    set_if_given(out, "GJ", def.GJ);
    set_if_given(out, "length", def.length);
    out.damping_time.fill(def.damping_time);
    return world.add_interaction(out);
}

InteractionId define(World& world, const HydrostaticDef& def) {
    InteractionDef out;
    out.kind = InteractionKind::Hydrostatic;
    out.name = def.name;
    out.body[0] = def.body;
    set_if_given(out, "heave_stiffness", def.heave_stiffness);
    set_if_given(out, "roll_stiffness", def.roll_stiffness);
    set_if_given(out, "pitch_stiffness", def.pitch_stiffness);
    set_if_given(out, "heave_damping", def.heave_damping);
    set_if_given(out, "roll_damping", def.roll_damping);
    set_if_given(out, "pitch_damping", def.pitch_damping);
    set_if_given(out, "rest_height", def.rest_height);
    return world.add_interaction(out);
}

DrumIds define(World& world, const DrumDef& def) {
    world::Parts parts;
    DrumIds ids;
    const auto part = [&](InteractionKind kind, const char* what) {
        InteractionDef out;
        out.kind = kind;
        out.name = world::part_name(def.name, what);
        out.body[0] = def.drum;
        return out;
    };
    if (def.motor) {
        InteractionDef out = part(InteractionKind::ScalarMotor, "motor");
        world::set_motor(out, *def.motor);
        parts.add(std::move(out), ids.motor);
    }
    if (def.friction) {
        InteractionDef out = part(InteractionKind::ScalarFriction, "friction");
        if (def.friction->own_load != 0.0)
            throw DefError(world::label("drum", def.name) +
                           ": own_load: a drum has no joint that could press; use load");
        world::set_friction(out, *def.friction);
        parts.add(std::move(out), ids.friction);
    }
    if (def.hold) {
        InteractionDef out = part(InteractionKind::Hold, "hold");
        out.set("target", *def.hold);
        parts.add(std::move(out), ids.hold);
    }
    if (parts.defs.empty())
        throw DefError(world::label("drum", def.name) + ": give a motor, friction or hold");
    parts.add_to(world);
    return ids;
}

}  // namespace hawser
