// SPDX-License-Identifier: Apache-2.0
/// Check definitions of cranes for errors that do not depend on the world; check loads.
#include <hawser/world.h>

#include "crane/common.h"
#include "crane/linkage.h"

#include <cmath>

namespace hawser::crane {
namespace {

constexpr int kMaxFalls = 64;
constexpr double kMaxLength = 1e4, kMaxMass = 1e12, kMaxForce = 1e15;

/// Checks of the fields of one part.
class Fields {
  public:
    Fields(const std::string& name, std::string part, const char* kind = "crane")
        : name_(name), part_(std::move(part)), kind_(kind) {}

    /// Check that a value is above 0.
    const Fields& positive(const char* field, double value, double most) const {
        if (!(value > 0.0 && value <= most))
            fail(field, number(value) + "; give a number above 0 and at most " + number(most));
        return *this;
    }
    const Fields& from_zero(const char* field, double value, double most) const {
        if (!(value >= 0.0 && value <= most))
            fail(field, number(value) + "; give a number from 0 to " + number(most));
        return *this;
    }
    const Fields& between(const char* field, double value, double least, double most) const {
        if (!(value >= least && value <= most))
            fail(field,
                 number(value) + "; give a number from " + number(least) + " to " + number(most));
        return *this;
    }
    const Fields& point(const char* field, const Vec3& p, bool in_plane) const {
        if (!p.allFinite() || p.norm() > kMaxLength) fail(field, "give a point within 10 km");
        if (in_plane && p.y() != 0.0)
            fail(field, "y = " + number(p.y()) + " m; booms and their pins lie in the plane y = 0");
        return *this;
    }
    [[noreturn]] void fail(const char* field, const std::string& why) const {
        throw_def_error(name_,
                        part_.empty()    ? field
                        : *field == '\0' ? part_
                                         : part_ + "/" + field,
                        why, kind_);
    }

