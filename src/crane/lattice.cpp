// SPDX-License-Identifier: Apache-2.0
/// Build the parts of a lattice crane: pendants and a bridle, which the luffing tackle pulls to the
/// gantry.
///
/// The bridle is a point mass and its tackle runs over eyes. The bridle lies on the line from the
/// pendants to the gantry for any position of the boom. Sheaves would add only their efficiency,
/// which the eyes have.
#include "crane/builder.h"

namespace hawser {
namespace crane {
namespace {

/// Return the line tension of an empty hook [N].
double empty_line(const Builder& b, const LatticeCraneDef& def) {
    return def.hook.mass * b.gravity().norm() / def.hoist.falls;
}

/// Return the force of both pendants at the start, from moments about the foot of the boom [N].
double start_pull(const Builder& b, const LatticeCraneDef& def, const Link& column,
                  const Link& boom, const Vec3& along) {
    const Vec3 head = boom.world({def.boom.length, 0.0, 0.0});
    const double lead = empty_line(b, def);
    double moment =
        b.raising_moment(boom.pin, boom.world(boom.centre), def.boom.mass * b.gravity()) +
        b.raising_moment(boom.pin, head, def.hook.mass * b.gravity());
    moment +=
        b.raising_moment(boom.pin, head, lead * (column.world(def.hoist.drum) - head).normalized());
    const Vec3 held = boom.world({def.boom.length, 0.0, 0.5 * def.boom.height});
    const double lever = b.raising_moment(boom.pin, held, along);
    if (!(lever > 1e-3 * def.boom.length))
        throw_def_error(def.name, "gantry", "the pendants do not raise the boom; put it higher");
    return std::max(0.0, -moment / lever);
}

void add_pendants(Builder& b, const LatticeCraneDef& def, const Link& boom, BodyId bridle,
                  const Vec3& at, double pull) {
    for (int k = 0; k < 2; ++k) {
        const Vec3 eye{def.boom.length, (k == 0 ? 0.5 : -0.5) * def.boom.width,
                       0.5 * def.boom.height};
        InteractionDef pendant;
        pendant.name = b.part_name(k == 0 ? "pendant1" : "pendant2");
        pendant.kind = InteractionKind::Stretch;
        pendant.body[0] = boom.id;
        pendant.body[1] = bridle;
        pendant.point[0] = boom.local(eye);
        const double way = (at - boom.world(eye)).norm();
        pendant.set("length", way / (1.0 + 0.5 * pull / def.pendant_EA));
        pendant.set("EA", def.pendant_EA).set("breaking_load", def.pendant_breaking_load);
        b.add(pendant);
    }
}

void add_luffing(Builder& b, const LatticeCraneDef& def, const Link& column, BodyId bridle,
                 double pull) {
    const CraneTackle& t = def.luffing;
    RouteDef route;
    route.name = b.part_name("luffing");
    route.EA = t.EA;
    route.breaking_load = t.breaking_load;
    route.damping_time = t.damping_time;
    route.tension = pull / t.falls;
    route.first = {column.id, column.local(t.drum), b.add_drum("luffing", t), t.drum_radius};
    const Vec3 gantry = column.local(def.gantry);
    for (int i = 0; i < t.falls; ++i) {
        RoutePlace p;
        p.efficiency = t.efficiency;
        p.body = i % 2 == 0 ? column.id : bridle;
        if (i % 2 == 0) p.point = gantry;
        route.places.push_back(p);
    }
    if (t.falls % 2 == 0)
        route.last = {column.id, gantry};
    else
        route.last = {bridle, Vec3::Zero()};
    b.add_route(route);
}

}  // namespace
}  // namespace crane

void build_crane(CraneSite& site, const LatticeCraneDef& def) {
    using crane::Builder;
    using crane::Link;
    crane::check(def);
    const crane::Common c = crane::common_fields(def);
    Builder b(site, c);
    const Link column = b.add_column();
    const Link boom = b.add_link("boom", def.boom, column.world(def.boom_foot),
                                 column.turn * crane::rotation_raising(def.boom_angle));
    crane::HingeParts luff;
    luff.range = std::pair(def.least_angle, def.most_angle);
    b.add_hinge("luff", column, boom, boom.pin, crane::hinge_turn(), luff);
    const Vec3 from = boom.world({def.boom.length, 0.0, 0.5 * def.boom.height});
    const Vec3 along = (column.world(def.gantry) - from).normalized();
    const double pull = crane::start_pull(b, def, column, boom, along);
    const Vec3 at = from + def.pendant_length * along;
    const BodyId bridle = b.add_lump("bridle", def.bridle_mass, at);
    crane::add_pendants(b, def, boom, bridle, at, pull);
    crane::add_luffing(b, def, column, bridle, pull);
    crane::add_slings(b, c, crane::add_hoist(b, c, column, nullptr, boom, def.boom.length));
}

}  // namespace hawser
