// SPDX-License-Identifier: Apache-2.0
#include "scene/winches.h"

#include "scene/description.h"
#include "scene/field_reader.h"
#include "scene/line_types.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

constexpr double kMaxLength = 1e4, kMaxWinchForce = 1e15, kMaxInertia = 1e18;

constexpr FieldInfo<WinchDef> kNumbers[] = {
    {"core_radius", &WinchDef::core_radius, "m", "required of drums", "Radius of the bare drum.",
     0.0, kMaxLength},
    {"width", &WinchDef::width, "m", "required of drums", "Between the flanges.", 0.0, kMaxLength},
    {"flange_radius", &WinchDef::flange_radius, "m", "as far as \"stored\" needs",
     "Radius of the flanges; wire does not extend beyond it.", 0.0, kMaxLength},
    {"wire_diameter", &WinchDef::wire_diameter, "m", "of the line type", "Diameter of the wire.",
     0.0, kMaxLength},
    {"layer_pitch", &WinchDef::layer_pitch, "m", "the wire's diameter",
     "Height of one layer above the one below it.", 0.0, kMaxLength},
    {"element", &WinchDef::element, "m", "of the cable",
     "Length of the elements that it pays out; 0: the element at the drum grows and shrinks.", 0.0,
     1e6},
    {"stored", &WinchDef::stored, "m", "",
     "Wire on the drum, or chain in the locker, at the start.", 0.0, 1e6},
    {"inertia", &WinchDef::inertia, "kg m^2", "",
     "Moment of inertia of the bare drum or the gypsy, and of the parts that rotate with it.", 0.0,
     kMaxInertia},
    {"motor_inertia", &WinchDef::motor_inertia, "kg m^2", "0",
     "Moment of inertia of motor and gear, referred to the drum, that the clutch connects.", 0.0,
     kMaxInertia},
    {"torque_haul", &WinchDef::torque_haul, "N m", "no limit",
     "Largest torque of the motor when it hauls.", 0.0, kMaxWinchForce},
    {"torque_pay", &WinchDef::torque_pay, "N m", "no limit",
     "Largest torque of the motor when it pays out.", 0.0, kMaxWinchForce},
    {"power", &WinchDef::power, "W", "no limit", "Largest power of the motor.", 0.0,
     kMaxWinchForce},
    {"max_speed", &WinchDef::max_speed, "m/s", "2",
     "Largest speed at which the modes tension and render haul in wire.", 0.0, 100.0},
    {"speed", &WinchDef::speed, "m/s", "0", "Wanted in mode speed; below 0 it hauls.", -100.0,
     100.0},
    {"tension", &WinchDef::tension, "N", "0", "Wanted in modes tension and render.", 0.0,
     kMaxWinchForce},
    {"deadband", &WinchDef::deadband, "N", "0", "Deadband of mode render, to each side.", 0.0,
     kMaxWinchForce},
    {"brake_static", &WinchDef::brake_static, "N m", "0",
     "Torque at which the band begins to slip as wire runs out.", 0.0, kMaxWinchForce},
    {"brake_dynamic", &WinchDef::brake_dynamic, "N m", "brake_static",
     "Torque with which it slips.", 0.0, kMaxWinchForce},
    {"band_friction", &WinchDef::band_friction, "1", "0", "Friction coefficient of the band.", 0.0,
     10.0},
    {"band_angle", &WinchDef::band_angle, "rad", "0",
     "Angle that the band covers. While wire is hauled in, its torque is reduced to e^(-friction × "
     "angle).",
     0.0, 100.0},
    {"release_delay", &WinchDef::release_delay, "s", "0", "Delay of an emergency release.", 0.0,
     1e6},
    {"release_load", &WinchDef::release_load, "N", "0", "Tension that is left after it.", 0.0,
     kMaxWinchForce},
    {"dead_wraps", &WinchDef::dead_wraps, "1", "5", "The motor pays out no further.", 0.0, 1e6},
    {"wrap_friction", &WinchDef::wrap_friction, "1", "0.1",
     "Friction coefficient of wire on the drum.", 0.0, 10.0},
    {"weak_link", &WinchDef::weak_link, "N", "0",
     "Load of the wire's fastening; 0: it lets go when the drum is empty.", 0.0, kMaxWinchForce},
    {"overload_limit", &WinchDef::overload_limit, "N", "0, no protection",
     "Tension at which the overload protection pays out in every mode.", 0.0, kMaxWinchForce},
    {"overload_retained", &WinchDef::overload_retained, "N", "0",
     "Tension that is left while the signal NAME.mops is 1.", 0.0, kMaxWinchForce},
    {"heave_speed", &WinchDef::heave_speed, "m/s", "0, no compensation",
     "Largest speed of the heave compensation.", 0.0, 100.0},
    {"heave_acceleration", &WinchDef::heave_acceleration, "m/s^2", "no limit",
     "Largest acceleration of the heave compensation.", 0.0, 1e6},
    {"heave_falls", &WinchDef::heave_falls, "1", "1",
     "Wire paid out per height of the compensated point: falls of a tackle.", 0.0, 100.0}};

