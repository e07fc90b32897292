// SPDX-License-Identifier: Apache-2.0
#include <hawser/route.h>
#include <hawser/world.h>

#include "base/wheel_tangent.h"
#include "wire/bounds.h"
#include "wire/end_stops.h"
#include "wire/route_checks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace hawser {
namespace {

using wire::check;
using wire::throw_def_error;

constexpr double kPi = 3.14159265358979323846;
/// Ratio of a slide's mass to that of the lightest body that the line pulls. It is far from two
/// limits: the force that accelerates the slide, and rounding.
constexpr double kSlideMass = 1e-6;

/// An end or a turning point of the line.
struct Corner {
    BodyId body{}, slide{};
    Vec3 point = Vec3::Zero();  ///< In the body's frame.
    Vec3 axis = Vec3::UnitY();  ///< In the body's frame.
    double radius = 0.0;        ///< Signed [m].
    double out = 0.0;           ///< Length that the part behind gains per unit of slide.
    Vec3 centre = Vec3::Zero(), normal = Vec3::UnitY();  ///< World frame.
    Quat orientation = Quat::Identity();                 ///< Orientation of the body.
};

/// The straight part between two corners: its ends and direction.
struct StraightPart {
    Vec3 from, to, along;
    double length;
};

/// Correct the tangent between two wheels with axes that are not parallel.
/// @param s  In: approximate line.
void correct_skew_tangent(const Corner& a, const Corner& b, StraightPart& s) {
    const auto small = [](const Vec3& v) { return generic::V3{v.x(), v.y(), v.z()}; };
    const generic::V3 axes[2] = {small(a.normal), small(b.normal)};
    if (generic::are_parallel(axes[0], axes[1])) return;
    const double radii[2] = {a.radius, b.radius};
    generic::V3 q[2];
    generic::tangent_between_wheels(small(b.centre - a.centre), axes, radii, small(s.to - s.from),
                                    q);
    s.from = a.centre + a.radius * Vec3(q[0].x, q[0].y, q[0].z);
    s.to = b.centre + b.radius * Vec3(q[1].x, q[1].y, q[1].z);
}

/// Return the straight part between two corners, by the formulas of model/kinds/routes.h.
StraightPart straight_between(const RouteDef& def, const Corner& a, const Corner& b) {
    const Vec3 d = b.centre - a.centre;
    StraightPart s{a.centre, b.centre, Vec3::UnitX(), 0.0};
    if (a.radius != 0.0 || b.radius != 0.0) {
        const Vec3 n = a.radius != 0.0 ? a.normal : b.normal;
        const double turn = a.radius != 0.0 && a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
        const double r1 = b.radius * (a.radius != 0.0 ? turn : 1.0), separation = r1 - a.radius;
        const Vec3 flat = d - d.dot(n) * n;
        const double size = flat.norm();
        if (!(size > std::abs(separation) * (1.0 + 1e-9)))
            throw_def_error(
                def, "two of its wheels, or a wheel and an end, are closer than their radii");
        const double c = std::sqrt(size * size - separation * separation);
        const Vec3 u = (c * flat - separation * n.cross(flat)) / (size * size);
        s.from += a.radius * u.cross(n);
        s.to += r1 * u.cross(n);
        if (a.radius != 0.0 && b.radius != 0.0) correct_skew_tangent(a, b, s);
    }
    s.length = (s.to - s.from).norm();
    if (!(s.length > 1e-6))
        throw_def_error(def, "two of its turning points, or a turning point and an end, coincide");
    s.along = (s.to - s.from) / s.length;
    return s;
}

/// Return the angle by which the line turns at a corner [rad].
double turned(const Corner& c, const RoutePlace& place, const Vec3& before, const Vec3& behind) {
    double angle = std::atan2(before.cross(behind).norm(), before.dot(behind));
    if (c.radius != 0.0) {
        const double about = std::atan2(before.cross(behind).dot(c.normal), before.dot(behind));
        angle = c.radius > 0.0 ? about : -about;
        if (angle < -1e-9) angle += 2.0 * kPi;
        angle = std::max(angle, 0.0);
    }
    return angle + 2.0 * kPi * place.turns;
}

/// Return the frame of a turning point: z along the wheel's axis, x towards the point where the
/// line touches the wheel.
Quat frame_at(const Quat& orientation, const Corner& c, const Vec3& touches) {
    const Vec3 z = orientation.conjugate() * c.normal;
    Vec3 x = orientation.conjugate() * (touches - c.centre);
    x -= x.dot(z) * z;
    x.normalize();
    Mat3 m;
    m.col(0) = x;
    m.col(1) = z.cross(x);
    m.col(2) = z;
    return Quat(m);
}

std::vector<Corner> route_corners(const RouteDef& def, const RouteBodies& bodies) {
    std::vector<Corner> corners;
    const auto end = [&](const RouteEnd& e) {
        Corner c;
        c.body = e.body;
        c.point = e.point;
        c.slide = e.drum;
        c.out = e.radius;
        corners.push_back(c);
    };
    end(def.first);
    for (const RoutePlace& p : def.places) {
        Corner c;
        c.body = p.body;
        c.point = p.point;
        c.axis = p.axis.norm() > 0.0 ? Vec3(p.axis.normalized()) : Vec3(Vec3::UnitY());
        c.radius = p.radius;
        c.out = 1.0;
        corners.push_back(c);
    }
    end(def.last);
    for (Corner& c : corners) {
        const RouteBody body = bodies(c.body);
        c.orientation = body.orientation;
        c.centre = body.position + body.orientation * c.point;
        c.normal = body.orientation * c.axis;
    }
    return corners;
}

std::string part_name(const RouteDef& def, const char* what, std::size_t i) {
    return def.name.empty() ? std::string() : def.name + "/" + what + std::to_string(i + 1);
}

/// Compute the length of line on each turning point [m], and the angles.
std::vector<double> contact_arcs(const RouteDef& def, const std::vector<Corner>& corners,
                                 const std::vector<StraightPart>& straight,
                                 std::vector<double>& angles) {
    std::vector<double> arcs;
    for (std::size_t i = 0; i < def.places.size(); ++i) {
        const RoutePlace& p = def.places[i];
        const double angle = turned(corners[i + 1], p, straight[i].along, straight[i + 1].along);
        arcs.push_back(angle * std::abs(p.radius));
        angles.push_back(std::isnan(p.angle) ? angle : p.angle);
    }
    return arcs;
}

/// Return the interaction of a part between two corners.
/// @param lies  Stretched length with half of the arcs at its ends [m].
/// @param own  Rest length [m].
/// @param to_end  True if the line ends behind the part.
InteractionDef line_part(const RouteDef& def, const Corner& a, const Corner& b,
                         const StraightPart& straight, double lies, double own, bool to_end) {
    InteractionDef d;
    d.damping_time[0] = def.damping_time;
    const double to_b = to_end ? b.out : -1.0;
    const bool both = a.slide.valid() && b.slide.valid();
    if (a.body == b.body) {
        if (!both)
            throw_def_error(def,
                            "an end is attached to the same body as the turning point next to it");
        d.kind = InteractionKind::BodySpan;
        d.body[0] = a.slide;
        d.body[1] = b.slide;
        d.set("path", lies).set("length", own).set("EA", def.EA);
        d.set("slide_0", a.out).set("slide_1", to_b);
        return d;
    }
    d.kind = both ? InteractionKind::Span : InteractionKind::EndSpan;
    d.body[0] = a.body;
    d.body[1] = b.body;
    d.point[0] = a.point;
    d.point[1] = b.point;
    if (a.radius != 0.0) d.frame[0] = frame_at(a.orientation, a, straight.from);
    if (b.radius != 0.0) d.frame[1] = frame_at(b.orientation, b, straight.to);
    d.set("EA", def.EA).set("breaking_load", def.breaking_load);
    if (!both) {
        const bool at_a = a.slide.valid();
        const double wheel = at_a ? a.radius : b.radius;
        d.body[2] = at_a ? a.slide : b.slide;
        d.set("radius", at_a ? a.out : to_b).set("wheel", wheel).set("length", own);
        if (wheel != 0.0) d.set("wound", (lies - straight.length) / std::abs(wheel));
        d.compliance[0] = own / def.EA;
        return d;
    }
    d.body[2] = a.slide;
    d.body[3] = b.slide;
    d.set("slide_0", a.out).set("slide_1", to_b);
    d.set("wheel_0", a.radius).set("wheel_1", b.radius);
    // The path of the interaction contains only changes of the arcs.
    d.set("length", own - (lies - straight.length));
    d.compliance[0] = own / def.EA;
    return d;
}

RouteBodies route_bodies(const World& world, const RouteDef& def) {
    return [&world, &def](BodyId id) {
        if (!world.alive(id)) throw_def_error(def, "one of its bodies is not there");
        const Pose pose = world.pose(id);
        const BodyDef& body = world.body_def(id);
        return RouteBody{pose.position, pose.orientation, body.kind, body.mass};
    };
}

/// Return the mass of a slide in units of the lightest body.
///
/// The acceleration of a slide is a difference of tensions divided by its mass, so its rounding
/// error is ε T/m. With much friction the tensions T₁ ≪ T₂ at a turning point differ by a factor of
/// up to e^{μδ}, and rounding of T₂ would move the slide at the light end. For ratios above 10⁴ the
/// mass therefore grows in proportion, up to a thousandth of the lightest body.
double slide_mass(const RouteDef& def, const RouteBodies& bodies, double lightest,
                  double heaviest) {
    constexpr double kMaxTensionRatio = 1e4, kMaxSlideMass = 1e-3;
    const std::vector<Corner> corners = route_corners(def, bodies);
    std::vector<StraightPart> straight;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        straight.push_back(straight_between(def, corners[i], corners[i + 1]));
    std::vector<double> angles;
    (void)contact_arcs(def, corners, straight, angles);
    double exponent = 0.0;
    for (std::size_t i = 0; i < def.places.size(); ++i)
        exponent += def.places[i].friction * angles[i];
    const double ratio = std::min(std::exp(exponent), heaviest / lightest);
    return lightest * std::clamp(kSlideMass * ratio / kMaxTensionRatio, kSlideMass, kMaxSlideMass);
}

}  // namespace

