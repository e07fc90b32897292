// SPDX-License-Identifier: Apache-2.0
/// Joining of wire ends, and attachment to bodies (hawser/wire.h, edit/wire_ends.h).
#include <hawser/world.h>

#include "context/push_event.h"
#include "edit/edits.h"
#include "edit/node_pieces.h"
#include "edit/wire_ends.h"
#include "split/split.h"
#include "world/checks.h"
#include "world/impl.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace hawser {
namespace world {

void check(const JoinDef& def) {
    const Where where("gear", def.name);
    const auto check = [&](const char* what, double value, double least, double most) {
        if (!(value >= least && value <= most))
            throw_def_error(where, std::string(what) + " = " + number(value) + "; give " +
                                       number(least) + " to " + number(most));
    };
    constexpr double kMaxReach = 1e6, kMaxMass = 1e12, kMaxEA = 1e15, kMinPositive = 1e-3;
    if (static_cast<std::uint8_t>(def.gear) > static_cast<std::uint8_t>(Gear::pelican_hook))
        throw_def_error(where, "there is no such gear");
    const bool plate = def.gear == Gear::triplate;
    check("mass", def.mass, plate ? kMinPositive : 0.0, kMaxMass);
    check("reach", def.reach, 0.0, kMaxReach);
    if (def.gear == Gear::splice) return;
    check("length", def.length, kMinPositive, kMaxReach);
    if (plate) check("radius", def.radius, kMinPositive, kMaxReach);
    if (!std::isnan(def.EA)) check("EA", def.EA, kMinPositive, kMaxEA);
    if (!std::isnan(def.breaking_load))
        check("breaking_load", def.breaking_load, kMinPositive, kMaxEA);
}

}  // namespace world

Vec3 triplate_hole(const JoinDef& def, int k) noexcept {
    constexpr double kThirdOfTurn = 2.0943951023931953;  // 2π/3
    return def.radius * Vec3(std::cos(kThirdOfTurn * k), std::sin(kThirdOfTurn * k), 0.0);
}

namespace {

void throw_if_above(const std::string& where, double separation, double most) {
    if (!(separation <= most))
        world::throw_def_error(where, "what is to be held is " + world::number(separation) +
                                          " m apart, and gear and reach are " +
                                          world::number(most) +
                                          " m; bring it nearer, or give a longer reach");
}

/// Return the first unused name of "tow/gear", "tow/gear2", …
std::string gear_name(const World& w, const std::string& wire) {
    std::string name = wire + "/gear";
    for (int k = 2; w.find_interaction(name).valid() || w.find_body(name).valid(); ++k)
        name = wire + "/gear" + std::to_string(k);
    return name;
}

}  // namespace

Joint WorldWires::join(WireId a, int end_a, WireId b, int end_b, const JoinDef& def) {
    const world::Using use(impl().use, "join");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    world::check(def);
    const world::FreeEnd one = impl().free_end(a, end_a), other = impl().free_end(b, end_b);
    const world::Wire &first = impl().wire(a), &second = impl().wire(b);
    const std::string where = world::label("wire", first.name);
    if (one.lump == other.lump) world::throw_def_error(where, "an end is not joined to itself");
    if (def.gear == Gear::splice) {
        if (a == b)
            world::throw_def_error(where,
                                   "a splice would close it to a ring; join its ends by gear");
        if ((end_a == end_b) &&
            edit::chain_from(impl().ctx, other.element.index, other.slot).size() !=
                second.elements.size())
            world::throw_def_error(
                world::label("wire", second.name),
                "it would have to be turned round, and is parted or held between its "
                "ends; join by gear");
    }
    JoinDef named = def;
    if (named.name.empty()) named.name = gear_name(*world_, first.name);
    Joint out = join(one.lump, other.lump, Vec3::Zero(), named);
    out.wire = a;
    return out;
}

