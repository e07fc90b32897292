// SPDX-License-Identifier: Apache-2.0
#include <hawser/guide.h>
#include <hawser/world.h>

#include "wire/bounds.h"
#include "wire/guide_route.h"
#include "wire/guide_system.h"
#include "wire/lay_on.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const GuideDef& def, const std::string& why) {
    throw DefError("guide '" + def.name + "': " + why);
}

/// Return the distance of a point from the segment between two others [m].
double separation(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const double t = std::clamp((p - a).dot(d) / std::max(d.squaredNorm(), 1e-300), 0.0, 1.0);
    return (p - a - t * d).norm();
}

InteractionId nearest_element(const World& world, const GuideDef& def) {
    const Vec3 at = world.world_point(def.body, def.point);
    InteractionId best{};
    double least = 1e300, guided = 1e300;
    for (const InteractionId id : world.wires().elements(def.wire)) {
        if (!world.alive(id) || !world.intact(id)) continue;
        const KindInfo& kind = kind_info(world.interaction_def(id).kind);
        const std::array<Vec3, 2> ends = world.wires().ends(id);
        const double far = separation(at, ends[0], ends[1]);
        if (kind.is(kAtGuide)) guided = std::min(guided, far);
        if (kind.is(kWoundUp) || far >= least) continue;
        least = far;
        best = id;
    }
    if (!best.valid())
        throw_def_error(def, "no element of its wire is whole and without a drum or guide");
    // An element at another guide would be pulled to this one.
    constexpr double kSamePosition = 1e-3;
    if (guided < least - kSamePosition)
        throw_def_error(
            def,
            "the wire passes it with an element of another guide; two guides need a node "
            "between them: give the wire shorter elements");
    return best;
}

/// Return the elements of the guide that are already attached to its slide. @throws DefError
Guide find_existing_guide(const World& world, const GuideDef& def) {
    Guide out;
    out.slide = def.slide;
    if (!world.alive(def.slide)) throw_def_error(def, "its slide is not there");
    for (const InteractionId id : world.wires().elements(def.wire)) {
        if (!world.alive(id)) continue;
        const InteractionDef& d = world.interaction_def(id);
        if (!kind_info(d.kind).is(kAtGuide) || d.body[2] != def.slide) continue;
        (d.get("radius") < 0.0 ? out.before : out.behind) = id;
    }
    if (!out.before.valid() || !out.behind.valid())
        throw_def_error(def, "its wire has no two elements that its slide divides");
    out.friction = world.find_interaction(def.name + "/friction");
    if (!out.friction.valid())
        throw_def_error(def, "its slide has no friction of the name NAME/friction");
    out.angle = world.interaction_def(out.friction).get("angle");
    return out;
}

/// Check that the elements on both sides of the guide are long enough for nodes to run through it.
/// @throws DefError
void check_space(const World& world, const GuideDef& def, InteractionId before,
                 InteractionId behind, const std::array<double, 2>& material) {
    if (!(def.element_length > 0.0)) return;
    const auto elements = world.wires().elements(def.wire);
    const auto length = [&](InteractionId id) { return world.interaction_def(id).get("length"); };
    constexpr double kMinElementsBeside = 2.0, kRounding = 1e-6;
    // Beside another guide elements are shortened as needed (room.h). A drum creates its own.
    constexpr double kMinElementLength = 0.2;
    for (const int way : {-1, 1}) {
        auto at = std::find(elements.begin(), elements.end(), way < 0 ? before : behind);
        double sum = material[way < 0 ? 0 : 1], needed = kMinElementsBeside * def.element_length;
        for (;;) {
            if (way < 0 ? at == elements.begin() : at + 1 == elements.end()) {
                sum = 1e300;  // an end, which stops at the guide
                break;
            }
            at += way;
            if (!world.alive(*at)) break;
            sum += length(*at);
            const KindInfo& kind = kind_info(world.interaction_def(*at).kind);
            if (!kind.is(kWoundUp)) continue;
            if (kind.is(kAtGuide)) needed = std::min(needed, kMinElementLength);
            break;
        }
        if (sum < needed * (1.0 - kRounding))
            throw_def_error(def,
                            "only " + number(sum) +
                                " m of wire lie between it and the next drum or guide; nodes run "
                                "through where there are " +
                                number(needed) + " m: give shorter elements (element_length)");
    }
}

