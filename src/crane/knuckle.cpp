// SPDX-License-Identifier: Apache-2.0
/// Build the parts of a knuckle-boom crane.
#include "crane/builder.h"

namespace hawser {

void build_crane(CraneSite& site, const KnuckleCraneDef& def) {
    using crane::Builder;
    using crane::Link;
    crane::check(def);
    const crane::Common c = crane::common_fields(def);
    Builder b(site, c);
    const Link column = b.add_column();
    const Link boom = b.add_link("boom", def.boom, column.world(def.boom_foot),
                                 column.turn * crane::rotation_raising(def.boom_angle));
    const Vec3 knuckle = boom.world({def.boom.length, 0.0, 0.0});
    const Link jib =
        b.add_link("jib", def.jib, knuckle, boom.turn * crane::rotation_raising(def.jib_angle));
    crane::HingeParts luff, fold;
    luff.range = crane::boom_linkage(def).angle_range(def.boom_cylinder);
    fold.range = crane::jib_linkage(def).angle_range(def.jib_cylinder);
    b.add_hinge("luff", column, boom, boom.pin, crane::hinge_turn(), luff);
    b.add_hinge("knuckle", boom, jib, knuckle, crane::hinge_turn(), fold);

    // Force of the cylinders at the start: T lever + moment of the weights = 0.
    const Vec3 tip = jib.world({def.jib.length, 0.0, 0.0});
    const auto weight = [&](const Vec3& pin, const Link& link, double mass) {
        return b.raising_moment(pin, link.world(link.centre), mass * b.gravity());
    };
    const double on_jib = weight(knuckle, jib, def.jib.mass) +
                          b.raising_moment(knuckle, tip, def.hook.mass * b.gravity());
    const double on_boom = weight(boom.pin, boom, def.boom.mass) +
                           weight(boom.pin, jib, def.jib.mass) +
                           b.raising_moment(boom.pin, tip, def.hook.mass * b.gravity());
    // Raising the link lengthens the cylinder by its lever; tension lowers the link.
    const double boom_lever = crane::boom_linkage(def).lever;
    const double jib_lever = crane::jib_linkage(def).lever;
    b.add_cylinder("luff", def.boom_cylinder, column, boom, on_boom / boom_lever);
    b.add_cylinder("knuckle", def.jib_cylinder, boom, jib, on_jib / jib_lever);
    crane::add_slings(b, c, crane::add_hoist(b, c, boom, &boom, jib, def.jib.length));
}

}  // namespace hawser