constexpr FieldInfo<GypsyDef> kGypsyNumbers[] = {
    {"pitch", &GypsyDef::pitch, "m", "4 wire_diameter",
     "Pitch of a link; a pocket holds two links. The radius is pockets × pitch / pi.", 0.0, 100.0},
    {"jump_load", &GypsyDef::jump_load, "N", "it does not jump",
     "Difference of the tensions outboard and inboard above which chain jumps by a pocket.", 0.0,
     kMaxWinchForce},
    {"jump_friction", &GypsyDef::jump_friction, "N", "half of jump_load",
     "Friction force of links on the wheel while they jump.", 0.0, kMaxWinchForce},
    {"locker_fall", &GypsyDef::locker_fall, "m", "0",
     "Length of chain that hangs from the wheel into the locker; its weight adds back tension.",
     0.0, kMaxLength},
    {"locker", &GypsyDef::locker, "m", "no limit", "Length of chain in the locker.", 0.0, 1e6},
    {"wrap", &GypsyDef::wrap, "rad", "pi", "Angle of the wheel that the chain covers.", 0.0, 7.0}};

/// Return the cable of a winch in this scope.
const Cable& find_cable_of_winch(const Description& out, const Scope& scope, const Json& json,
                                 const SourceLocation& location) {
    const std::string name = json["cable"].get<std::string>();
    if (const Cable* cable = out.find_cable(scope.prefix + name); cable != nullptr) return *cable;
    std::vector<std::string> known;
    for (const Cable& cable : out.cables)
        if (cable.name.starts_with(scope.prefix))
            known.push_back(cable.name.substr(scope.prefix.size()));
    report_missing(out.mistakes, OmittedPart::cable, scope.prefix + name, location / "cable",
                   "there is no cable " + in_quotes(name) + suggestion(name, known));
}

/// Return the section of an element of a cable.
const CableSection& section_of(const Cable& cable, std::size_t element) {
    std::size_t k = 0;
    for (; k + 1 < cable.sections.size() && element >= cable.sections[k].elements; ++k)
        element -= cable.sections[k].elements;
    return cable.sections[k];
}

/// Return the section at the end with the winch.
const CableSection& section_at(const Cable& cable, int end) {
    return end == 0 ? cable.sections.front() : cable.sections.back();
}

/// Set the masses of elements, which move as straight pieces and distribute mass to nodes. The
/// winch carries the mass of the element at its drum (WinchDef::element).
void set_element_masses(Description& out, const Cable& cable, const WinchDef& winch,
                        const SourceLocation& location) {
    const auto element = [&](InteractionId id) -> InteractionDef& {
        return out.interactions[static_cast<std::size_t>(id.index)];
    };
    for (std::size_t i = 0; i < cable.stretch.size(); ++i) {
        InteractionDef& d = element(cable.stretch[i]);
        if (kind_info(d.kind).is(kWoundUp) || !std::isnan(d.get("mass"))) continue;
        d.set("mass", section_of(cable, i).mass_per_length * d.get("length"));
    }
    const InteractionDef& at_drum =
        element(winch.end == 0 ? cable.stretch.front() : cable.stretch.back());
    const BodyId next = at_drum.body[winch.end == 0 ? 1 : 0];
    BodyDef& lump = out.bodies[static_cast<std::size_t>(next.index)];
    if (lump.kind != BodyKind::lump) return;
    const double line = section_at(cable, winch.end).mass_per_length;
    const double mass = lump.mass - 0.5 * line * at_drum.get("length");
    if (!(mass > 1e-6 * lump.mass))
        throw_error(location / "cable", "both ends of the cable " + in_quotes(cable.name) +
                                            " are wound up: give it at least three elements");
    const double scale = mass / lump.mass;
    lump.mass = mass;
    lump.linear_damping *= scale;
    lump.force *= scale;
}

void read_wheel(WinchDef& def, const Cable& cable, const Json& json,
                const SourceLocation& location) {
    const auto gypsy = json.find("gypsy");
    if (gypsy == json.end()) {
        for (const char* key : {"core_radius", "width"})
            if (!json.contains(key))
                throw_error(location, std::string("a winch needs the key \"") + key +
                                          "\" (of its drum), or \"gypsy\" (a wheel for chain)");
        return;
    }
    if (section_at(cable, def.end).EI > 0.0)
        throw_error(location / "cable",
                    "the cable " + in_quotes(cable.name) +
                        " has \"EI\" in its line type, but a gypsy takes chain, "
                        "which does not resist bending");
    def.gypsy.pockets = (*gypsy)["pockets"].get<int>();
    read_fields(def.gypsy, *gypsy, kGypsyNumbers);
}