void check(World& world, const GuideDef& def) {
    if (def.name.empty()) throw DefError("a guide needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique");
    if (world.find_input(def.name + "/friction/force").valid())
        throw_def_error(def,
                        "there is an input '" + def.name + "/friction/force' already; rename one");
    if (!world.alive(def.wire)) throw_def_error(def, "its wire is missing; give one");
    if (!world.alive(def.body)) throw_def_error(def, "its body is missing; give one");
    const Nonsmooth method = world.settings().nonsmooth;
    if (method == Nonsmooth::pgs || method == Nonsmooth::split)
        throw_def_error(def,
                        "nonsmooth = pgs and split do not support loads of systems; choose newton");
    if (!std::isnan(def.element_length) &&
        !(def.element_length >= 0.0 && def.element_length <= 1e6))
        throw_def_error(def, "element_length = " + number(def.element_length) +
                                 " m; give 0 to 1e6 (0: no node runs through)");
    if (!def.closed && def.radius == 0.0)
        throw_def_error(
            def,
            "closed = false: an eye holds the wire all round; give a radius, or leave it "
            "closed");
    if (!std::isnan(def.mass_per_length) && !(def.mass_per_length >= 0.0))
        throw_def_error(
            def, "mass_per_length = " + number(def.mass_per_length) + " kg/m; give 0 or more");
}

/// Compare the drawn wire with the guide: its distance, and the side of the wheel on which it runs.
///
/// The wire turns about +axis n. With its direction u it touches the wheel on the side s = u × n of
/// the centre c:
/// - A wire drawn with a turn about n, or against it, shows the side by u₁ × u₂ · n of the elements
///   before and behind.
/// - A wire drawn straight passes the centre at the offset o = (p − c)·s, p on the element: o ≈ +R
///   for the side of the radius, o ≈ −R for the other side.
///
/// Beyond two radii neither test applies, because the wire is led to the guide from elsewhere.
/// @throws DefError
void check_position(const GuideDef& def, const InteractionDef& element, const RouteBodies& bodies,
                    const DrawnWire& drawn) {
    const auto in_world = [&](std::size_t end) -> Vec3 {
        const RouteBody b = bodies(element.body[end]);
        return b.position + b.orientation * element.point[end];
    };
    const RouteBody on = bodies(def.body);
    const Vec3 centre = on.position + on.orientation * def.point;
    const Vec3 first = in_world(0), second = in_world(1);
    const double radius = std::abs(def.radius), length = element.get("length");
    const double far = separation(centre, first, second) - radius;
    if (far > 0.5 * length)
        throw_def_error(def,
                        "its wire passes " + number(far) +
                            " m next to it, more than half of an element (" + number(0.5 * length) +
                            " m); draw the wire over the guide, or move the guide to the wire");
    if (radius == 0.0 || def.turns > 0) return;
    const Vec3 axis = (on.orientation * def.axis).normalized() * (def.radius < 0.0 ? -1.0 : 1.0);
    const Vec3 side = (second - first).normalized().cross(axis);
    if (!(side.norm() > 1e-6)) return;  // along the axis
    const double offset = (first - centre).dot(side.normalized());
    constexpr double kMinDrawnAngle = 0.05, kMaxOffsetError = 0.25,
                     kMaxCheckedDistance = 2.0;  // [rad, 1, 1]
    const double turn = drawn.before.cross(drawn.behind).dot(axis);
    const bool other =
        turn < -kMinDrawnAngle || (turn <= kMinDrawnAngle && offset < -kMaxOffsetError * radius);
    if (turn > kMinDrawnAngle || !other || std::abs(offset) > kMaxCheckedDistance * radius) return;
    throw_def_error(def, "radius = " + number(def.radius) +
                             " m: the wire is drawn on the other side of the wheel, " +
                             number(std::abs(offset)) + " m from its centre; give " +
                             number(-def.radius) +
                             ", or draw the wire on the side on which it is to run");
}

}  // namespace

