// SPDX-License-Identifier: Apache-2.0
/// Define cranes in a world: add their parts, find them by name, and add a system that drives them.
#include <hawser/crane.h>
#include <hawser/world.h>

#include "crane/builder.h"
#include "crane/common.h"
#include "crane/crane_system.h"

#include <cmath>
#include <memory>
#include <utility>

namespace hawser {
namespace crane {
namespace {

class WorldSite final : public CraneSite {
  public:
    explicit WorldSite(World& world) : world_(world) {}
    ~WorldSite() = default;
    BodyId add(const BodyDef& def) override {
        added_bodies_.push_back(world_.add_body(def));
        return added_bodies_.back();
    }
    InteractionId add(const InteractionDef& def) override { return world_.add_interaction(def); }
    [[nodiscard]] CraneBody find(BodyId id) const override {
        if (!world_.alive(id)) throw DefError("crane: a body that it names is not there");
        const BodyDef& def = world_.body_def(id);
        return {world_.pose(id), world_.velocity(id), def.kind, def.mass};
    }
    [[nodiscard]] Vec3 gravity() const override { return world_.settings().gravity; }
    /// Remove the added bodies, and with them all interactions on them.
    void remove_added_bodies() {
        for (auto id = added_bodies_.rbegin(); id != added_bodies_.rend(); ++id)
            if (world_.alive(*id)) (void)world_.remove_body(*id);
    }

  private:
    World& world_;
    std::vector<BodyId> added_bodies_;
};

/// Search of parts by name, and creation of their drives.
class Finder {
  public:
    Finder(World& world, const Common& common) : world_(world), common_(common) {}

    [[nodiscard]] BodyId body(const char* what) const {
        const BodyId id = world_.find_body(part(common_.name, what));
        if (!id.valid()) throw_def_error(common_.name, what, "this body of it is not there");
        return id;
    }
    [[nodiscard]] InteractionId interaction(const std::string& what) const {
        const InteractionId id = world_.find_interaction(common_.name + "/" + what);
        if (!id.valid()) throw_def_error(common_.name, what, "this part of it is not there");
        return id;
    }
    [[nodiscard]] Vec3 point_on_link(const CraneLink& link, double at) const {
        return {at - (std::isnan(link.centre) ? 0.5 * link.length : link.centre), 0.0, 0.0};
    }
    /// Return the drive of a motion such as "slew" or "hoist".
    Drive drive(const std::string& what, double max_speed, double ratio, double low, double high) {
        Drive d{.exists = true, .max_speed = max_speed, .ratio = ratio, .low = low, .high = high};
        d.motor = interaction(what + "/motor");
        d.speed = input(what + "/motor", d.motor, "speed");
        return d;
    }
    void add_brake(Drive& d, const std::string& what, double brake, double friction,
                   const char* param) {
        d.brake = brake;
        d.friction = friction;
        d.friction_id = interaction(what + "/friction");
        d.force_low = input(what + "/motor", d.motor, "force_min");
        d.force_high = input(what + "/motor", d.motor, "force_max");
        d.bound = input(what + "/friction", d.friction_id, param);
    }
    Drive tackle(const std::string& what, const CraneTackle& t) {
        const double torque_max = t.pull * t.drum_radius;
        Drive d = drive(what, t.speed, -t.falls / t.drum_radius, -torque_max, torque_max);
        add_brake(d, what, t.brake * t.drum_radius, 0.0, "force");
        d.scalar = body((what + "/drum").c_str());
        return d;
    }
    Drive cylinder(const std::string& what, const CraneCylinder& c) {
        Drive d = drive(what, c.speed, 1.0, -c.pull, c.push);
        d.scalar = body((what + "/stroke").c_str());
        d.start = world_.interaction_def(interaction(what + "/cylinder")).get("length");
        d.shortest_length = c.min_length;
        d.longest_length = c.max_length;
        return d;
    }
    [[nodiscard]] std::vector<InteractionId> falls(bool knuckle) const {
        std::vector<InteractionId> out;
        for (int k = 1; k <= common_.hoist.falls; ++k)
            out.push_back(interaction("hoist/part" + std::to_string(part_of_fall(k, knuckle))));
        return out;
    }