std::vector<BodyDef> route_slides(const RouteDef& def, const RouteBodies& bodies) {
    check(bodies, def);
    double lightest = 1e30, heaviest = 0.0;
    for (const Corner& c : route_corners(def, bodies)) {
        const RouteBody body = bodies(c.body);
        const bool moves = body.kind == BodyKind::lump || body.kind == BodyKind::rigid;
        if (moves) lightest = std::min(lightest, body.mass);
        heaviest = std::max(heaviest, moves ? body.mass : 1e30);
    }
    if (!(lightest < 1e30)) lightest = 1.0;
    const double mass = slide_mass(def, bodies, lightest, heaviest);
    std::vector<BodyDef> slides;
    for (std::size_t i = 0; i < def.places.size(); ++i) {
        const RoutePlace& p = def.places[i];
        BodyDef slide{.name = part_name(def, "slide", i), .kind = BodyKind::scalar};
        slide.mass = mass;
        if (p.inertia > 0.0) slide.mass = std::max(slide.mass, p.inertia / (p.radius * p.radius));
        slide.gravity = false;
        slides.push_back(std::move(slide));
    }
    return slides;
}

RoutePlan plan_route(const RouteDef& def, const RouteBodies& bodies,
                     std::span<const BodyId> slides) {
    check(bodies, def);
    std::vector<Corner> corners = route_corners(def, bodies);
    for (std::size_t i = 0; i < slides.size(); ++i) corners[i + 1].slide = slides[i];
    std::vector<StraightPart> straight;
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
        straight.push_back(straight_between(def, corners[i], corners[i + 1]));
    RoutePlan out;
    const std::vector<double> arcs = contact_arcs(def, corners, straight, out.angles);
    // Half of each arc belongs to the part before it, half to the part behind.
    double path = 0.0;
    std::vector<double> lies;
    for (std::size_t i = 0; i < straight.size(); ++i) {
        lies.push_back(straight[i].length + (i > 0 ? 0.5 * arcs[i - 1] : 0.0) +
                       (i + 1 < straight.size() ? 0.5 * arcs[i] : 0.0));
        path += lies.back();
    }
    const double length = std::isnan(def.length) ? path / (1.0 + def.tension / def.EA) : def.length;
    if (path > 1.5 * length)
        throw_def_error(def, "its path over the turning points is " + number(path) +
                                 " m long, but it has " + number(length) +
                                 " m, more than half longer than the line; give it more length");
    for (std::size_t i = 0; i < straight.size(); ++i) {
        const bool to_end = i + 1 == straight.size();
        out.parts.push_back(line_part(def, corners[i], corners[i + 1], straight[i], lies[i],
                                      lies[i] * length / path, to_end));
        out.parts.back().name = part_name(def, "part", i);
    }
    for (std::size_t i = 0; i < def.places.size(); ++i) {
        const RoutePlace& p = def.places[i];
        const double rubs = p.friction * out.angles[i] - std::log(p.efficiency);
        if (rubs == 0.0) continue;
        InteractionDef f;
        // A given angle need not equal the current one.
        const bool follows = std::isnan(p.angle);
        f.kind = follows ? InteractionKind::LineFriction : InteractionKind::ScalarFriction;
        f.name = part_name(def, "friction", i);
        f.body[0] = corners[i + 1].slide;
        if (follows)
            f.set("friction", p.friction)
                .set("efficiency", p.efficiency)
                .set("angle", out.angles[i]);
        for (FrictionLoad& load : f.load) load.factor = std::tanh(0.5 * rubs);
        out.frictions.push_back({i, std::move(f)});
    }
    return out;
}