  private:
    const std::string& name_;
    std::string part_;
    const char* kind_;
};

void check_link(const std::string& name, const char* part, const CraneLink& link) {
    const Fields f(name, part);
    f.positive("length", link.length, kMaxLength)
        .positive("mass", link.mass, kMaxMass)
        .positive("width", link.width, kMaxLength)
        .positive("height", link.height, kMaxLength);
    if (!std::isnan(link.centre)) f.from_zero("centre", link.centre, link.length);
}

void check_tackle(const std::string& name, const char* part, const CraneTackle& t, bool hoist) {
    const Fields f(name, part);
    if (t.falls < 1 || t.falls > kMaxFalls)
        f.fail("falls", std::to_string(t.falls) + "; give 1 to 64");
    f.positive("EA", t.EA, kMaxForce);
    if (!(t.efficiency > 0.0 && t.efficiency <= 1.0))
        f.fail("efficiency", number(t.efficiency) + "; give a number in (0, 1]");
    f.positive("drum_radius", t.drum_radius, 1e3)
        .positive("drum_inertia", t.drum_inertia, kMaxMass)
        .positive("pull", t.pull, kMaxForce)
        .positive("brake", t.brake, kMaxForce)
        .positive("speed", t.speed, 100.0)
        .positive("breaking_load", t.breaking_load, 1e30)
        .point("drum", t.drum, false);
    if (hoist)
        f.positive("sheave_radius", t.sheave_radius, 1e3)
            .from_zero("sheave_inertia", t.sheave_inertia, kMaxMass);
}

void check_hook(const Common& c) {
    const Fields f(c.name, "hook");
    f.positive("mass", c.hook.mass, kMaxMass)
        .positive("height", c.hook.height, kMaxLength)
        .positive("hang", c.hook.hang, kMaxLength);
    const double least = 2.0 * c.hoist.sheave_radius;
    if (c.hook.hang <= least)
        f.fail("hang", number(c.hook.hang) + " m; the sheaves of hook and head touch below " +
                           number(least) + " m");
    f.from_zero("least_hang", c.hook.least_hang, c.hook.hang)
        .from_zero("angular_damping", c.hook.angular_damping, kMaxForce);
    for (const double half : c.hook.half_size) f.positive("half_size", half, kMaxLength);
}

void check_rating(const Common& c) {
    const Fields f(c.name, "rating");
    const CraneRating& r = c.rating;
    for (std::size_t i = 0; i < r.curve.size(); ++i) {
        const CraneRatedLoad& p = r.curve[i];
        const std::string at = "curve/" + std::to_string(i);
        if (!(p.radius >= 0.0 && p.radius <= kMaxLength && p.mass >= 0.0 && p.mass <= kMaxMass))
            f.fail(at.c_str(), "give a radius [m] and a mass [kg] from 0 on");
        if (i == 0) continue;
        const CraneRatedLoad& before = r.curve[i - 1];
        if (!(p.radius > before.radius))
            f.fail(at.c_str(), "radius " + number(p.radius) + " m after " + number(before.radius) +
                                   " m; radii have to grow");
        if (p.mass > before.mass)
            f.fail(at.c_str(), "rated load " + number(p.mass) + " kg after " + number(before.mass) +
                                   " kg; it may not grow with the radius");
    }
    f.positive("warning", r.warning, 10.0).positive("overload", r.overload, 10.0);
    if (r.warning > r.overload) f.fail("warning", "it is above overload");
    f.from_zero("hold", r.hold, 1e3).from_zero("filter", r.filter, 1e3);
    if (r.cut_out && r.curve.empty()) f.fail("cut_out", "it needs a curve of rated loads");
}

void check_common(const Common& c) {
    if (c.name.empty()) throw DefError("a crane needs a name");
    Fields(c.name, "mount").point("point", c.mount.point, false);
    if (!(std::abs(c.mount.orientation.norm() - 1.0) < 1e-6))
        throw_def_error(c.name, "mount/orientation", "give a quaternion of length 1");
    Fields(c.name, "slew")
        .positive("torque", c.slew.torque, kMaxForce)
        .positive("brake", c.slew.brake, kMaxForce)
        .from_zero("friction", c.slew.friction, kMaxForce)
        .positive("speed", c.slew.speed, 10.0)
        .between("angle", c.slew.angle, -kPi, kPi);
    const Fields column(c.name, "column");
    column.positive("mass", c.column.mass, kMaxMass).point("centre", c.column.centre, false);
    for (const double half : c.column.half_size) column.positive("half_size", half, kMaxLength);
    Fields(c.name, "").point("boom_foot", c.boom_foot, true).between("ramp", c.ramp, 0.0, 1e3);
    check_link(c.name, "boom", c.boom);
    Fields(c.name, "").between("boom_angle", c.boom_angle, -0.5 * kPi, 0.5 * kPi);
    check_tackle(c.name, "hoist", c.hoist, true);
    check_hook(c);
    check_rating(c);
    check_loads({"crane", c.name, c.loads, c.take});
}

void check_cylinder(const std::string& name, const char* part, const CraneCylinder& cylinder,
                    const Linkage& linkage) {
    const Fields f(name, part);
    f.point("foot", cylinder.foot, true)
        .point("head", cylinder.head, true)
        .positive("min_length", cylinder.min_length, kMaxLength)
        .positive("max_length", cylinder.max_length, kMaxLength)
        .positive("push", cylinder.push, kMaxForce)
        .positive("pull", cylinder.pull, kMaxForce)
        .positive("speed", cylinder.speed, 100.0)
        .positive("stiffness", cylinder.stiffness, kMaxForce)
        .positive("mass", cylinder.mass, kMaxMass);
    const double now = linkage.length;
    if (!(std::abs(linkage.lever) > 1e-3 * linkage.longest()))
        f.fail("head", "its pins and the hinge are on one line, so that it has no lever arm");
    if (!(cylinder.min_length < now && now < cylinder.max_length))
        f.fail(now <= cylinder.min_length ? "min_length" : "max_length",
               "at the start angle its pins are " + number(now) +
                   " m apart, which is not between " + number(cylinder.min_length) + " and " +
                   number(cylinder.max_length) + " m");
    if (cylinder.min_length < linkage.shortest())
        f.fail("min_length", number(cylinder.min_length) + " m; its pins cannot come closer than " +
                                 number(linkage.shortest()) + " m");
    if (cylinder.max_length > linkage.longest())
        f.fail("max_length", number(cylinder.max_length) +
                                 " m; its pins cannot be farther apart than " +
                                 number(linkage.longest()) + " m");
}

}  // namespace

void check_loads(const HookLoads& takes) {
    for (std::size_t i = 0; i < takes.loads.size(); ++i) {
        const CraneLoad& load = takes.loads[i];
        const Fields f(takes.name, "loads/" + std::to_string(i), takes.kind);
        if (load.eyes.empty() || load.eyes.size() > kMaxEyes) f.fail("eyes", "give 1 to 8");
        for (const Vec3& eye : load.eyes) f.point("eyes", eye, false);
        f.positive("sling_length", load.sling_length, kMaxLength)
            .positive("sling_EA", load.sling_EA, kMaxForce)
            .from_zero("reach", load.reach, kMaxLength)
            .positive("breaking_load", load.breaking_load, 1e30);
    }
    if (takes.take < 0 || takes.take > static_cast<int>(takes.loads.size()))
        throw_def_error(takes.name, "take",
                        "there is no load " + std::to_string(takes.take) + "; the hook knows " +
                            std::to_string(takes.loads.size()) + ", 0 takes none",
                        takes.kind);
}

void check_load_bodies(const World& world, const HookLoads& takes) {
    for (std::size_t i = 0; i < takes.loads.size(); ++i) {
        const CraneLoad& load = takes.loads[i];
        const Fields f(takes.name, "loads/" + std::to_string(i), takes.kind);
        if (!world.alive(load.body)) f.fail("body", "there is no such body");
        const BodyKind kind = world.body_def(load.body).kind;
        if (kind != BodyKind::rigid && kind != BodyKind::lump)
            f.fail("body", "a load is a rigid body or a lump");
        for (const Vec3& eye : load.eyes)
            if (kind == BodyKind::lump && !eye.isZero(0.0))
                f.fail("eyes", "a lump is a point: its one eye is [0, 0, 0]");
    }
}

void check(const KnuckleCraneDef& d) {
    const Common c = common_fields(d);
    check_common(c);
    check_link(d.name, "jib", d.jib);
    const Fields f(d.name, "");
    f.between("jib_angle", d.jib_angle, -kPi, kPi);
    check_cylinder(d.name, "boom_cylinder", d.boom_cylinder, boom_linkage(d));
    check_cylinder(d.name, "jib_cylinder", d.jib_cylinder, jib_linkage(d));
    // The line comes to the sheave at the knuckle from above and must bend down there.
    const double r = d.hoist.sheave_radius, along = d.boom.length - d.hoist.drum.x();
    if (!(along > 2.0 * r))
        f.fail("hoist/drum",
               "x = " + number(d.hoist.drum.x()) + " m; it must be on the boom, before its head");
    const double comes = std::atan2(r - d.hoist.drum.z(), along);
    const double most = jib_linkage(d).angle_range(d.jib_cylinder).second;
    if (!(most < comes))
        f.fail("jib_angle", "the jib can rise to " + number(most) +
                                " rad against the boom, where the line lifts off the sheave at "
                                "the knuckle; give a lesser jib_cylinder/max_length or a lower "
                                "drum");
    if (!(d.boom_angle + d.jib_angle > -0.45 * kPi))
        f.fail("jib_angle", "the jib points straight down, so that the line leaves its sheave");
}

void check(const LatticeCraneDef& d) {
    check_common(common_fields(d));
    const Fields f(d.name, "");
    f.between("least_angle", d.least_angle, -1.5, 1.5)
        .between("most_angle", d.most_angle, -1.5, 1.56);
    if (!(d.least_angle < d.boom_angle && d.boom_angle < d.most_angle))
        f.fail("boom_angle",
               number(d.boom_angle) + " rad is not between least_angle and most_angle");
    f.point("gantry", d.gantry, true)
        .positive("bridle_mass", d.bridle_mass, kMaxMass)
        .positive("pendant_length", d.pendant_length, kMaxLength)
        .positive("pendant_EA", d.pendant_EA, kMaxForce)
        .positive("pendant_breaking_load", d.pendant_breaking_load, 1e30);
    check_tackle(d.name, "luffing", d.luffing, false);
    const double way = pendant_top_to_gantry(d);
    if (!(d.pendant_length < way - 0.5))
        f.fail("pendant_length", number(d.pendant_length) +
                                     " m, but from boom head to gantry there are " + number(way) +
                                     " m: nothing is left for the luffing tackle");
    if (!(d.gantry.x() < d.boom_foot.x()))
        f.fail("gantry", "it must be behind the foot of the boom, to hold it back");
}

}  // namespace hawser::crane