  private:
    InputId input(const std::string& what, InteractionId of, const char* param) {
        return world_.add_input(
            {.name = common_.name + "/" + what + "/" + param, .interaction = of, .param = param});
    }
    World& world_;
    const Common& common_;
};

void check_bodies(World& world, const Common& c) {
    if (world.find_system(c.name) != nullptr)
        throw_def_error(c.name, "name", "the name is in use; names must be unique");
    check_load_bodies(world, {"crane", c.name, c.loads, c.take});
    const int hang =
        c.take > 0 ? static_cast<int>(c.loads[static_cast<std::size_t>(c.take - 1)].eyes.size())
                   : 0;
    for (int i = hang + 1; i <= 8; ++i)
        if (world.find_interaction(c.name + "/sling" + std::to_string(i)).valid())
            throw_def_error(c.name, "name", "an interaction has the name of one of its slings");
}

/// Find the bodies and interactions that both kinds of cranes have.
CraneParts common_parts(Finder& find, const Common& c, const char* tip) {
    CraneParts p;
    p.on = c.mount.on;
    p.mount = c.mount.point;
    p.orientation = c.mount.orientation;
    p.column = find.body("column");
    p.boom = find.body("boom");
    p.tip = find.body(tip);
    p.hook = find.body("hook");
    p.boom_pin = find.point_on_link(c.boom, 0.0);
    Drive slew = find.drive("slew", c.slew.speed, 1.0, -c.slew.torque, c.slew.torque);
    find.add_brake(slew, "slew", c.slew.brake, c.slew.friction, "torque");
    p.drives[kSlew] = slew;
    p.drives[kHoist] = find.tackle("hoist", c.hoist);
    return p;
}

void start(World& world, const Common& c, CraneParts parts) {
    world.add_system(std::make_unique<CraneSystem>(
        CraneTask{c.name, c.hook, c.rating, c.loads, c.take, c.ramp}, std::move(parts)));
}

template <class Def>
CraneIds define_any(World& world, const Def& def, bool knuckle) {
    WorldSite site(world);
    try {
        build_crane(site, def);
        start_crane(world, def);
    } catch (...) {
        site.remove_added_bodies();
        throw;
    }
    const Common c = common_fields(def);
    const Finder find(world, c);
    CraneIds ids{.column = find.body("column"), .boom = find.body("boom")};
    (knuckle ? ids.jib : ids.bridle) = find.body(knuckle ? "jib" : "bridle");
    ids.hook = find.body("hook");
    ids.falls = find.falls(knuckle);
    return ids;
}

}  // namespace
}  // namespace crane

void start_crane(World& world, const KnuckleCraneDef& def) {
    using namespace crane;
    const Common c = common_fields(def);
    check_bodies(world, c);
    Finder find(world, c);
    CraneParts p = common_parts(find, c, "jib");
    p.head = find.point_on_link(def.jib, def.jib.length);
    p.tip_pin = find.point_on_link(def.jib, 0.0);
    p.luff_sign = boom_linkage(def).lever > 0.0 ? 1.0 : -1.0;
    p.knuckle_sign = jib_linkage(def).lever > 0.0 ? 1.0 : -1.0;
    p.falls = find.falls(true);
    p.drives[kLuff] = find.cylinder("luff", def.boom_cylinder);
    p.drives[kKnuckle] = find.cylinder("knuckle", def.jib_cylinder);
    start(world, c, std::move(p));
}

void start_crane(World& world, const LatticeCraneDef& def) {
    using namespace crane;
    const Common c = common_fields(def);
    check_bodies(world, c);
    Finder find(world, c);
    CraneParts p = common_parts(find, c, "boom");
    p.head = find.point_on_link(def.boom, def.boom.length);
    p.tip_pin = find.point_on_link(def.boom, 0.0);
    p.falls = find.falls(false);
    p.drives[kLuff] = find.tackle("luffing", def.luffing);
    start(world, c, std::move(p));
}

CraneIds define(World& world, const KnuckleCraneDef& def) {
    return crane::define_any(world, def, true);
}
CraneIds define(World& world, const LatticeCraneDef& def) {
    return crane::define_any(world, def, false);
}

}  // namespace hawser
