// SPDX-License-Identifier: Apache-2.0
/// System of a resolution from its definition.
#include <hawser/resolution.h>
#include <hawser/world.h>

#include "wire/bounds.h"
#include "wire/wire_resolution.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace hawser {
namespace {

[[noreturn]] void throw_def_error(const ResolutionDef& def, const std::string& what) {
    throw DefError("resolution '" + def.name + "': " + what);
}

/// Relative difference of masses per length up to which elements are of one line type. Edits change
/// their rest lengths.
constexpr double kSameLine = 0.05;

void check_number(const ResolutionDef& def, const char* quantity, double value, double least,
                  double most) {
    if (!(value >= least && value <= most))
        throw_def_error(def, std::string(quantity) + " = " + number(value) + "; give " +
                                 number(least) + " to " + number(most));
}

/// Return the line types of a wire's stretch elements; empty if no element has a mass. Elements of
/// equal EA have two line types if their masses per length differ by more than rounding.
std::vector<wire::WireResolution::Line> line_types_of_wire(const World& world, WireId wire) {
    struct LineTypeSum {
        double EA, mass, length;
    };
    std::vector<LineTypeSum> sums;
    for (const InteractionId id : world.wires().elements(wire)) {
        if (!world.alive(id)) continue;
        const InteractionDef& d = world.interaction_def(id);
        if (kind_info(d.kind).is(kWoundUp) || !(d.get("mass") > 0.0)) continue;
        const double EA = d.get("EA"), mass = d.get("mass"), length = d.get("length");
        const auto same = std::find_if(sums.begin(), sums.end(), [&](const LineTypeSum& s) {
            return s.EA == EA &&
                   std::abs(s.mass * length - mass * s.length) <= kSameLine * s.mass * length;
        });
        if (same == sums.end()) {
            sums.push_back({EA, mass, length});
        } else {
            same->mass += mass;
            same->length += length;
        }
    }
    std::vector<wire::WireResolution::Line> out;
    for (const LineTypeSum& s : sums) out.push_back({s.EA, s.mass / s.length});
    return out;
}

/// Return the length of the element that a drum pays out [m]; 0: no drum.
double length_at_drum(const World& world, WireId wire) {
    const auto elements = world.wires().elements(wire);
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
        const char* quantity;
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
        check_number(def, row.quantity, row.value, row.least, row.most);
    if (def.max_length < 2.0 * def.min_length)
        throw_def_error(
            def, "max_length = " + number(def.max_length) +
                     " m is below twice min_length = " + number(def.min_length) +
                     " m: a node in the middle of the longest element would make two that are "
                     "too short; give at least " +
                     number(2.0 * def.min_length));
}

/// Check that a local bound is 0 or within the limits.
void check_bound(const ResolutionDef& def, const char* quantity, double value) {
    if (value == 0.0) return;
    if (!(value >= def.min_length && value <= def.max_length))
        throw_def_error(def,
                        std::string(quantity) + " = " + number(value) +
                            " m; give 0 or a length from min_length = " + number(def.min_length) +
                            " to max_length = " + number(def.max_length));
}

void check_wire(World& world, const ResolutionDef& def) {
    if (!world.alive(def.wire)) throw_def_error(def, "there is no such wire; give one");
    for (int i = 0; i < world.system_count(); ++i)
        if (const auto* other = dynamic_cast<const wire::WireResolution*>(&world.system(i));
            other != nullptr && other->wire() == def.wire)
            throw_def_error(def, "the wire '" + world.wires().name(def.wire) +
                                     "' has the resolution '" + std::string(other->name()) +
                                     "' already; give one a wire");
}

}  // namespace

void define(World& world, const ResolutionDef& given) {
    ResolutionDef def = given;
    if (def.name.empty()) throw DefError("a resolution needs a name");
    if (world.find_system(def.name) != nullptr)
        throw_def_error(def, "the name is in use; names must be unique among systems");
    check_numbers(def);
    check_wire(world, def);
    auto lines = line_types_of_wire(world, def.wire);
    if (!std::isnan(def.mass_per_length)) lines.assign(1, {0.0, def.mass_per_length});
    if (lines.empty())
        throw_def_error(def, "the elements of the wire '" + world.wires().name(def.wire) +
                                 "' have no mass for new nodes; make it with consistent_mass");
    for (const auto& line : lines)
        if (!(line.mass_per_length > 0.0 && line.mass_per_length < 1e12))
            throw_def_error(def, "mass_per_length = " + number(line.mass_per_length) +
                                     "; give a number above 0");
    if (std::isnan(def.contact_length)) def.contact_length = 2.0 * def.min_length;
    check_bound(def, "contact_length", def.contact_length);
    if (std::isnan(def.drum_length)) {
        const double at_drum = length_at_drum(world, def.wire);
        def.drum_length = at_drum > 0.0 ? std::clamp(at_drum, def.min_length, def.max_length) : 0.0;
    }
    check_bound(def, "drum_length", def.drum_length);
    const std::size_t room =
        std::max(static_cast<std::size_t>(def.max_nodes), world.wires().nodes(def.wire).size()) + 1;
    world.add_system(std::make_unique<wire::WireResolution>(
        def, std::move(lines), room, std::int64_t{world.system_count()},
        static_cast<double>(world.wires().nodes(def.wire).size()), world.bodies().size()));
}

}  // namespace hawser