GuidePlan plan_guide(const GuideDef& def, const InteractionDef& element, double tension,
                     const RouteBodies& bodies, const DrawnWire* drawn) {
    if (drawn != nullptr) check_position(def, element, bodies, *drawn);
    const RouteDef route = wire::route_over_guide(def, element, tension);
    GuidePlan out{};
    RoutePlan plan;
    try {
        out.slide = route_slides(route, bodies).front();
        // The caller numbers the bodies.
        plan = plan_route(route, bodies, std::array<BodyId, 1>{BodyId{0}});
    } catch (const DefError& error) {
        throw_def_error(def, wire::without_route(error.what()));
    }
    out.slide.name = def.name + "/slide";
    out.angle = plan.angles.front();
    if (out.angle > wire::max_turning_angle(def))
        throw_def_error(def, wire::turning_angle_error(def, element, tension, bodies, out.angle));
    out.before = std::move(plan.parts[0]);
    out.behind = std::move(plan.parts[1]);
    const double whole = element.get("length");
    out.before.name = element.name;
    out.behind.name = def.name + "/behind";
    for (InteractionDef* part : {&out.before, &out.behind}) {
        const std::size_t side = part == &out.before ? 0 : 1;
        out.material[side] = part->get("length");
        part->set("tension_only", element.get("tension_only"));
        // The default compliance follows from the length, and the damping time scales with it.
        part->compliance[0] = kDefault;
        part->damping_time[0] = element.damping_time[0] * out.material[side] / whole;
    }
    out.friction.kind = InteractionKind::LineFriction;
    out.friction.name = def.name + "/friction";
    out.friction.set("friction", def.friction)
        .set("efficiency", def.efficiency)
        .set("angle", out.angle);
    const double rubs = def.friction * out.angle - std::log(def.efficiency);
    for (FrictionLoad& load : out.friction.load) load.factor = std::tanh(0.5 * rubs);
    return out;
}

