// SPDX-License-Identifier: Apache-2.0
/// Convert the key "sea" of a scene to a definition. Its bodies and wires are found by name.
#include <hawser/sea.h>

#include "scene/description.h"
#include "scene/field_reader.h"
#include "scene/line_types.h"
#include "scene/sea_fields.h"
#include "scene/water_hulls.h"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

namespace hawser::scene {
namespace {

double read_degrees(const Json& object, const char* key) {
    return number_or(object, key, 0.0) * std::numbers::pi / 180.0;
}

/// Read a value for each axis. The JSON value is one number for all axes, or three numbers.
Vec3 read_axis_values(const Json& object, const char* key) {
    const auto value = object.find(key);
    if (value == object.end()) return Vec3::Zero();
    return value->is_array() ? vector_of(*value) : Vec3::Constant(value->get<double>());
}

WaveDef read_wave(const Json& json) {
    WaveDef wave;
    const std::string kind = json["kind"].get<std::string>();
    wave.kind = kind == "regular"   ? WaveKind::regular
                : kind == "jonswap" ? WaveKind::jonswap
                                    : WaveKind::pierson_moskowitz;
    read_fields(wave, json, kWaveFields);
    wave.direction = read_degrees(json, "direction_deg");
    wave.phase = read_degrees(json, "phase_deg");
    return wave;
}

WindDef read_wind_def(const Json& json) {
    WindDef wind;
    read_fields(wind, json, kWindFields);
    wind.direction = read_degrees(json, "direction_deg");
    return wind;
}

/// Read a rod, except its body.
WaterRod read_rod(const Json& json) {
    WaterRod rod;
    rod.from = vector_of(json["from"]);
    rod.to = vector_of(json["to"]);
    rod.water.diameter = json["diameter"].get<double>();
    read_line_water(json, rod.water);
    rod.segments = json.value("segments", rod.segments);
    return rod;
}

/// Reads the sea. Objects on bodies of the first copy of the scene are repeated for the others.
class SeaReader {
  public:
    SeaReader(Description& out, const Document& document, const Json& sea)
        : out_(out), json_(sea), location_(document.location / "sea"), scope_{} {
        scope_.content = &document.root;
        scope_.location = document.location;
        if (const auto repeat = document.root.find("repeat"); repeat != document.root.end())
            copies_ = repeat->value("copies", 1);
    }

    SeaDef read() {
        SeaDef sea;
        sea.depth = json_["depth"].get<double>();
        sea.density = number_or(json_, "density", sea.density);
        for (const Json& l : list("level"))
            sea.level.push_back({l["time"].get<double>(), l["level"].get<double>()});
        for (const Json& w : list("waves")) sea.waves.push_back(read_wave(w));
        for (const Json& c : list("current"))
            sea.current.push_back({number_or(c, "depth", 0.0), c["speed"].get<double>(),
                                   read_degrees(c, "direction_deg")});
        if (json_.contains("wind")) sea.wind = read_wind_def(json_["wind"]);
        if (json_.contains("gauge"))
            sea.gauge = {json_["gauge"][0].get<double>(), json_["gauge"][1].get<double>()};
        sea.convective = json_.value("convective", false);
        read_bodies(sea);
        read_hulls(sea);
        read_rods(sea);
        return sea;
    }

  private:
    const Json& list(const char* key) const {
        static const Json none = Json::array();
        const auto found = json_.find(key);
        return found == json_.end() ? none : *found;
    }

    /// Return the bodies of this name in all copies.
    std::vector<BodyId> bodies(const Json& json, const SourceLocation& location) {
        const std::string name = json["body"].get<std::string>();
        std::vector<BodyId> found{resolve_body(out_, scope_, name, location / "body")};
        for (int copy = 1; copy < copies_; ++copy)
            if (const BodyId id = out_.find_body(std::to_string(copy) + ":" + name); id.valid())
                found.push_back(id);
        return found;
    }

