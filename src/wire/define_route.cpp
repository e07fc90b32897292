// SPDX-License-Identifier: Apache-2.0
#include <hawser/route.h>
#include <hawser/world.h>

#include "wire/bounds.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser {
namespace {

constexpr int kMostPlaces = 256, kMostTurns = 100;
constexpr double kPi = 3.14159265358979323846;
/// Mass of a slide over that of the lightest body that the line pulls at: far from both, what it
/// takes to speed it up and what rounding leaves.
constexpr double kSlideMass = 1e-6;

[[noreturn]] void refuse(const RouteDef& def, const std::string& why) {
    throw DefError("route" + (def.name.empty() ? std::string() : " '" + def.name + "'") + ": " +
                   why);
}

/// An end or a place, as the line lies.
struct Corner {
    BodyId body{}, slide{};
    Vec3 point = Vec3::Zero();       ///< In the body's frame.
    Vec3 axis = Vec3::UnitY();       ///< In the body's frame.
    double radius = 0.0;             ///< Signed.
    double out = 0.0;                ///< Length that comes to the part behind per unit of slide.
    Vec3 centre = Vec3::Zero(), normal = Vec3::UnitY();  ///< World frame.
};

void check_place(const World& world, const RouteDef& def, std::size_t i) {
    const RoutePlace& p = def.places[i];
    const std::string where = "places/" + std::to_string(i) + ": ";
    if (!world.alive(p.body)) refuse(def, where + "its body is not there");
    const BodyKind kind = world.body_def(p.body).kind;
    if (kind == BodyKind::scalar) refuse(def, where + "a scalar body has no place in space");
    if (kind == BodyKind::lump && (p.radius != 0.0 || !p.point.isZero(0.0)))
        refuse(def, where + "a lump is a point: no wheel and no point on it");
    if (!(std::abs(p.radius) <= 1e3)) refuse(def, where + "radius: give -1000 to 1000 m");
    if (!(p.efficiency > 0.0 && p.efficiency <= 1.0))
        refuse(def, where + "efficiency = " + wire::number(p.efficiency) + "; give (0, 1]");
    if (!(p.friction >= 0.0 && p.friction <= 10.0))
        refuse(def, where + "friction = " + wire::number(p.friction) + "; give 0 to 10");
    if (!(p.inertia >= 0.0 && p.inertia <= 1e12))
        refuse(def, where + "inertia = " + wire::number(p.inertia) + " kg m^2; give 0 to 1e12");
    if (p.inertia > 0.0 && p.radius == 0.0)
        refuse(def, where + "inertia: what turns has a radius");
    if (p.turns < 0 || p.turns > kMostTurns) refuse(def, where + "turns: give 0 to 100");
    if (p.turns > 0 && p.radius == 0.0) refuse(def, where + "turns: an eye has none; give a radius");
    if (p.radius != 0.0 && !(p.axis.norm() > 1e-9 && p.axis.allFinite()))
        refuse(def, where + "axis: give a direction");
    if (!p.point.allFinite()) refuse(def, where + "point: give numbers");
    if (!std::isnan(p.angle) && !(p.angle >= 0.0 && p.angle <= 1e3))
        refuse(def, where + "angle = " + wire::number(p.angle) + " rad; give 0 to 1000");
}

void check(const World& world, const RouteDef& def) {
    if (!(def.EA > 0.0 && def.EA <= 1e15)) refuse(def, "EA: give its axial stiffness [N]");
    if (def.places.empty() || def.places.size() > kMostPlaces)
        refuse(def, "places: give 1 to 256 that it runs over");
    for (const RouteEnd* e : {&def.first, &def.last}) {
        const std::string where = e == &def.first ? "first: " : "last: ";
        if (!world.alive(e->body)) refuse(def, where + "its body is not there");
        if (world.body_def(e->body).kind == BodyKind::scalar)
            refuse(def, where + "a scalar body has no place in space; name it as the drum");
        if (e->drum.valid() &&
            (!world.alive(e->drum) || world.body_def(e->drum).kind != BodyKind::scalar))
            refuse(def, where + "its drum must be a scalar body");
        if (e->drum.valid() && !(std::abs(e->radius) > 0.0 && std::abs(e->radius) <= 1e3))
            refuse(def, where + "radius: give what its drum pays out per unit [m]");
    }
    for (std::size_t i = 0; i < def.places.size(); ++i) check_place(world, def, i);
    if (!std::isnan(def.length) && !(def.length > 0.0)) refuse(def, "length: give more than 0 m");
    if (!(def.tension >= 0.0) || !std::isfinite(def.tension)) refuse(def, "tension: give 0 N or more");
}

/// The straight part between two corners: its ends, and its direction.
struct Straight {
    Vec3 from, to, along;
    double length;
};

/// As model/kinds/routes.h has it.
Straight straight_between(const RouteDef& def, const Corner& a, const Corner& b) {
    const Vec3 d = b.centre - a.centre;
    Straight s{a.centre, b.centre, Vec3::UnitX(), 0.0};
    if (a.radius != 0.0 || b.radius != 0.0) {
        const Vec3 n = a.radius != 0.0 ? a.normal : b.normal;
        const double turn = a.radius != 0.0 && a.normal.dot(b.normal) < 0.0 ? -1.0 : 1.0;
        const double r1 = b.radius * (a.radius != 0.0 ? turn : 1.0), apart = r1 - a.radius;
        const Vec3 flat = d - d.dot(n) * n;
        const double size = flat.norm();
        if (!(size > std::abs(apart) * (1.0 + 1e-9)))
            refuse(def, "two of its wheels, or a wheel and an end, are closer than their radii");
        const double c = std::sqrt(size * size - apart * apart);
        const Vec3 u = (c * flat - apart * n.cross(flat)) / (size * size);
        s.from += a.radius * u.cross(n);
        s.to += r1 * u.cross(n);
    }
    s.length = (s.to - s.from).norm();
    if (!(s.length > 1e-6)) refuse(def, "two of its places, or a place and an end, coincide");
    s.along = (s.to - s.from) / s.length;
    return s;
}

/// Angle by which the line turns at a corner [rad].
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

/// Frame whose z is the wheel's axis and whose x points to where the line touches it.
Quat frame_at(const World& world, const Corner& c, const Vec3& touches) {
    const Quat q = world.pose(c.body).orientation;
    const Vec3 z = q.conjugate() * c.normal;
    Vec3 x = q.conjugate() * (touches - c.centre);
    x -= x.dot(z) * z;
    x.normalize();
    Mat3 m;
    m.col(0) = x;
    m.col(1) = z.cross(x);
    m.col(2) = z;
    return Quat(m);
}

double lightest(const World& world, const std::vector<Corner>& corners) {
    double least = 1e30;
    for (const Corner& c : corners) {
        const BodyDef& b = world.body_def(c.body);
        if (b.kind == BodyKind::lump || b.kind == BodyKind::rigid) least = std::min(least, b.mass);
    }
    return least < 1e30 ? least : 1.0;
}

/// Builds a route, and takes back what it made where something is refused.
class Builder {
  public:
    Builder(World& world, const RouteDef& def) : world_(world), def_(def) {}
    Route build() {
        try {
            place_corners();
            lay_out();
            add_parts();
            add_frictions();
        } catch (...) {
            for (const BodyId id : out_.slides)
                if (world_.alive(id)) world_.remove_body(id);
            for (const InteractionId id : out_.parts)
                if (world_.alive(id)) world_.remove_interaction(id);
            throw;
        }
        return std::move(out_);
    }