namespace wire {
namespace {

DrawnWire wire_on_drum(const World& world, WireId wire, InteractionId element) {
    const auto elements = world.wires().elements(wire);
    const auto direction = [&](std::size_t k) -> Vec3 {
        const std::array<Vec3, 2> ends = world.wires().ends(elements[k]);
        return (ends[1] - ends[0]).normalized();
    };
    std::size_t k = 0;
    while (k + 1 < elements.size() && elements[k] != element) ++k;
    const bool before = k > 0 && world.alive(elements[k - 1]);
    const bool behind = k + 1 < elements.size() && world.alive(elements[k + 1]);
    return {direction(before ? k - 1 : k), direction(behind ? k + 1 : k)};
}

/// Scale the rest lengths of both parts so that their sum is `length` [m].
void set_rest_length(GuidePlan& plan, double length) {
    const double scale = length / (plan.material[0] + plan.material[1]);
    for (InteractionDef* part : {&plan.before, &plan.behind}) {
        part->set("length", scale * part->get("length"));
        part->damping_time[0] *= scale;
    }
    for (double& m : plan.material) m *= scale;
}

}  // namespace

EndNodes end_nodes(const World& world, const InteractionDef& element) {
    EndNodes out;
    for (const BodyId end : {element.body[0], element.body[1]})
        if (const BodyDef& body = world.body_def(end); body.kind == BodyKind::lump) {
            out.mass += body.mass;
            ++out.count;
        }
    return out;
}

double mass_kept_by_nodes(const EndNodes& before, const EndNodes& after, double mass) {
    constexpr double kRounding = 1e-11;
    const double kept = 0.5 * before.count * mass - (before.mass - after.mass);
    return kept > kRounding * mass ? kept : 0.0;
}

Guide add_guide_parts(World& world, GuideDef& def, double speed, std::array<double, 2>& material,
                      bool drawn) {
    Guide out;
    const InteractionId id = def.element.valid() ? def.element : nearest_element(world, def);
    if (!world.alive(id) || world.wires().of(id) != def.wire)
        throw_def_error(def, "its element is none of its wire");
    const InteractionDef element = world.interaction_def(id);
    if (kind_info(element.kind).is(kWoundUp))
        throw_def_error(def, "its element is at a drum or another guide; choose one farther away");
    const std::array<Vec3, 2> ends = world.wires().ends(id);
    const double length = element.get("length"), mass = element.get("mass");
    if (std::isnan(def.mass_per_length)) def.mass_per_length = mass / length;
    if (std::isnan(def.element_length)) def.element_length = mass > 0.0 ? length : 0.0;
    if (def.element_length > 0.0 && !(mass > 0.0))
        throw_def_error(def,
                        "element_length: its wire's elements have no mass of their own that could "
                        "run through (consistent_mass)");
    const double tension = element.get("EA") * ((ends[1] - ends[0]).norm() / length - 1.0);
    const DrawnWire wire = wire_on_drum(world, def.wire, id);
    const auto body_of = [&world, &def](BodyId b) {
        if (!world.alive(b)) throw_def_error(def, "one of its bodies is not there");
        const Pose pose = world.pose(b);
        return RouteBody{pose.position, pose.orientation, world.body_def(b).kind,
                         world.body_def(b).mass};
    };
    GuidePlan plan = plan_guide(def, element, tension, body_of, drawn ? &wire : nullptr);
    // A wire that comes back to an open guide keeps its rest length, not the tension of a chord.
    if (!drawn && !def.closed)
        set_rest_length(plan, mass > 0.0 ? mass / def.mass_per_length : length);
    material = {plan.material[0], plan.material[1]};
    check_space(world, def, id, id, material);
    plan.slide.velocity.x() = speed;
    const EndNodes had = end_nodes(world, element);
    out.slide = world.add_body(plan.slide);
    try {
        for (InteractionDef* part : {&plan.before, &plan.behind}) part->body[2] = out.slide;
        const auto parts = world.wires().engage(id, plan.before, plan.behind);
        out.before = parts[0];
        out.behind = parts[1];
    } catch (...) {
        (void)world.remove_body(out.slide);
        throw;
    }
    plan.friction.body[0] = out.slide;
    plan.friction.load[0].interaction = out.before;
    plan.friction.load[1].interaction = out.behind;
    out.friction = world.add_interaction(plan.friction);
    out.angle = plan.angle;
    def.slide = out.slide;
    if (const double kept = mass_kept_by_nodes(had, end_nodes(world, element), mass); kept > 0.0)
        for (double& m : material) m *= 1.0 - kept / mass;
    return out;
}

InputId add_stop(World& world, const GuideDef& def, const Guide& guide) {
    return world.add_input(
        {.name = def.name + "/friction/force", .interaction = guide.friction, .param = "force"});
}

}  // namespace wire

Guide define(World& world, const GuideDef& given) {
    GuideDef def = given;
    check(world, def);
    Guide out;
    std::array<double, 2> material{};
    if (def.slide.valid()) {
        out = find_existing_guide(world, def);
        for (const std::size_t side : {0U, 1U})
            material[side] =
                world.interaction_def(side == 0 ? out.before : out.behind).get("length");
        if (std::isnan(def.mass_per_length) || std::isnan(def.element_length))
            throw_def_error(def, "with a slide of its own give mass_per_length and element_length");
        check_space(world, def, out.before, out.behind, material);
    } else {
        out = wire::add_guide_parts(world, def, 0.0, material, true);
    }
    const InputId stop = wire::add_stop(world, def, out);
    world.add_system(std::make_unique<wire::GuideSystem>(def, out, stop, material));
    return out;
}

}  // namespace hawser