    void read_bodies(SeaDef& sea) {
        const Json& all = list("bodies");
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].is_null()) continue;  // Left out: mistakes.h.
            const SourceLocation location = location_ / "bodies" / i;
            (void)attempt(out_.mistakes, [&] {
                WaterBody body;
                body.drag_area = read_axis_values(all[i], "drag_area");
                body.wind_area = read_axis_values(all[i], "wind_area");
                body.volume = number_or(all[i], "volume", 0.0);
                body.added_mass = read_axis_values(all[i], "added_mass");
                body.height = number_or(all[i], "height", 0.0);
                for (const BodyId id : bodies(all[i], location)) {
                    body.body = id;
                    sea.bodies.push_back(body);
                    out_.sea_body_locations.push_back(location);
                }
            });
        }
    }

    void read_hulls(SeaDef& sea) {
        const Json& all = list("hulls");
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].is_null() || hull_is_omitted(all[i])) continue;  // Left out: mistakes.h.
            const SourceLocation location = location_ / "hulls" / i;
            (void)attempt(out_.mistakes, [&] {
                WaterHull hull = hull_of(all[i], location);
                hull.drag_area = read_axis_values(all[i], "drag_area");
                hull.wind_area = read_axis_values(all[i], "wind_area");
                for (const BodyId id : bodies(all[i], location)) {
                    hull.body = id;
                    sea.hulls.push_back(hull);
                    out_.sea_hull_locations.push_back(location);
                }
            });
        }
    }

    void read_rods(SeaDef& sea) {
        const Json& all = list("rods");
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (all[i].is_null()) continue;  // Left out: mistakes.h.
            const SourceLocation location = location_ / "rods" / i;
            (void)attempt(out_.mistakes, [&] {
                WaterRod rod = read_rod(all[i]);
                for (const BodyId id : bodies(all[i], location)) {
                    rod.body = id;
                    sea.rods.push_back(rod);
                    out_.sea_rod_locations.push_back(location);
                }
            });
        }
    }

    Description& out_;
    const Json& json_;
    SourceLocation location_;
    Scope scope_;
    int copies_ = 1;
};

}  // namespace

void expand_sea(Description& out, const Document& document, std::size_t waters) {
    const auto sea = document.root.find("sea");
    if (sea == document.root.end() || !sea->is_object()) return;
    const auto repeat = document.root.find("repeat");
    const int copies = repeat == document.root.end() ? 1 : repeat->value("copies", 1);
    for (int copy = 1; copy < copies; ++copy)
        for (std::size_t i = 0; i < waters; ++i) {
            CableWater water = out.waters[i];
            water.cable = std::to_string(copy) + ":" + water.cable;
            out.waters.push_back(std::move(water));
        }
    (void)attempt(out.mistakes, [&] {
        out.sea_location = document.location / "sea";
        out.sea = SeaReader(out, document, *sea).read();
    });
}

void store_water(Description& out, const CableWater& water) {
    const bool wet = std::any_of(water.sections.begin(), water.sections.end(),
                                 [](const auto& s) { return s.water.diameter > 0.0; });
    if (wet) out.waters.push_back(water);
}

void add_sea(World& world, const Description& from) {
    if (!from.sea) return;
    SeaDef def = *from.sea;
    std::vector<const CableWater*> of_line;
    for (const CableWater& water : from.waters) {
        const WireId wire = world.wires().find(water.cable);
        if (!wire.valid()) continue;
        def.lines.push_back({.wire = wire,
                             .sections = water.sections,
                             .free_first = water.free_first,
                             .free_last = water.free_last});
        of_line.push_back(&water);
    }
    try {
        world.add(def);
    } catch (const SeaError& error) {
        // "bodies/3/volume" refers to the list in the definition: convert it to the place in the
        // scene.
        SourceLocation at = from.sea_location;
        std::string field = error.field;
        const auto moved = [&](const std::string& list, const auto& place_of, std::size_t count) {
            if (!field.starts_with(list + "/")) return false;
            const std::size_t i = std::stoul(field.substr(list.size() + 1));
            if (i >= count) return false;
            at = place_of(i);
            const std::size_t rest = field.find('/', list.size() + 1);
            field = rest == std::string::npos ? "" : field.substr(rest + 1);
            return true;
        };
        const auto moved_to = [&](const char* list, const std::vector<SourceLocation>& places) {
            return moved(list, [&](std::size_t i) { return places[i]; }, places.size());
        };
        if (moved("lines", [&](std::size_t i) { return of_line[i]->location; }, of_line.size()))
            field.clear();
        else
            (void)(moved_to("bodies", from.sea_body_locations) ||
                   moved_to("hulls", from.sea_hull_locations) ||
                   moved_to("rods", from.sea_rod_locations));
        for (std::size_t begin = 0; begin < field.size();) {
            const std::size_t end = std::min(field.find('/', begin), field.size());
            at = at / field.substr(begin, end - begin);
            begin = end + 1;
        }
        throw_error(at, error.what());
    }
}

}  // namespace hawser::scene
