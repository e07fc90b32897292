// SPDX-License-Identifier: Apache-2.0
#include "scene/resolutions.h"

#include "scene/cable_parts.h"
#include "scene/field_reader.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

namespace hawser::scene {
namespace {

constexpr double kMaxMetres = 1e6, kHalfTurn = 3.14159265358979323846;

constexpr FieldInfo<ResolutionDef> kResolutionFields[] = {
    {"min_length", &ResolutionDef::min_length, "m", "2.5", "No element gets shorter by a node.",
     0.01, kMaxMetres},
    {"max_length", &ResolutionDef::max_length, "m", "20",
     "Length of the longest element; at least twice \"min_length\".", 0.01, kMaxMetres},
    {"sag_error", &ResolutionDef::sag_error, "m", "0.05",
     "Maximum distance of an element from its arc; 0: no limit.", 0.0, kMaxMetres},
    {"max_angle", &ResolutionDef::max_angle, "rad", "0.26",
     "Largest angle between elements; 0: no limit.", 0.0, kHalfTurn},
    {"contact_length", &ResolutionDef::contact_length, "m", "twice \"min_length\"",
     "Maximum length of elements in contact, and of their neighbours; 0: no limit.", 0.0,
     kMaxMetres},
    {"drum_length", &ResolutionDef::drum_length, "m", "\"element\" of its winch",
     "Maximum length of the element next to a drum; 0: no limit.", 0.0, kMaxMetres},
    {"wave_period", &ResolutionDef::wave_period, "s", "2",
     "Period of the shortest transverse wave to be resolved; 0: no limit.", 0.0, kMaxMetres},
    {"points_per_wave", &ResolutionDef::points_per_wave, "1", "8", "Elements to that wave.", 2.0,
     1000.0},
    {"averaging", &ResolutionDef::averaging, "s", "10",
     "Averaging time of the tension from which wave lengths are computed.", 1e-3, kMaxMetres},
    {"hysteresis", &ResolutionDef::hysteresis, "1", "1.5",
     "Elements become one where that would be shorter than it may be by this factor.", 1.0, 100.0},
    {"patience", &ResolutionDef::patience, "s", "2",
     "Time for which a node must be unnecessary before it is removed.", 0.0, kMaxMetres},
    {"max_nodes", &ResolutionDef::max_nodes, "", "1000",
     "Largest number of nodes of the cable, its ends included.", 3.0, 1e5},
    {"interval", &ResolutionDef::interval, "", "4",
     "Number of steps between two checks of the cable.", 1.0, 1e4}};

/// Check that the limits of a resolution are consistent. A fault is reported at the key that is too
/// small or too large.
void check_limits(const ResolutionDef& def, const SourceLocation& location) {
    if (def.max_length < 2.0 * def.min_length)
        throw_error(
            location / "max_length",
            fmt::format("{:.6g} m is below twice \"min_length\", {:.6g} m: the halves of the "
                        "longest element would be too short",
                        def.max_length, def.min_length));
    for (const auto& [key, value] : {std::pair{"contact_length", def.contact_length},
                                     std::pair{"drum_length", def.drum_length}})
        if (value != 0.0 && (value < def.min_length || value > def.max_length))
            throw_error(location / key,
                        fmt::format("{:.6g} m is not within \"min_length\", {:.6g} m, and "
                                    "\"max_length\", {:.6g} m; 0: no such bound",
                                    value, def.min_length, def.max_length));
}

}  // namespace

std::span<const FieldInfo<ResolutionDef>> resolution_fields() noexcept { return kResolutionFields; }

void read_resolution(Description& out, const CableLayout& cable, const Json& json,
                     const SourceLocation& cable_location) {
    const auto given = json.find("resolution");
    if (given == json.end()) return;
    const SourceLocation location = cable_location / "resolution";
    if (cable.links) throw_error(location, "a cable of links has the elements that it has");
    if (!cable.consistent_mass)
        throw_error(location,
                    "nodes need mass from elements: the cable needs \"consistent_mass\": true");
    Resolution one;
    one.def.name = cable.name + "/resolution";
    one.cable = cable.name;
    read_fields(one.def, *given, kResolutionFields);
    check_limits(one.def, location);
    if (cable.elements + 1 > static_cast<std::size_t>(one.def.max_nodes))
        throw_error(location / "max_nodes",
                    fmt::format("the cable has {} nodes from the start", cable.elements + 1));
    if (cable.sections.size() == 1) one.def.mass_per_length = cable.first().line.mass_per_length;
    one.location = out.store_location(location);
    out.resolutions.push_back(std::move(one));
}

}  // namespace hawser::scene
