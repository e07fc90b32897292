// SPDX-License-Identifier: Apache-2.0
/// From the definition of a resolution to its system.
#include <hawser/resolution.h>
#include <hawser/world.h>

#include "wire/bounds.h"
#include "wire/wire_resolution.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

namespace hawser {
namespace {

[[noreturn]] void refuse(const ResolutionDef& def, const std::string& what) {
    throw DefError("resolution '" + def.name + "': " + what);
}

using wire::number;

void check_number(const ResolutionDef& def, const char* what, double value, double least,
                  double most) {
    if (!(value >= least && value <= most))
        refuse(def, std::string(what) + " = " + number(value) + "; give " + number(least) + " to " +
                        number(most));
}

/// What a wire's Stretch elements are made of: mass over length [kg/m]; 0: none has a mass.
double mass_per_length_of(const World& world, WireId wire) {
    double mass = 0.0, length = 0.0;
    for (const InteractionId id : world.elements(wire)) {
        if (!world.alive(id)) continue;
        const InteractionDef& d = world.interaction_def(id);
        if (kind_info(d.kind).is(kWoundUp) || !(d.get("mass") > 0.0)) continue;
        mass += d.get("mass");
        length += d.get("length");
    }
    return length > 0.0 ? mass / length : 0.0;
}

/// Of the element that a drum pays out [m]; 0: no drum does.
double length_at_drum(const World& world, WireId wire) {
    const auto elements = world.elements(wire);
    for (const InteractionId id : {elements.front(), elements.back()}) {
        if (!world.alive(id)) continue;
        const InteractionDef& d = world.interaction_def(id);
        if (kind_info(d.kind).is(kWoundUp)) return d.get("length");
    }
    return 0.0;
}

void check_numbers(const ResolutionDef& def) {
    constexpr double kPi = 3.14159265358979323846;
    struct Row {
        const char* what;
        double value, least, most;
    };
    for (const Row& row :
         {Row{"min_length", def.min_length, 0.01, 1e6},
          Row{"max_length", def.max_length, 0.01, 1e6},
          Row{"max_nodes", static_cast<double>(def.max_nodes), 3.0, 1e5},
          Row{"sag_error", def.sag_error, 0.0, 1e6}, Row{"max_angle", def.max_angle, 0.0, kPi},
          Row{"wave_period", def.wave_period, 0.0, 1e6},
          Row{"points_per_wave", def.points_per_wave, 2.0, 1000.0},
          Row{"averaging", def.averaging, 1e-3, 1e6}, Row{"hysteresis", def.hysteresis, 1.0, 100.0},
          Row{"patience", def.patience, 0.0, 1e6},
          Row{"interval", static_cast<double>(def.interval), 1.0, 1e4}})
        check_number(def, row.what, row.value, row.least, row.most);
    if (def.max_length < 2.0 * def.min_length)
        refuse(def, "max_length = " + number(def.max_length) +
                        " m is below twice min_length = " + number(def.min_length) +
                        " m: a node in the middle of the longest element would make two that are "
                        "too short; give at least " +
                        number(2.0 * def.min_length));
}

/// A bound in some place is 0 or within the limits.
void check_bound(const ResolutionDef& def, const char* what, double value) {
    if (value == 0.0) return;
    if (!(value >= def.min_length && value <= def.max_length))
        refuse(def, std::string(what) + " = " + number(value) +
                        " m; give 0 or a length from min_length = " + number(def.min_length) +
                        " to max_length = " + number(def.max_length));
}

void check_wire(World& world, const ResolutionDef& def) {
    if (!world.alive(def.wire)) refuse(def, "there is no such wire; give one");
    for (int i = 0; i < world.system_count(); ++i)
        if (const auto* other = dynamic_cast<const wire::WireResolution*>(&world.system(i));
            other != nullptr && other->wire() == def.wire)
            refuse(def, "the wire '" + world.wire_name(def.wire) + "' has the resolution '" +
                            std::string(other->name()) + "' already; give one a wire");
}

}  // namespace

void define(World& world, const ResolutionDef& given) {
    ResolutionDef def = given;
    if (def.name.empty()) throw DefError("a resolution needs a name");
    if (world.find_system(def.name) != nullptr)
        refuse(def, "the name is taken; names are unique among systems");
    check_numbers(def);
    check_wire(world, def);
    const double has = mass_per_length_of(world, def.wire);
    if (std::isnan(def.mass_per_length)) def.mass_per_length = has;
    if (!(def.mass_per_length > 0.0 && def.mass_per_length < 1e12))
        refuse(def,
               has > 0.0 || !std::isnan(given.mass_per_length)
                   ? "mass_per_length = " + number(def.mass_per_length) + "; give a number above 0"
                   : "the elements of the wire '" + world.wire_name(def.wire) +
                         "' have no mass of their own that nodes could take; make it with "
                         "consistent_mass");
    if (std::isnan(def.contact_length)) def.contact_length = 2.0 * def.min_length;
    check_bound(def, "contact_length", def.contact_length);
    if (std::isnan(def.drum_length)) {
        const double there = length_at_drum(world, def.wire);
        def.drum_length = there > 0.0 ? std::clamp(there, def.min_length, def.max_length) : 0.0;
    }
    check_bound(def, "drum_length", def.drum_length);
    const std::size_t room =
        std::max(static_cast<std::size_t>(def.max_nodes), world.nodes(def.wire).size()) + 1;
    world.add_system(std::make_unique<wire::WireResolution>(
        def, room, std::int64_t{world.system_count()},
        static_cast<double>(world.nodes(def.wire).size()), world.bodies().size()));
}

}  // namespace hawser
