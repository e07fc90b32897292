// SPDX-License-Identifier: Apache-2.0
#include "scene/dp_ship.h"

#include <hawser/dp_ship_file.h>

#include "scene/error.h"
#include "scene/format.h"
#include "scene/read_json.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <string_view>

namespace hawser::scene {
namespace {

constexpr double kDpDegree = std::numbers::pi / 180.0;
constexpr const char* kDpFile = "data of a ship for DNV-ST-0111";

/// Return the enumerator whose name is the word of a key.
template <class Enum>
Enum read_enum(const Json& json, const char* key, int count, Enum fallback) {
    const auto entry = json.find(key);
    if (entry == json.end()) return fallback;
    const std::string word = entry->template get<std::string>();
    for (int i = 0; i < count; ++i)
        if (word == to_string(static_cast<Enum>(i))) return static_cast<Enum>(i);
    return fallback;
}

std::vector<std::string> dp_names(const Json& json, const std::vector<DpThruster>& thrusters,
                                  const SourceLocation& location) {
    std::vector<std::string> out, known;
    for (const DpThruster& t : thrusters) known.push_back(t.name);
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::string name = json[i].get<std::string>();
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw_error(location / i,
                        "there is no thruster " + in_quotes(name) + suggestion(name, known));
        out.push_back(name);
    }
    return out;
}

DpThruster read_dp_thruster(const Json& json) {
    DpThruster t;
    t.name = json["name"].get<std::string>();
    t.kind = read_enum(json, "kind", kDpThrusterKinds, t.kind);
    t.propeller = read_enum(json, "propeller", kDpPropellers, t.propeller);
    t.inlet = read_enum(json, "inlet", kDpInlets, t.inlet);
    t.drive = read_enum(json, "drive", kDpDrives, t.drive);
    if (const auto flag = json.find("controllable"); flag != json.end())
        t.controllable = flag->get<bool>();
    t.point = vector_of(json["point"]);
    t.diameter = json["diameter"].get<double>();
    t.power = json["power"].get<double>();
    if (const auto rudder = json.find("rudder"); rudder != json.end()) {
        t.rudder.area = (*rudder)["area"].get<double>();
        t.rudder.profile = read_enum(*rudder, "profile", kDpRudderProfiles, t.rudder.profile);
    }
    if (const auto zones = json.find("forbidden_deg"); zones != json.end())
        for (const Json& z : *zones)
            t.forbidden.push_back({z[0].get<double>() * kDpDegree, z[1].get<double>() * kDpDegree});
    return t;
}

}  // namespace

DpShip read_dp_ship(const Json& json, const SourceLocation& location) {
    DpShip s;
    s.length = json["length"].get<double>();
    s.beam = json["beam"].get<double>();
    s.draught = json["draught"].get<double>();
    s.surface_length = number_or(json, "surface_length", 0.0);
    s.surface_x = number_or(json, "surface_x", 0.0);
    s.bow_angle = json["bow_angle_deg"].get<double>() * kDpDegree;
    s.aft_waterplane = json["aft_waterplane"].get<double>();
    s.frontal_area = json["frontal_area"].get<double>();
    s.lateral_area = json["lateral_area"].get<double>();
    s.lateral_x = number_or(json, "lateral_x", 0.0);
    s.submerged_area = json["submerged_area"].get<double>();
    s.submerged_x = number_or(json, "submerged_x", 0.0);
    if (const auto list = json.find("skegs"); list != json.end())
        for (const Json& each : *list)
            s.skegs.push_back({each[0].get<double>(), each[1].get<double>()});
    for (const Json& each : json["thrusters"]) s.thrusters.push_back(read_dp_thruster(each));
    if (const auto list = json.find("switchboards"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& each = (*list)[i];
            s.switchboards.push_back({each.value("name", ""), each["power"].get<double>(),
                                      dp_names(each["thrusters"], s.thrusters,
                                               location / "switchboards" / i / "thrusters")});
        }
    if (const auto list = json.find("failures"); list != json.end())
        for (std::size_t i = 0; i < list->size(); ++i) {
            const Json& each = (*list)[i];
            s.failures.push_back({each["name"].get<std::string>(),
                                  dp_names(each["thrusters"], s.thrusters,
                                           location / "failures" / i / "thrusters")});
        }
    try {
        check_dp_ship(s);
    } catch (const DefError& error) {
        FieldWords said = field_words(error);
        constexpr std::string_view kKeyPrefix = "dp_capability: ";
        if (said.words.starts_with(kKeyPrefix)) said.words.erase(0, kKeyPrefix.size());
        throw_field_error(location, said);
    }
    return s;
}

bool is_dp_ship_file(const std::filesystem::path& file) {
    const Json root = read_json_file(file, {"name", "dp_capability", "bodies"}, nullptr, kDpFile);
    return root.is_object() && !root.contains("bodies") && root.contains("dp_capability");
}

NamedDpShip load_dp_ship(const std::filesystem::path& file) {
    const Json root =
        read_json_file(file, {"name", "description", "dp_capability", "$schema"}, nullptr, kDpFile);
    const SourceLocation location{file.string(), ""};
    check_shape(root, *dp_file_shape(), location);
    return {root.value("name", file.stem().string()),
            read_dp_ship(root["dp_capability"], location / "dp_capability")};
}

}  // namespace hawser::scene
