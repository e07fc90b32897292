// SPDX-License-Identifier: Apache-2.0
/// Vessels: hull forces, propulsors and rudders of bodies (hawser/vessel.h).
#include "scene/vessels.h"

#include <hawser/vessel_ships.h>

#include "scene/dp_ship.h"
#include "scene/field_reader.h"
#include "scene/vessel_control.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

constexpr double kVesselDegree = std::numbers::pi / 180.0;
/// Largest relative difference between the mass of the body and that of the published ship.
constexpr double kMassOff = 0.05;

template <class T>
void read_vessel_part(T& out, const Json& json) {
    read_fields(out, json, VesselTable<T>::kNumbers);
}

void read_matrix(Matrix6& out, const Json& json, const char* key) {
    const auto entry = json.find(key);
    if (entry == json.end()) return;
    out.setZero();
    for (std::size_t i = 0; i < 6; ++i) {
        const Json& row = (*entry)[i];
        const auto at = static_cast<Eigen::Index>(i);
        if (row.is_number()) out(at, at) = row.get<double>();
        if (!row.is_array()) continue;
        for (std::size_t j = 0; j < 6; ++j)
            out(at, static_cast<Eigen::Index>(j)) = row[j].get<double>();
    }
}

bool flag_or(const Json& json, const char* key, bool fallback) {
    const auto entry = json.find(key);
    return entry == json.end() ? fallback : entry->get<bool>();
}

HullPolynomial read_polynomial(const Json& json) {
    HullPolynomial p;
    read_vessel_part(p, json);
    if (json.value("scale", "speed") == "mass") p.scale = HullScale::mass;
    if (flag_or(json, "rudder_to_port", false)) p.rudder_sign = -1.0;
    p.own_coriolis = flag_or(json, "own_coriolis", false);
    const double factor = number_or(json, "factor", 1.0);
    constexpr std::pair<const char*, HullAxis> kAxes[] = {
        {"x", HullAxis::x}, {"y", HullAxis::y}, {"k", HullAxis::k}, {"n", HullAxis::n}};
    for (const auto& [key, axis] : kAxes)
        if (const auto terms = json.find(key); terms != json.end())
            for (const auto& [of, value] : terms->items())
                p.terms.push_back({axis, of, factor * value.get<double>()});
    return p;
}

PropulsorDef read_propulsor(const Json& json) {
    PropulsorDef p;
    read_vessel_part(p, json);
    p.name = json["name"].get<std::string>();
    const std::string kind = json.value("kind", "shaft");
    if (kind == "azimuth") p.kind = PropulsorKind::azimuth;
    if (kind == "tunnel") p.kind = PropulsorKind::tunnel;
    if (kind == "cycloidal") p.kind = PropulsorKind::cycloidal;
    p.ventilates = flag_or(json, "ventilates", false);
    p.point = vector_or(json, "point", p.point);
    p.controllable = flag_or(json, "controllable", false);
    const auto propeller = json.find("propeller");
    if (propeller == json.end()) return p;
    read_vessel_part(p.propeller, *propeller);
    const std::string series = propeller->value("series", "wageningen_b");
    if (series == "ka4_70") p.propeller.series = PropellerSeries::ka4_70;
    if (series == "ka5_75") p.propeller.series = PropellerSeries::ka5_75;
    return p;
}

RudderDef read_rudder(const Json& json, const std::vector<PropulsorDef>& propulsors,
                      const SourceLocation& location) {
    RudderDef r;
    read_vessel_part(r, json);
    r.name = json.value("name", r.name);
    r.point = vector_of(json["point"]);
    r.behind = json.value("behind", "");
    if (r.behind.empty()) return r;
    std::vector<std::string> known;
    for (const PropulsorDef& p : propulsors) {
        if (p.name == r.behind) return r;
        known.push_back(p.name);
    }
    throw_error(location / "behind",
                "there is no propulsor " + in_quotes(r.behind) + suggestion(r.behind, known));
}

CurrentLoad read_current(const Json& json) {
    CurrentLoad c;
    read_vessel_part(c, json);
    for (const Json& point : json["points"])
        c.points.push_back({point[0].get<double>() * kVesselDegree, point[1].get<double>(),
                            point[2].get<double>(), point[3].get<double>()});
    return c;
}

ConsumerDef read_consumer(const Json& json, const PowerDef& power, const SourceLocation& location) {
    ConsumerDef c;
    read_vessel_part(c, json);
    c.name = json["name"].get<std::string>();
    c.board = json["board"].get<std::string>();
    c.priority = static_cast<int>(number_or(json, "priority", 1.0));
    c.signal = json.value("signal", "");
    std::vector<std::string> known;
    for (const SwitchboardDef& b : power.boards) {
        if (b.name == c.board) return c;
        known.push_back(b.name);
    }
    throw_error(location / "board",
                "there is no switchboard " + in_quotes(c.board) + suggestion(c.board, known));
}

PowerDef read_power(const Json& json, const SourceLocation& location) {
    PowerDef p;
    read_vessel_part(p, json);
    p.tied = flag_or(json, "tied", false);
    for (const Json& each : json["boards"]) {
        SwitchboardDef board;
        board.name = each["name"].get<std::string>();
        for (const Json& one : each["generators"]) {
            GeneratorDef g;
            read_vessel_part(g, one);
            g.name = one["name"].get<std::string>();
            board.generators.push_back(std::move(g));
        }
        p.boards.push_back(std::move(board));
    }
    const Json& list = json["consumers"];
    for (std::size_t i = 0; i < list.size(); ++i)
        p.consumers.push_back(read_consumer(list[i], p, location / "consumers" / i));
    return p;
}