Joint WorldWires::attach(WireId id, int end, BodyId body, const Vec3& point, const JoinDef& def) {
    const world::Using use(impl().use, "attach");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    world::check(def);
    const world::FreeEnd one = impl().free_end(id, end);
    const world::Wire& wire = impl().wire(id);
    if (!world_->alive(body) || world_->body_def(body).kind == BodyKind::scalar ||
        world_->body_def(body).kind == BodyKind::lump)
        world::throw_def_error(
            world::label("wire", wire.name),
            "attach() needs a body with an orientation; join() connects ends of wires");
    JoinDef named = def;
    if (named.name.empty()) named.name = gear_name(*world_, wire.name);
    Joint out = join(one.lump, body, point, named);
    out.wire = id;
    return out;
}

Joint WorldWires::join(BodyId a, BodyId b, const Vec3& point, const JoinDef& def) {
    const world::Using use(impl().use, "join");
    const Attempt attempt(*world_, impl().undoes_as_whole());
    WorldImpl& m = impl();
    world::check(def);
    (void)m.index_of(a);
    (void)m.index_of(b);
    const std::string where = world::label("gear", def.name);
    if (!point.allFinite() || !(point.norm() <= 1e7))
        world::throw_def_error(where, "point is not finite, or beyond 1e7 m");
    if (a == b) world::throw_def_error(where, "an end is not joined to itself");
    (void)m.free_end(a);
    const BodyKind kind = world_->body_def(b).kind;
    const bool lump = kind == BodyKind::lump;
    if (lump) (void)m.free_end(b);
    if (kind == BodyKind::scalar)
        world::throw_def_error(where, "a scalar body holds no end of a wire");
    if (context::has_cuts(m.ctx.model)) edit::begin_edit(m.ctx);  // remove duplicated rows first
    Joint out;
    if (def.gear == Gear::triplate) {
        if (!lump)
            world::throw_def_error(where,
                                   "a triplate joins two wires; a shackle holds an end to a body");
        out = m.add_joining_plate(*world_, a, b, def);
    } else if (def.gear == Gear::splice && lump) {
        throw_if_above(where, (world_->pose(b).position - world_->pose(a).position).norm(),
                       def.reach);
        out = m.splice(*world_, a, b);
        m.add_gear_mass(a, def.mass);
    } else {
        out = m.hold(*world_, a, b, point, def);
    }
    if (m.listener != nullptr) m.listener->joined(a, b, point, def);
    return out;
}

/// Add the mass of gear to a node. The gear has the velocity of the node.
void WorldImpl::add_gear_mass(BodyId lump, double mass) noexcept {
    if (!(mass > 0.0)) return;
    const double had = edit::energy_of_body(ctx, lump.index);
    ctx.model.bodies.mass[at(lump.index)] += mass;
    update_definition(lump);
    edit::update_elements_of_node(ctx, lump.index);
    ctx.state.ledger.edited.given += edit::energy_of_body(ctx, lump.index) - had;
}

/// Return the definition of a link from a node to a body, with gear of the given kind, in the
/// direction of the node's wire.
InteractionDef WorldImpl::make_link(const World& world, BodyId a, BodyId b, const Vec3& point,
                                    const JoinDef& def) const {
    const world::FreeEnd end = free_end(a);
    const std::size_t slot = end.slot == 1 ? 1 : 0;
    InteractionDef out;
    out.name = def.name;
    out.kind = InteractionKind::Stretch;
    out.body[1 - slot] = a;
    out.body[slot] = b;
    out.point[slot] = point;
    const double separation = (world.world_point(b, point) - world.pose(a).position).norm();
    throw_if_above(world::label("gear", def.name), separation, def.length + def.reach);
    out.set("length", std::max(def.length, separation));
    out.set("EA", std::isnan(def.EA) ? world.interaction_def(end.element).get("EA") : def.EA);
    if (!std::isnan(def.breaking_load)) out.set("breaking_load", def.breaking_load);
    return out;
}