void stop_ends(World& world, const std::string& name, std::vector<InteractionId> parts) {
    if (world.find_system(name) != nullptr)
        throw DefError("end stops '" + name + "': the name is in use; names must be unique");
    for (const InteractionId id : parts)
        if (!world.alive(id) || world.interaction_def(id).kind != InteractionKind::EndSpan)
            throw DefError("end stops '" + name + "': each part must be an end_span");
    world.add_system(std::make_unique<wire::EndStops>(name, std::move(parts)));
}

namespace {

/// Add stops to the ends of a route that are fastened to bodies, under the first free name.
void add_end_stops(World& world, const RouteDef& def, const Route& route) {
    std::vector<InteractionId> ends;
    for (const InteractionId id : route.parts)
        if (world.interaction_def(id).kind == InteractionKind::EndSpan) ends.push_back(id);
    if (ends.empty()) return;
    const std::string name = (def.name.empty() ? std::string("route") : def.name) + "/ends";
    std::string free = name;
    for (int i = 2; world.find_system(free) != nullptr; ++i) free = name + std::to_string(i);
    stop_ends(world, free, std::move(ends));
}

}  // namespace

Route define(World& world, const RouteDef& def) {
    const RouteBodies bodies = route_bodies(world, def);
    Route out;
    try {
        for (const BodyDef& slide : route_slides(def, bodies))
            out.slides.push_back(world.add_body(slide));
        RoutePlan plan = plan_route(def, bodies, out.slides);
        for (const InteractionDef& part : plan.parts)
            out.parts.push_back(world.add_interaction(part));
        out.frictions.resize(def.places.size());
        for (RoutePlan::Friction& f : plan.frictions) {
            for (std::size_t k = 0; k < 2; ++k) f.def.load[k].interaction = out.parts[f.place + k];
            out.frictions[f.place] = world.add_interaction(f.def);
        }
        out.angles = std::move(plan.angles);
        add_end_stops(world, def, out);
    } catch (...) {
        // Removing the slides removes everything attached to them.
        for (const BodyId id : out.slides) world.remove_body(id);
        throw;
    }
    return out;
}

}  // namespace hawser