WindLoad read_wind(const Json& json) {
    WindLoad w;
    read_vessel_part(w, json);
    const std::string ship = json["ship"].get<std::string>();
    for (int i = 1; i < kWindShipCount; ++i)
        if (ship == to_string(static_cast<WindShip>(i))) w.ship = static_cast<WindShip>(i);
    return w;
}

/// Return the coefficients of a published ship for this body.
VesselDef read_ship(const Json& json, const BodyDef& body, const SourceLocation& location) {
    const std::string name = json["ship"].get<std::string>();
    PublishedShip ship;
    try {
        ship = published_ship(name, number_or(json, "depth", 1000.0));
    } catch (const DefError& error) {
        throw_field_error(location, field_words(error));
    }
    if (std::abs(body.mass / ship.body.mass - 1.0) > kMassOff)
        throw_error(location / "ship",
                    fmt::format("{} has {:.6g} kg, and the body {} has {:.6g} kg", name,
                                ship.body.mass, in_quotes(body.name), body.mass));
    return ship.vessel;
}

void read_hull_parts(VesselDef& def, const Json& json) {
    def.origin = vector_or(json, "origin", def.origin);
    def.draught = number_or(json, "draught", def.draught);
    def.density = number_or(json, "density", def.density);
    read_matrix(def.added_mass, json, "added_mass");
    read_matrix(def.damping, json, "damping");
    read_matrix(def.restoring, json, "restoring");
    if (const auto word = json.find("coriolis"); word != json.end())
        def.coriolis = *word == "none"     ? AddedCoriolis::none
                       : *word == "planar" ? AddedCoriolis::planar
                                           : AddedCoriolis::full;
    if (const auto part = json.find("resistance"); part != json.end()) {
        def.resistance = {};
        read_vessel_part(def.resistance, *part);
        if (const auto curve = part->find("curve"); curve != part->end())
            for (const Json& point : *curve)
                def.resistance.curve.push_back({point[0].get<double>(), point[1].get<double>()});
    }
    if (const auto part = json.find("cross_flow"); part != json.end()) {
        def.cross_flow = {};
        read_vessel_part(def.cross_flow, *part);
    }
    if (const auto part = json.find("current"); part != json.end())
        def.current = read_current(*part);
    if (const auto part = json.find("polynomial"); part != json.end())
        def.polynomial = read_polynomial(*part);
}

VesselDef read_vessel(Description& out, const Scope& scope, const Json& json,
                      const SourceLocation& location) {
    const BodyId body =
        resolve_body(out, scope, json["body"].get<std::string>(), location / "body");
    VesselDef def;
    if (json.contains("ship")) def = read_ship(json, out.body(body), location);
    def.name = scope.prefix + json["name"].get<std::string>();
    def.body = body;
    read_hull_parts(def, json);
    if (const auto part = json.find("mmg"); part != json.end()) {
        def.mmg = {};
        read_vessel_part(def.mmg, *part);
    }
    if (const auto part = json.find("steering"); part != json.end())
        read_vessel_part(def.steering, *part);
    if (const auto part = json.find("wind"); part != json.end()) def.wind = read_wind(*part);
    if (const auto list = json.find("propulsors"); list != json.end()) {
        def.propulsors.clear();
        for (const Json& each : *list) def.propulsors.push_back(read_propulsor(each));
    }
    if (const auto list = json.find("rudders"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i)
            def.rudders.push_back(
                read_rudder((*list)[i], def.propulsors, location / "rudders" / i));
    if (const auto part = json.find("power"); part != json.end())
        def.power = read_power(*part, location / "power");
    def.thruster_losses = flag_or(json, "thruster_losses", false);
    if (const auto part = json.find("control"); part != json.end())
        def.control =
            read_vessel_control(out, scope, *part, body, def.propulsors, location / "control");
    if (const auto part = json.find("dp_capability"); part != json.end())
        def.dp_capability = read_dp_ship(*part, location / "dp_capability");
    return def;
}

/// Throw an error of a vessel definition at its position in the scene. The library reports the
/// index of a term; the message has its name.
[[noreturn]] void throw_vessel_error(const SourceLocation& location, const VesselDef& def,
                                     const DefError& error) {
    FieldWords said = field_words(error);
    constexpr std::string_view kTermsPath = "polynomial/terms/";
    if (said.path.starts_with(kTermsPath)) {
        constexpr const char* kAxes[] = {"x", "y", "k", "n"};
        const HullTerm& t = def.polynomial.terms[std::stoul(said.path.substr(kTermsPath.size()))];
        throw_error(location / "polynomial" / kAxes[static_cast<std::size_t>(t.axis)] / t.of,
                    said.words);
    }
    for (const char* angle : {"most_angle", "rate", "stall", "turn_rate"})
        if (said.path.ends_with(std::string("/") + angle)) said.path += "_deg";
    throw_field_error(location, said);
}

}  // namespace

void expand_vessels(Description& out, const Scope& scope) {
    const auto list = scope.content->find("vessels");
    if (list == scope.content->end()) return;
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& json = (*list)[i];
        if (json.is_null()) continue;  // Left out: mistakes.h.
        const SourceLocation location = scope.location / "vessels" / i;
        (void)attempt(out.mistakes, [&] {
            VesselDef def = read_vessel(out, scope, json, location);
            for (const auto& other : out.vessels)
                if (other.def.name == def.name)
                    throw_error(location / "name",
                                "the name " + in_quotes(def.name) + " exists already");
            out.vessels.push_back({std::move(def), location});
        });
    }
}

void add_vessels(World& world, const Description& from) {
    for (const auto& item : from.vessels)
        (void)attempt(from.mistakes, [&] {
            try {
                world.add(item.def);
            } catch (const DefError& error) {
                throw_vessel_error(item.location, item.def, error);
            }
        });
}

}  // namespace hawser::scene
