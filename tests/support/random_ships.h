// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_ships.h
/// Scenes of random ships in a random sea. Sets of the library of vessels
/// (scenes/parts/vessel_*.json) are scaled by Froude's law; coefficients change at random.
///
/// Lengths grow with s, times with √s, masses and forces with s³, powers with s^3.5.

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::test {

class ShipMaker {
  public:
    using Json = nlohmann::ordered_json;

    /// Start. @param root  Folder with `scenes`.
    ShipMaker(std::uint64_t seed, std::string root) : state_(seed), root_(std::move(root)) {
        for (int i = 0; i < 4; ++i) (void)unit();
    }

    /// Make a scene. @param duration  [s]. @param orders  Add a timeline of random orders within
    /// their ranges.
    std::string scene(std::uint64_t number, double duration, bool orders) {
        constexpr const char* kParts[] = {"vessel_ahts", "vessel_tug", "vessel_barge",
                                          "vessel_semi"};
        const std::size_t kind = static_cast<std::size_t>(number % 4);
        s_ = kind == 3 ? between(0.7, 1.2) : std::exp(between(std::log(0.5), std::log(2.0)));
        const Json part = Json::parse(
            std::ifstream(root_ + "/scenes/parts/" + kParts[kind] + ".json"))["templates"];
        const Json from = part[kParts[kind]];
        const Json& own = from["bodies"][0];
        Json doc{{"version", 2}, {"name", "random_ship_" + std::to_string(number)}};
        doc["settings"] = {{"step", 1.0 / 60.0}, {"duration", duration}};
        Json body{{"name", "hull"}, {"mass", scaled(own["mass"], 3.0)}};
        body["inertia"] = scaled(own["inertia"], 5.0);
        body["half_size"] = scaled(own["half_size"], 1.0);
        Json vessel = vessel_of(from["vessels"][0]);
        // The origin of the coefficients is at the waterline.
        body["position"] = {0, 0, -vessel["origin"][2].get<double>()};
        doc["bodies"] = Json::array({body});
        doc["sea"] = sea_of(std::string(kParts[kind]), vessel, body);
        doc["vessels"] = Json::array({vessel});
        doc["outputs"] = Json::array();
        for (const char* component : {"x", "y", "z", "roll", "pitch", "yaw"})
            doc["outputs"].push_back({{"name", std::string("hull_") + component},
                                      {"kind", "pose"},
                                      {"body", "hull"},
                                      {"component", component}});
        if (orders) doc["timeline"] = timeline_of(vessel, duration);
        return doc.dump(1);
    }

    double unit() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double between(double a, double b) { return a + (b - a) * unit(); }

  private:
    /// Multiply numbers by s^power.
    [[nodiscard]] Json scaled(const Json& json, double power) const {
        if (json.is_number()) return json.get<double>() * std::pow(s_, power);
        Json out = json;
        if (json.is_array())
            for (Json& each : out) each = scaled(each, power);
        return out;
    }
    /// Change a coefficient by up to a fifth.
    [[nodiscard]] double changed(const Json& json) {
        return json.get<double>() * between(0.8, 1.2);
    }
    void scale(Json& json, const char* key, double power) const {
        if (json.contains(key)) json[key] = scaled(json[key], power);
    }

    /// Scale a mass matrix: entries of rotations contain further lengths.
    [[nodiscard]] Json matrix(const Json& json, double power) const {
        Json out = json;
        for (std::size_t i = 0; i < 6; ++i) {
            const double at = power + (i < 3 ? 0.0 : 1.0);
            if (json[i].is_number()) {
                out[i] = scaled(json[i], at + (i < 3 ? 0.0 : 1.0));
                continue;
            }
            for (std::size_t j = 0; j < 6; ++j)
                out[i][j] = scaled(json[i][j], at + (j < 3 ? 0.0 : 1.0));
        }
        return out;
    }

    Json vessel_of(const Json& from) {
        Json v = from;
        v["name"] = "ship";
        for (const char* key : {"origin", "draught"}) scale(v, key, 1.0);
        v["added_mass"] = matrix(v["added_mass"], 3.0);
        v["damping"] = matrix(v["damping"], 2.5);
        if (v.contains("resistance")) resistance(v["resistance"]);
        if (v.contains("cross_flow"))
            for (const char* key : {"length", "beam", "draught"}) scale(v["cross_flow"], key, 1.0);
        if (v.contains("current")) {
            for (const char* key : {"length", "draught"}) scale(v["current"], key, 1.0);
            for (Json& point : v["current"]["points"])
                for (std::size_t i = 1; i < 4; ++i) point[i] = changed(point[i]);
        }
        if (v.contains("polynomial")) {
            scale(v["polynomial"], "length", 1.0);
            scale(v["polynomial"], "area", 2.0);
            for (const char* axis : {"y", "n"})
                for (auto& [name, value] : v["polynomial"][axis].items()) value = changed(value);
        }
        if (v.contains("wind")) {
            for (const char* key : {"length", "centre", "height"}) scale(v["wind"], key, 1.0);
            for (const char* key : {"frontal_area", "lateral_area"}) scale(v["wind"], key, 2.0);
        }
        if (v.contains("propulsors"))
            for (Json& p : v["propulsors"]) propulsor(p);
        if (v.contains("rudders"))
            for (Json& r : v["rudders"]) {
                scale(r, "point", 1.0);
                scale(r, "area", 2.0);
                scale(r, "rate_deg", -0.5);
            }
        if (v.contains("power")) {
            for (Json& b : v["power"]["boards"])
                for (Json& g : b["generators"]) scale(g, "power", 3.5);
            for (Json& c : v["power"]["consumers"]) scale(c, "power", 3.5);
        }
        return v;
    }
    void resistance(Json& r) {
        scale(r, "linear", 2.5);
        scale(r, "quadratic", 2.0);
        if (!r.contains("curve")) return;
        for (Json& point : r["curve"]) point = {scaled(point[0], 0.5), scaled(point[1], 3.0)};
    }
    void propulsor(Json& p) {
        for (const char* key : {"point", "diameter"}) scale(p, key, 1.0);
        scale(p, "thrust", 3.0);
        scale(p, "most_rps", -0.5);
        scale(p, "shaft_inertia", 5.0);
        scale(p, "most_power", 3.5);
        for (const char* key : {"ramp", "pitch_time", "lost_at"}) scale(p, key, 0.5);
        scale(p, "turn_rate_deg", -0.5);
        if (p.contains("propeller")) scale(p["propeller"], "diameter", 1.0);
    }

    Json sea_of(const std::string& part, const Json& vessel, const Json& body) {
        Json hull{{"body", "hull"}, {"scale", s_}};
        hull["mesh"] = mesh(root_ + "/scenes/parts/" + part + ".obj");
        hull["offset"] = vessel["origin"];
        const double mass = body["mass"].get<double>();
        // Strip theory gives the order of magnitude; damping is a fifth of the critical one at 1
        // rad/s.
        Json added = Json::array({0, 0, mass * between(0.7, 1.5)});
        for (const std::size_t i : {0, 1})
            added.push_back(body["inertia"][i].get<double>() * between(0.2, 1.0));
        added.push_back(0);
        Json damping = Json::array({0, 0});
        for (const std::size_t i : {2, 3, 4})
            damping.push_back((i == 2 ? mass : body["inertia"][i - 3].get<double>()) *
                              between(0.2, 0.6) / std::sqrt(s_));
        damping.push_back(0);
        hull["added_mass"] = added;
        hull["damping"] = damping;
        Json sea{{"depth", 300}, {"density", 1025.0}};
        const double height = between(0.0, 6.0);
        // A peak period with the steepness of seas of this height.
        if (height > 0.1)
            sea["waves"] = Json::array({{{"kind", "jonswap"},
                                         {"height", height},
                                         {"period", std::sqrt(height) * between(4.0, 5.0) + 2.0},
                                         {"components", 30},
                                         {"seed", static_cast<int>(between(1.0, 1e6))},
                                         {"direction_deg", between(0.0, 360.0)}}});
        sea["current"] = Json::array(
            {{{"depth", 0}, {"speed", between(0.0, 1.2)}, {"direction_deg", between(0.0, 360.0)}}});
        sea["wind"] = {{"speed", 4.0 * std::sqrt(height + 0.1)},
                       {"direction_deg", between(0.0, 360.0)}};
        sea["hulls"] = Json::array({hull});
        return sea;
    }
    static Json mesh(const std::string& file) {
        Json out{{"vertices", Json::array()}, {"triangles", Json::array()}};
        std::ifstream in(file);
        std::string kind;
        double a = 0.0, b = 0.0, c = 0.0;
        while (in >> kind) {
            if (kind != "v" && kind != "f") {
                std::getline(in, kind);
                continue;
            }
            in >> a >> b >> c;
            if (kind == "v")
                out["vertices"].push_back({a, b, c});
            else
                out["triangles"].push_back(
                    {std::lround(a) - 1, std::lround(b) - 1, std::lround(c) - 1});
        }
        return out;
    }

    /// Make orders on each input of a vessel, from its definition.
    Json timeline_of(const Json& v, double duration) {
        struct Input {
            std::string name;
            double least = 0.0, most = 1.0;
        };
        std::vector<Input> inputs;
        const auto list = [&](const char* key) { return v.contains(key) ? v[key] : Json::array(); };
        for (const Json& p : list("propulsors")) {
            const std::string name = p["name"];
            inputs.push_back({name, -1.0, 1.0});
            if (p.value("kind", "shaft") == "azimuth")
                inputs.push_back({name + "_angle", -6.0, 6.0});
            if (p.value("controllable", false)) inputs.push_back({name + "_pitch", -1.0, 1.0});
            inputs.push_back({name + "_failed", 0.0, 3.0});
        }
        for (const Json& r : list("rudders")) {
            inputs.push_back({r["name"], -0.6, 0.6});
            inputs.push_back({r["name"].get<std::string>() + "_failed", 0.0, 3.0});
        }
        if (v.contains("power")) {
            inputs.push_back({"tie", 0.0, 1.0});
            for (const Json& b : v["power"]["boards"])
                for (const Json& g : b["generators"])
                    inputs.push_back({g["name"].get<std::string>() + "_failed", 0.0, 1.0});
        }
        Json out = Json::array();
        if (inputs.empty()) return out;
        for (double at = 0.0; at < duration; at += between(0.5, 5.0)) {
            const Input& one =
                inputs[static_cast<std::size_t>(unit() * static_cast<double>(inputs.size()))];
            const bool failure = one.name.ends_with("_failed");
            // Failures are rare and are repaired.
            const double value = failure && unit() < 0.7 ? 0.0 : between(one.least, one.most);
            out.push_back({{"at", at}, {"set", {{"ship." + one.name, value}}}});
        }
        return out;
    }

    std::uint64_t state_;
    std::string root_;
    double s_ = 1.0;
};

}  // namespace hawser::test