  private:
    std::string part_name(const char* what, std::size_t i) const {
        return def_.name.empty() ? std::string() : def_.name + "/" + what + std::to_string(i + 1);
    }
    void place_corners();
    void lay_out();
    void add_parts();
    void add_frictions();

    World& world_;
    const RouteDef& def_;
    Route out_;
    std::vector<Corner> corners_;
    std::vector<Straight> straight_;
    std::vector<double> arc_;  ///< What lies on each place [m].
};

void Builder::place_corners() {
    const auto end = [&](const RouteEnd& e) {
        Corner c;
        c.body = e.body;
        c.point = e.point;
        c.slide = e.drum;
        c.out = e.radius;
        corners_.push_back(c);
    };
    end(def_.first);
    for (const RoutePlace& p : def_.places) {
        Corner c;
        c.body = p.body;
        c.point = p.point;
        c.axis = p.axis.norm() > 0.0 ? Vec3(p.axis.normalized()) : Vec3(Vec3::UnitY());
        c.radius = p.radius;
        c.out = 1.0;
        corners_.push_back(c);
    }
    end(def_.last);
    for (Corner& c : corners_) {
        const Pose pose = world_.pose(c.body);
        c.centre = world_.world_point(c.body, c.point);
        c.normal = pose.orientation * c.axis;
    }
    const double least = kSlideMass * lightest(world_, corners_);
    for (std::size_t i = 0; i < def_.places.size(); ++i) {
        const RoutePlace& p = def_.places[i];
        const double turning = p.inertia > 0.0 ? p.inertia / (p.radius * p.radius) : 0.0;
        corners_[i + 1].slide = world_.add_body({.name = part_name("slide", i),
                                                 .kind = BodyKind::scalar,
                                                 .mass = std::max(turning, least),
                                                 .gravity = false});
        out_.slides.push_back(corners_[i + 1].slide);
    }
}

void Builder::lay_out() {
    for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
        straight_.push_back(straight_between(def_, corners_[i], corners_[i + 1]));
    for (std::size_t i = 0; i < def_.places.size(); ++i) {
        const RoutePlace& p = def_.places[i];
        const double angle =
            turned(corners_[i + 1], p, straight_[i].along, straight_[i + 1].along);
        arc_.push_back(angle * std::abs(p.radius));
        out_.angles.push_back(std::isnan(p.angle) ? angle : p.angle);
    }
}

void Builder::add_parts() {
    // Half of what lies on a place belongs to the part before it, half to the one behind.
    double path = 0.0;
    std::vector<double> lies(straight_.size());
    for (std::size_t i = 0; i < straight_.size(); ++i) {
        lies[i] = straight_[i].length + (i > 0 ? 0.5 * arc_[i - 1] : 0.0) +
                  (i + 1 < straight_.size() ? 0.5 * arc_[i] : 0.0);
        path += lies[i];
    }
    const double length = std::isnan(def_.length) ? path / (1.0 + def_.tension / def_.EA)
                                                  : def_.length;
    for (std::size_t i = 0; i < straight_.size(); ++i) {
        const Corner &a = corners_[i], &b = corners_[i + 1];
        const double own = lies[i] * length / path;  // without tension
        InteractionDef d;
        d.name = part_name("part", i);
        d.damping_time[0] = def_.damping_time;
        if (a.body == b.body && a.slide.valid() && b.slide.valid()) {
            d.kind = InteractionKind::BodySpan;
            d.body[0] = a.slide;
            d.body[1] = b.slide;
            d.set("path", lies[i]).set("length", own).set("EA", def_.EA);
            d.set("slide_0", a.out).set("slide_1", i + 2 < corners_.size() ? -1.0 : b.out);
            out_.parts.push_back(world_.add_interaction(d));
            continue;
        }
        if (a.body == b.body) refuse(def_, "an end stands on the same body as the next place");
        const bool both = a.slide.valid() && b.slide.valid();
        d.kind = both ? InteractionKind::Span : InteractionKind::EndSpan;
        d.body[0] = a.body;
        d.body[1] = b.body;
        d.point[0] = a.point;
        d.point[1] = b.point;
        if (a.radius != 0.0) d.frame[0] = frame_at(world_, a, straight_[i].from);
        if (b.radius != 0.0) d.frame[1] = frame_at(world_, b, straight_[i].to);
        const double to_b = i + 2 < corners_.size() ? -1.0 : b.out;
        d.body[2] = a.slide.valid() ? a.slide : b.slide;
        d.set("slide_0", a.slide.valid() ? a.out : to_b);
        if (both) {
            d.body[3] = b.slide;
            d.set("slide_1", to_b);
        }
        d.set("wheel_0", a.radius).set("wheel_1", b.radius);
        // What lies on the places is part of the path only by how it changes.
        d.set("length", own - (lies[i] - straight_[i].length));
        d.set("EA", def_.EA).set("breaking_load", def_.breaking_load);
        d.compliance[0] = own / def_.EA;
        out_.parts.push_back(world_.add_interaction(d));
    }
}

void Builder::add_frictions() {
    for (std::size_t i = 0; i < def_.places.size(); ++i) {
        const RoutePlace& p = def_.places[i];
        const double rubs = p.friction * out_.angles[i] - std::log(p.efficiency);
        out_.frictions.emplace_back();
        if (rubs == 0.0) continue;
        InteractionDef f;
        f.kind = InteractionKind::ScalarFriction;
        f.name = part_name("friction", i);
        f.body[0] = out_.slides[i];
        // Of a slide without mass any spring holds; this one is as stiff as the line.
        f.load[0] = {out_.parts[i], std::tanh(0.5 * rubs)};
        f.load[1] = {out_.parts[i + 1], std::tanh(0.5 * rubs)};
        out_.frictions.back() = world_.add_interaction(f);
    }
}

}  // namespace

Route define(World& world, const RouteDef& def) {
    check(world, def);
    return Builder(world, def).build();
}

}  // namespace hawser