Joint WorldImpl::hold(World& world, BodyId a, BodyId b, const Vec3& point, const JoinDef& def) {
    const double separation = (world.world_point(b, point) - world.pose(a).position).norm();
    InteractionDef d;
    if (def.gear == Gear::splice) {
        throw_if_above(world::label("gear", def.name), separation, def.reach);
        d.name = def.name;
        d.kind = InteractionKind::Ball;
        d.body = {b, a};
        d.point[0] = world.local_point(b, world.pose(a).position);
    } else {
        d = make_link(world, a, b, point, def);
    }
    std::erase_if(
        gear, [&](const world::GearInUse& g) { return !ctx.model.interactions.slots.names(g.id); });
    base::reserve_more(gear, 1);
    const bool lump = edit::is_free_node(ctx, b.index);
    Joint out;
    {
        const SilencedListener silenced(*this);
        out.held[0] = world.add_interaction(d);
    }
    // No call below throws.
    gear.push_back({out.held[0], def.gear});
    add_gear_mass(a, lump ? 0.5 * def.mass : def.mass);
    if (lump) add_gear_mass(b, 0.5 * def.mass);
    context::push_event(ctx, EventKind::join, out.held[0].index, separation);
    return out;
}

/// Add a plate with its first two holes on the line of the ends and the third as low as possible.
Joint WorldImpl::add_joining_plate(World& world, BodyId a, BodyId b, const JoinDef& def) {
    const Vec3 pa = world.pose(a).position, pb = world.pose(b).position;
    const double separation = (pb - pa).norm();
    const Vec3 h[2] = {triplate_hole(def, 0), triplate_hole(def, 1)};
    const double wide = (h[1] - h[0]).norm();
    throw_if_above(world::label("gear", def.name), separation,
                   wide + 2.0 * (def.length + def.reach));
    const Vec3 u = separation > 0.0 ? Vec3((pb - pa) / separation) : Vec3::UnitX();
    Vec3 up = -ctx.model.def.gravity;
    if (!(up.cross(u).norm() > 1e-6 * up.norm())) up = u.unitOrthogonal();
    const Vec3 y = (up - up.dot(u) * u).normalized();
    // Seen from the first two holes, the third lies across the centre, opposite their mean.
    const Vec3 along = (h[1] - h[0]).normalized(), third = -(h[0] + h[1]).normalized();
    Mat3 local, target;
    local << along, third, along.cross(third);
    target << u, -y, u.cross(-y);
    const Mat3 turn = target * local.transpose();
    BodyDef plate{.name = def.name, .kind = BodyKind::rigid};
    plate.position = 0.5 * (pa + pb) - turn * (0.5 * (h[0] + h[1]));
    plate.orientation = Quat(turn).normalized();
    plate.velocity = 0.5 * (world.velocity(a).linear + world.velocity(b).linear);
    plate.mass = def.mass;
    const double disc = 0.25 * def.mass * def.radius * def.radius;
    plate.inertia = Vec3(disc, disc, 2.0 * disc).asDiagonal();
    constexpr double kThicknessOverRadius = 0.05;
    plate.half_size = def.radius * Vec3(1.0, 1.0, kThicknessOverRadius);
    plate.group = world.body_def(a).group;
    base::reserve_more(gear, 2);
    world::Wire made;
    made.lumps.reserve(1);
    made.elements.reserve(2);
    const Mark before = mark(a, b);
    Joint out;
    try {
        const SilencedListener silenced(*this);
        made.lumps.push_back(world.add_body(plate));
        for (std::size_t k = 0; k < 2; ++k) {
            JoinDef link = def;
            link.name = def.name.empty() ? "" : def.name + "/" + std::to_string(k);
            made.elements.push_back(
                world.add_interaction(make_link(world, k == 0 ? a : b, made.lumps[0], h[k], link)));
        }
    } catch (...) {
        take_back(before, made);
        throw;
    }
    out.plate = made.lumps[0];
    for (std::size_t k = 0; k < 2; ++k) {
        out.held[k] = made.elements[k];
        gear.push_back({out.held[k], def.gear});
    }
    context::push_event(ctx, EventKind::join, out.held[0].index, separation);
    return out;
}

}  // namespace hawser
