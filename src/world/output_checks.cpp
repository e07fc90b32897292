// SPDX-License-Identifier: Apache-2.0
/// Checks of outputs, with the remedy.
#include "world/checks.h"
#include "world/nearest.h"
#include "world/outputs.h"

#include <cmath>
#include <string>
#include <vector>

namespace hawser::world {
namespace {

int component_index(const OutputDef& def, const OutputKindInfo& kind, const std::string& where) {
    if (def.component.empty() && kind.components.size() == 1) return 0;
    std::vector<const char*> known;
    for (std::size_t i = 0; i < kind.components.size(); ++i) {
        if (def.component == kind.components[i].name) return static_cast<int>(i);
        known.push_back(kind.components[i].name);
    }
    throw_def_error(
        where, (def.component.empty()
                    ? std::string("a ") + kind.name + " needs a component"
                    : std::string("a ") + kind.name + " has no component '" + def.component + "'") +
                   name_suggestion(def.component, known));
}

void check_body(const std::string& where, const char* field, BodyId body, const Vec3& point,
                const model::Bodies& bodies, int count, bool is_place) {
    if (body.index < 0 || body.index >= count)
        throw_def_error(where, std::string(field) + " does not exist; give the id of a body");
    if (!bodies.slots.names(body)) throw_def_error(where, std::string(field) + " has been removed");
    if (!point.allFinite()) throw_def_error(where, "a point is not finite");
    const int dof = bodies.dof(body.index);
    if (dof == 1 && is_place)
        throw_def_error(where, std::string(field) +
                                   " is a scalar body, which has a coordinate but no position");
    if ((dof == 1 || dof == 3) && !point.isZero(0.0))
        throw_def_error(where,
                        std::string(field) +
                            " has no orientation: leave the point at 0, it is the body itself");
}

/// Check a component of a body: nodes do not rotate, a drum has one coordinate.
void check_body_component(const std::string& where, const OutputDef& def, int component,
                          const model::Bodies& bodies) {
    const int dof = bodies.dof(def.body.index);
    const bool turning = component >= (def.kind == OutputKind::pose ? int{kRoll} : int{kTurning});
    if (dof == 3 && (turning || def.local))
        throw_def_error(where, "a point mass does not rotate; give x, y or z, in the world's axes");
    if (dof == 1 && (component != 0 || def.local))
        throw_def_error(where, "a scalar body has one coordinate; give the component x");
}

const char* unit_by(KindCoordinate coordinate, const char* about, const char* along,
                    const char* open) {
    return coordinate == KindCoordinate::about   ? about
           : coordinate == KindCoordinate::along ? along
                                                 : open;
}

/// Check a coordinate, speed, motor_force, force or drum output.
/// @return its unit.
std::string check_interaction(const std::string& where, const OutputDef& def, int component,
                              const model::Interactions& in, int count) {
    if (def.interaction.index < 0 || def.interaction.index >= count)
        throw_def_error(where, "its interaction does not exist; give the id of one");
    if (!in.slots.names(def.interaction))
        throw_def_error(where, "its interaction has been removed");
    const KindInfo& kind = kind_info(in.def[at(def.interaction.index)].kind);
    const KindCoordinate c = kind.coordinate;
    switch (def.kind) {
        case OutputKind::coordinate:
        case OutputKind::speed:
            if (c == KindCoordinate::none) throw_def_error(where, no_coordinate(kind));
            return def.kind == OutputKind::coordinate ? unit_by(c, "rad", "m", "m or rad")
                                                      : unit_by(c, "rad/s", "m/s", "m/s or rad/s");
        case OutputKind::motor_force:
            if (!kind.is(kMotorKind)) throw_def_error(where, no_motor(kind));
            return unit_by(c, "N m", "N", "N or N m");
        case OutputKind::drum:
            if (!kind.is(kWoundUp))
                throw_def_error(
                    where, std::string("a ") + kind.name +
                               " is wound on no drum; give a winch_stretch, or the pose of the "
                               "drum itself");
            return "m";
        default:
            break;
    }
    if (component >= kind.rows)
        throw_def_error(where, std::string("a ") + kind.name + " has " + std::to_string(kind.rows) +
                                   " rows; give row_0 to row_" + std::to_string(kind.rows - 1));
    const char letter = kind.row_units[component];
    if (letter == 'v') return unit_by(c, "N m", "N", "N or N m");
    return letter == 'r' ? "N m" : "N";
}

void check_line(const std::string& where, const OutputDef& def, const model::Interactions& in,
                const WireList& wires, int count) {
    if (def.wire.index != -1) {
        if (!def.line.empty()) throw_def_error(where, "it has a wire and a line; give one of them");
        if (!wires.slots.names(def.wire))
            throw_def_error(where,
                            "its wire does not exist or has been removed; give the id of one");
        return;
    }
    if (def.line.empty())
        throw_def_error(where, "a tension needs a wire, or a line: give its elements in order");
    for (const InteractionId id : def.line) {
        if (id.index < 0 || id.index >= count)
            throw_def_error(where, "an element of its line does not exist");
        if (!in.slots.names(id)) throw_def_error(where, "an element of its line has been removed");
        const KindInfo& kind = kind_info(in.def[at(id.index)].kind);
        if (!kind.is(kPulls) && !(kind.is(kHoldsBodies) && kind.row_units[0] == 'm'))
            throw_def_error(
                where, std::string("a ") + kind.name +
                           " carries no tension; give stretches, rods, or the joints of links");
    }
}

}  // namespace

int check_output(OutputDef& def, const context::StepContext& ctx, const WireList& wires, int bodies,
                 int interactions) {
    if (def.name.empty()) throw DefError("an output needs a name");
    const std::string where = label("output", def.name);
    if (static_cast<int>(def.kind) >= kOutputKindCount) throw_def_error(where, "unknown kind");
    if (!(def.nominal >= 0.0) || !std::isfinite(def.nominal))
        throw_def_error(where, "nominal = " + number(def.nominal) +
                                   ": give a size above 0, or 0 where none is known");
    const OutputKindInfo& kind = output_kind_info(def.kind);
    const int component = component_index(def, kind, where);
    const OutputComponent& chosen = kind.components[at(component)];
    std::string unit = chosen.unit;
    if (def.local && def.kind != OutputKind::velocity)
        throw_def_error(where, "only a velocity may be local, along the body's own axes");
    switch (kind.target) {
        case OutputTarget::two_bodies:
            check_body(where, "body_b", def.body_b, def.point_b, ctx.model.bodies, bodies, true);
            [[fallthrough]];
        case OutputTarget::body:
            check_body(where, "body", def.body, def.point, ctx.model.bodies, bodies,
                       kind.target == OutputTarget::two_bodies);
            if (kind.target == OutputTarget::body) {
                check_body_component(where, def, component, ctx.model.bodies);
                if (ctx.model.bodies.dof(def.body.index) == 1)
                    unit = def.kind == OutputKind::pose ? "m or rad" : "m/s or rad/s";
            }
            break;
        case OutputTarget::interaction:
            unit = check_interaction(where, def, component, ctx.model.interactions, interactions);
            break;
        case OutputTarget::line:
            check_line(where, def, ctx.model.interactions, wires, interactions);
            break;
        case OutputTarget::world:
            break;
        case OutputTarget::system:
            throw_def_error(where, "signals belong to their system; add the system");
    }
    def.component = chosen.name;
    if (def.unit.empty()) def.unit = unit;
    return component;
}

}  // namespace hawser::world