/// Add the drum, and the chain on a gypsy, as bodies of the scene. @return the body that carries
/// the cable.
BodyId add_wheel(Description& out, Winch& winch) {
    WinchDef& def = winch.def;
    const auto add = [&](const char* what, double mass) {
        BodyDef body{.name = def.name + what, .kind = BodyKind::scalar};
        body.mass = mass;
        body.gravity = false;
        return out.add_body(std::move(body), winch.location);
    };
    def.drum = add("/drum", drum_mass(def));
    if (def.gypsy.pockets == 0) return def.drum;
    return def.chain = add("/chain", gypsy_chain_inertia(def));
}

void read_winch(Description& out, const Scope& scope, const Json& json,
                const SourceLocation& location) {
    Winch winch;
    WinchDef& def = winch.def;
    def.name = scope.prefix + json["name"].get<std::string>();
    const Cable& cable = find_cable_of_winch(out, scope, json, location);
    winch.cable = cable.name;
    if (cable.links)
        throw_error(location / "cable",
                    "a cable of links cannot be wound up; give it \"as\": \"lumps\"");
    def.end = text_or(json, "end", "from") == "to" ? 1 : 0;
    const CableSection& section = section_at(cable, def.end);
    def.wire_diameter = section.diameter;
    def.mass_per_length = section.mass_per_length;
    read_fields(def, json, kNumbers);
    if (!(def.wire_diameter > 0.0))
        throw_error(location,
                    "a winch needs \"wire_diameter\": its cable's line type has no diameter");
    read_wheel(def, cable, json, location);
    if (const auto at = json.find("heave_point"); at != json.end()) {
        def.heave_body = resolve_body(out, scope, (*at)["body"].get<std::string>(),
                                      location / "heave_point" / "body");
        def.heave_point = vector_of((*at)["point"]);
    }
    const std::string mode = text_or(json, "mode", "brake");
    const auto modes = winch_modes();
    def.mode = static_cast<WinchMode>(std::find(modes.begin(), modes.end(), mode) - modes.begin());
    // The element at the end has the drum as a body from the start, so that outputs find it.
    const InteractionId element = def.end == 0 ? cable.stretch.front() : cable.stretch.back();
    InteractionDef& d = out.interactions[static_cast<std::size_t>(element.index)];
    if (kind_info(d.kind).is(kWoundUp))
        throw_error(location / (json.contains("end") ? "end" : "cable"),
                    "this end of the cable " + in_quotes(cable.name) +
                        " is on a drum already; an end can have one winch only");
    if (cable.stretch.size() == 1 && def.end == 1 && !(def.element == 0.0))
        throw_error(
            location / "end",
            "a cable of one element is wound up from its first end; change its ends, give it "
            "two elements, or the winch \"element\": 0");
    if (std::isnan(def.element)) def.element = d.get("length");
    if (section.link > 0.0 && def.element > 0.0 && !rounded_to_links(def.element, section.link))
        throw_error(location / "element", "chain is paid out by whole links; give a multiple of " +
                                              std::to_string(section.link) +
                                              " m, the \"link\" of its line type");
    for (const Resolution& fine : out.resolutions)
        if (fine.cable == winch.cable && json.contains("element") &&
            def.element > fine.def.max_length)
            throw_error(
                location / "element",
                fmt::format("{:.6g} m is above \"max_length\" of the resolution of its cable, "
                            "{:.6g} m: elements that it pays out would be divided at once",
                            def.element, fine.def.max_length));
    if (def.element > 0.0) set_element_masses(out, cable, def, location);
    winch.location = out.store_location(location);
    const BodyId wound = add_wheel(out, winch);
    const InteractionDef stretch = d;
    d.kind = InteractionKind::WinchStretch;
    d.params.fill(kDefault);
    for (const char* same : {"length", "EA", "tension_only", "breaking_load"})
        if (const double value = stretch.get(same); !std::isnan(value)) d.set(same, value);
    d.body[2] = wound;
    d.set("radius",
          def.gypsy.pockets != 0 ? gypsy_radius(def) : def.core_radius + 0.5 * def.wire_diameter);
    // Paid-out wire has the line type of the section at the winch.
    for (Cable& one : out.cables)
        if (one.name == winch.cable) one.trim.EI = section.EI;
    out.winches.push_back(std::move(winch));
}

}  // namespace

std::span<const FieldInfo<WinchDef>> winch_fields() noexcept { return kNumbers; }
std::span<const FieldInfo<GypsyDef>> gypsy_fields() noexcept { return kGypsyNumbers; }

void expand_winches(Description& out, const Scope& scope) {
    const auto list = scope.content->find("winches");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / "winches" / i;
        (void)attempt(out.mistakes, [&] {
            for (const Winch& other : out.winches)
                if (other.def.name == scope.prefix + json["name"].get<std::string>())
                    throw_error(location / "name",
                                "the winch " + in_quotes(other.def.name) + " exists already");
            read_winch(out, scope, json, location);
        });
    }
}

}  // namespace hawser::scene
