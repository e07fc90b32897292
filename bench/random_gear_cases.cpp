// SPDX-License-Identifier: Apache-2.0
#include "random_gear_cases.h"

#include "dice.h"
#include "random_passive_cases.h"
#include "support/random_ships.h"

#include <hawser/math.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hawser::bench {
namespace {

using GearJson = nlohmann::ordered_json;

constexpr double kGearGravity = 9.81;
constexpr double kPlace = 0.01;  ///< tolerance of positions over the length of the wire
constexpr std::array<std::string_view, 7> kFamilies{
    "winches", "guides", "hulls", "ships", "passive_posts", "passive_guides", "passive_hanging"};

GearJson point(double x, double y, double z) { return GearJson::array({x, y, z}); }

/// Steel wire rope of diameter d [m]: mass, stiffness and breaking load are proportional to d².
struct Rope {
    double diameter = 0.0;
    [[nodiscard]] double mass() const { return 3600.0 * diameter * diameter; }   // [kg/m]
    [[nodiscard]] double EA() const { return 4e10 * diameter * diameter; }       // [N]
    [[nodiscard]] double breaking() const { return 7e8 * diameter * diameter; }  // [N]
};

/// Base of the three generators: the document and the random numbers.
class GearMaker {
  public:
    GearMaker(std::string_view family, std::uint64_t seed, std::uint64_t number)
        : dice_(seed, number) {
        doc_ = {{"version", 2}, {"name", fmt::format("{}_{}_{}", family, seed, number)}};
        doc_["settings"] = GearJson::object();
        doc_["bodies"] = GearJson::array();
        doc_["cables"] = GearJson::array();
    }

  protected:
    GearCase finish(double step, double duration) {
        result_.step = step;
        result_.duration = duration;
        doc_["settings"] = {{"step", step}, {"duration", duration}};
        doc_["outputs"] = std::exchange(outputs_, GearJson::array());
        result_.text = doc_.dump(1);
        return std::move(result_);
    }
    void probe_position(const std::string& body, const char* component, double absolute) {
        const std::string name = body + "_" + component;
        outputs_.push_back(
            {{"name", name}, {"kind", "pose"}, {"body", body}, {"component", component}});
        result_.probes.push_back({name, absolute, 0.05, false});
    }
    void probe_tension(const std::string& cable, const char* component, double absolute) {
        const std::string name = cable + "_tension";
        outputs_.push_back(
            {{"name", name}, {"kind", "tension"}, {"cable", cable}, {"component", component}});
        result_.probes.push_back({name, absolute, 0.1, true});
    }

    Dice dice_;
    GearJson doc_;
    GearJson outputs_ = GearJson::array();
    GearCase result_;
};

/// A winch on the first end of the cable "wire", sized for a typical tension.
struct WinchSizes {
    double core = 0.0, width = 0.0, stored = 0.0, outer = 0.0, pull = 0.0, power = 0.0;
};

class WinchMaker : public GearMaker {
  public:
    using GearMaker::GearMaker;

  protected:
    WinchSizes choose_winch(const Rope& rope, double pull) {
        WinchSizes w;
        w.pull = pull;
        w.core = rope.diameter * dice_.from(8.0, 16.0);
        w.width = rope.diameter * dice_.from(12.0, 40.0);
        w.stored = dice_.from(60.0, 400.0);
        // Cross-section of the wire on the drum: stored d² = π (outer² − core²) width.
        w.outer = std::sqrt(w.core * w.core + w.stored * rope.diameter * rope.diameter /
                                                  (std::numbers::pi * w.width));
        w.power = dice_.chance(0.5) ? pull * dice_.spread(0.1, 2.0) : 0.0;
        return w;
    }

    /// Add a winch. @param length  Length of the wire outside [m]. @param moving  Mass that the
    /// wire moves [kg].
    void add_winch(const WinchSizes& w, double length, double moving) {
        GearJson winch{{"name", "winch"},
                       {"cable", "wire"},
                       {"core_radius", w.core},
                       {"width", w.width},
                       {"stored", w.stored},
                       {"inertia", moving * w.core * w.core * dice_.spread(0.05, 1.0)},
                       {"torque_haul", w.pull * w.outer * dice_.from(1.3, 4.0)},
                       {"torque_pay", w.pull * w.outer * dice_.from(1.3, 4.0)},
                       {"brake_static", w.pull * w.outer * dice_.from(1.5, 4.0)}};
        if (w.power > 0.0) winch["power"] = result_.motor_power = w.power;
        if (dice_.chance(0.3)) {
            winch["band_friction"] = dice_.from(0.2, 0.4);
            winch["band_angle"] = dice_.from(3.0, 5.0);
        }
        winch.update(order());
        doc_["winches"] = GearJson::array({winch});
        probe_signal("winch.wire_left", kPlace * length);
    }

    /// Make the cable "wire", so short that it carries the pull over a distance of `length` [m].
    GearJson taut_wire(const Rope& rope, double length, int elements) {
        return {{"name", "wire"},
                {"elements", elements},
                {"line_type",
                 {{"mass_per_length", rope.mass()},
                  {"EA", rope.EA()},
                  {"diameter", rope.diameter},
                  {"breaking_load", rope.breaking()},
                  // The default would change with the step, and with it the motion.
                  {"axial_damping", dice_.from(3.0, 10.0)}}},
                {"length", length / (1.0 + pull_ / rope.EA())},
                {"consistent_mass", true}};
    }

    void probe_signal(const std::string& name, double absolute) {
        result_.probes.push_back({name, absolute, 0.05, false});
    }

    /// Draw mode and set points, for tensions around the pull.
    GearJson order() {
        const double choice = dice_.from(0.0, 1.0);
        if (choice < 0.4) return {{"mode", "speed"}, {"speed", dice_.from(-1.0, 1.0)}};
        if (choice < 0.6)
            return {{"mode", "tension"},
                    {"tension", pull_ * dice_.from(0.9, 1.1)},
                    {"max_speed", dice_.from(0.3, 1.5)}};
        if (choice < 0.8)
            return {{"mode", "render"},
                    {"tension", pull_ * dice_.from(0.9, 1.1)},
                    {"deadband", pull_ * dice_.from(0.05, 0.3)},
                    {"max_speed", dice_.from(0.3, 1.5)}};
        return {{"mode", "brake"}};
    }

    /// Change the orders at random times; "max_speed" is no signal.
    void add_orders(double duration) {
        GearJson timeline = GearJson::array();
        double at = 0.0;
        for (int left = dice_.number(1, 4); left > 0; --left) {
            at += dice_.from(0.5, 3.0);
            if (at > duration - 1.0) break;
            GearJson set = GearJson::object();
            const GearJson chosen = order();
            for (auto it = chosen.begin(); it != chosen.end(); ++it)
                if (it.key() != "max_speed" && it.key() != "deadband")
                    set["winch." + it.key()] = *it;
            timeline.push_back({{"at", at}, {"set", set}});
        }
        if (!timeline.empty()) doc_["timeline"] = timeline;
    }

    double pull_ = 1.0;  ///< Typical tension [N].
};

/// A load on a hanging wire, or a float on a taut one.
class Winches : public WinchMaker {
  public:
    using WinchMaker::WinchMaker;
    GearCase make() {
        const double step = dice_.spread(1.0 / 240.0, 1.0 / 20.0);
        const Rope rope{dice_.spread(0.016, 0.08)};
        pull_ = rope.breaking() * dice_.spread(0.03, 0.2);
        const bool hangs = dice_.chance(0.6);
        const double length = dice_.from(15.0, 60.0);
        const double mass = pull_ / kGearGravity * (hangs ? 1.0 : dice_.from(1.0, 5.0));
        doc_["bodies"].push_back(
            {{"name", "deck"}, {"kind", "fixed"}, {"position", point(0, 0, 0)}});
        const double size = std::cbrt(mass / 4000.0);
        GearJson load{
            {"name", "load"},
            {"mass", mass},
            {"box", point(size, size, size)},
            {"position", hangs ? point(0, 0, -length - size) : point(length + size, 0, 0)}};
        // Damped within seconds: with orders by tension, speeds due to snap loads would persist.
        load["linear_damping"] = mass * dice_.spread(0.3, 3.0);
        if (!hangs) {
            load["gravity"] = false;
            load["force"] = point(pull_, 0, 0);
        }
        doc_["bodies"].push_back(load);
        GearJson wire = taut_wire(rope, length, std::max(4, int(length / dice_.from(1.5, 5.0))));
        wire["shape"] = "straight";
        wire["from"] = {{"body", "deck"}, {"point", point(0, 0, 0)}};
        wire["to"] = {{"body", "load"}, {"point", hangs ? point(0, 0, size) : point(-size, 0, 0)}};
        doc_["cables"].push_back(wire);
        const double duration = 8.0;
        add_winch(choose_winch(rope, pull_), length, mass);
        add_orders(duration);
        probe_position("load", hangs ? "z" : "x", kPlace * length);
        probe_tension("wire", "last", 0.02 * pull_);
        return finish(step, duration);
    }
};

/// A wire from a winch over or under a roller to a float that a force pulls away.
class Guides : public WinchMaker {
  public:
    using WinchMaker::WinchMaker;
    GearCase make() {
        const double step = dice_.spread(1.0 / 240.0, 1.0 / 20.0);
        const Rope rope{dice_.spread(0.016, 0.08)};
        pull_ = rope.breaking() * dice_.spread(0.03, 0.2);
        const double side = dice_.chance(0.5) ? 1.0 : -1.0;  // over or under
        const double radius = rope.diameter * dice_.from(4.0, 12.0);
        // Both parts leave the top of the wheel downwards (the bottom: upwards) at these angles.
        const double left_angle = dice_.from(0.05, 1.2), right_angle = dice_.from(0.05, 1.2);
        constexpr double kDuration = 8.0;
        // A fifth of the wires is hauled until the end is at the roller.
        const bool to_end = dice_.chance(0.2);
        const double speed = dice_.from(0.3, 1.2), way = speed * kDuration * dice_.from(0.4, 0.9);
        const double left = dice_.from(8.0, 25.0), right = to_end ? way : dice_.from(8.0, 40.0);
        const double mass = pull_ / kGearGravity * dice_.from(1.0, 5.0);
        const double size = std::cbrt(mass / 4000.0);
        const Vec3 out(std::cos(right_angle), 0.0, -side * std::sin(right_angle));
        const Vec3 back(-std::cos(left_angle), 0.0, -side * std::sin(left_angle));
        // Tangent points of the parts on the wheel about the origin.
        const Vec3 on_left = radius * Vec3(-std::sin(left_angle), 0.0, side * std::cos(left_angle));
        const Vec3 on_right =
            radius * Vec3(std::sin(right_angle), 0.0, side * std::cos(right_angle));
        const Vec3 start = on_left + left * back, end = on_right + right * out;
        const Vec3 centre = end + size * out;
        doc_["bodies"].push_back({{"name", "deck"}, {"kind", "fixed"}});
        doc_["bodies"].push_back({{"name", "float"},
                                  {"mass", mass},
                                  {"box", point(size, size, size)},
                                  {"position", point(centre.x(), 0, centre.z())},
                                  {"gravity", false},
                                  {"linear_damping", mass * dice_.spread(0.3, 3.0)},
                                  {"force", point(pull_ * out.x(), 0, pull_ * out.z())}});
        const double length =
            left + right + 2.0 * radius * std::tan(0.5 * (left_angle + right_angle));
        GearJson wire = taut_wire(rope, length, std::max(6, int(length / dice_.from(1.5, 4.0))));
        wire["shape"] = "path";
        // Corner at which both parts meet, outside the wheel: at most 69° between them and the top.
        const double middle = 0.5 * (right_angle - left_angle),
                     half = 0.5 * (left_angle + right_angle);
        const double corner = radius / std::cos(half);
        wire["path"] = GearJson::array(
            {point(corner * std::sin(middle), 0, side * corner * std::cos(middle))});
        wire["from"] = {{"body", "deck"}, {"point", point(start.x(), 0, start.z())}};
        wire["to"] = {{"body", "float"},
                      {"point", point(end.x() - centre.x(), 0, end.z() - centre.z())}};
        doc_["cables"].push_back(wire);
        add_roller(side * radius);
        add_winch(choose_winch(rope, pull_), length, mass);
        if (to_end)
            haul_to_the_end(speed);
        else
            add_orders(kDuration);
        probe_position("float", "x", kPlace * length);
        probe_position("float", "z", kPlace * length);
        // A float at the roller bounces there.
        probe_tension("wire", "last", (to_end ? 1.0 : 0.02) * pull_);
        return finish(step, kDuration);
    }

  private:
    void add_roller(double radius) {
        doc_["guides"] =
            GearJson::array({{{"name", "roller"},
                              {"cable", "wire"},
                              {"on", "deck"},
                              {"point", point(0, 0, 0)},
                              {"axis", point(0, 1, 0)},
                              {"radius", radius},
                              {"friction", dice_.chance(0.7) ? dice_.from(0.0, 0.4) : 0.0}}});
    }

    /// Haul at a moderate speed at which the wire's end reaches the roller before the end of the
    /// run.
    void haul_to_the_end(double speed) {
        GearJson& winch = doc_["winches"][0];
        winch["mode"] = "speed";
        winch["speed"] = -speed;
        winch.erase("power");
        result_.motor_power = 1e300;
    }
};

/// A barge on chains that reach the seabed.
class Hulls : public GearMaker {
  public:
    using GearMaker::GearMaker;
    GearCase make() {
        const double step = dice_.spread(1.0 / 240.0, 1.0 / 20.0);
        const double length = dice_.spread(25.0, 120.0), beam = length * dice_.from(0.2, 0.4),
                     draught = beam * dice_.from(0.08, 0.2), depth = dice_.spread(20.0, 100.0);
        const double bar = length * dice_.from(4e-4, 9e-4);  // of the chain [m]
        constexpr double kWater = 1025.0, kSteel = 7850.0;
        const double mass = kWater * length * beam * draught;
        const double chain = 19900.0 * bar * bar;  // studless chain [kg/m]
        const double weight = kGearGravity * chain * (1.0 - kWater / kSteel);
        doc_["line_types"]["chain"] = {{"mass_per_length", chain},
                                       {"EA", 8.54e10 * bar * bar},
                                       {"diameter", bar},
                                       {"breaking_load", 9e8 * bar * bar},
                                       {"cd_normal", 2.4},
                                       {"cd_tangential", 1.15},
                                       {"displaced_area", chain / kSteel}};
        doc_["materials"] = {{"sand", GearJson::object()}, {"chain", GearJson::object()}};
        doc_["material_pairs"] = GearJson::array({{{"between", {"chain", "sand"}},
                                                   {"friction", dice_.from(0.3, 1.0)},
                                                   {"stiffness", 2e5}}});
        doc_["bodies"].push_back({{"name", "bottom"},
                                  {"kind", "fixed"},
                                  {"position", point(0, 0, -depth)},
                                  {"shapes", {{{"kind", "plane"}, {"material", "sand"}}}}});
        doc_["bodies"].push_back(
            {{"name", "barge"}, {"mass", mass}, {"box", point(0.5 * length, 0.5 * beam, draught)}});
        const int lines = dice_.number(2, 4);
        const double tension = weight * depth * dice_.spread(0.7, 4.0);  // horizontal
        // Catenary from the seabed to the fairlead at the water line.
        const double hangs = std::sqrt(depth * depth + 2.0 * depth * tension / weight);
        const double reach = tension / weight * std::asinh(hangs * weight / tension);
        for (int i = 0; i < lines; ++i) {
            const double lies = dice_.from(0.3, 1.5) * depth;
            const double x = (i % 2 == 0 ? 0.5 : -0.5) * length;
            const double y = lines == 2 ? 0.0 : (i < 2 ? 0.5 : -0.5) * beam;
            const double turn = (lines == 2 ? 0.0 : (i < 2 ? 1.0 : -1.0) * dice_.from(0.3, 1.1));
            const double away = reach + lies;
            const double ax = x + (x > 0 ? 1.0 : -1.0) * away * std::cos(turn),
                         ay = y + away * std::sin(turn);
            const std::string name = fmt::format("chain{}", i);
            doc_["cables"].push_back({{"name", name},
                                      {"line_type", "chain"},
                                      {"length", hangs + lies},
                                      {"elements", dice_.number(12, 30)},
                                      {"shape", "hanging"},
                                      {"seabed", {{"height", -depth}, {"friction", 0.6}}},
                                      {"contact", {{"material", "chain"}}},
                                      {"from", {{"body", "barge"}, {"point", point(x, y, 0)}}},
                                      {"to", {{"at", point(ax, ay, -depth + 0.5 * bar + 0.002)}}}});
            probe_tension(name, "first", 0.02 * tension);
        }
        add_sea(length, beam, draught, depth, mass);
        probe_position("barge", "x", 0.05);
        probe_position("barge", "z", 0.02 * draught);
        probe_position("barge", "pitch", 0.002);
        return finish(step, 10.0);
    }

  private:
    void add_sea(double length, double beam, double draught, double depth, double mass) {
        GearJson sea{{"depth", depth}};
        const double choice = dice_.from(0.0, 1.0);
        if (choice > 0.4) {
            const double period = dice_.from(6.0, 15.0);
            sea["waves"] = GearJson::array({{{"kind", choice > 0.7 ? "jonswap" : "regular"},
                                             {"height", dice_.from(0.3, 2.0)},
                                             {"period", period},
                                             {"direction_deg", dice_.from(0.0, 360.0)}}});
        }
        if (dice_.chance(0.5))
            sea["current"] = GearJson::array(
                {{{"depth", 0}, {"speed", dice_.from(0.1, 1.0)}, {"direction_deg", 180}},
                 {{"depth", depth}, {"speed", 0}, {"direction_deg", 180}}});
        // Added mass and damping of a box, of the size that strip theory gives.
        const double l2 = length * length, b2 = beam * beam;
        const double heave = mass * dice_.from(0.7, 1.5), rate = dice_.from(0.2, 0.6);
        const GearJson added = GearJson::array({0.05 * mass, 0.5 * mass, heave, heave * b2 / 14.0,
                                                heave * l2 / 14.0, 0.04 * mass * l2});
        const GearJson damping =
            GearJson::array({0.03 * mass, 0.1 * mass, rate * mass, 0.1 * rate * mass * b2 / 12.0,
                             rate * mass * l2 / 12.0, 0.01 * mass * l2});
        sea["hulls"] = GearJson::array(
            {{{"body", "barge"},
              {"mesh", {{"box", point(0.5 * length, 0.5 * beam, draught)}, {"pieces", {8, 4, 2}}}},
              {"drag_area", point(beam * draught, length * draught, length * beam)},
              {"added_mass", added},
              {"damping", damping}}});
        doc_["sea"] = sea;
    }
};

/// Make a case with a vessel of the library under random orders.
GearCase make_ship_case(std::uint64_t seed, std::uint64_t number) {
    GearCase out;
    out.step = 1.0 / 60.0;
    out.duration = 30.0;
    test::ShipMaker maker(seed * 1'000'003u + number, ".");
    out.text = maker.scene(number, out.duration, true);
    // Motions in waves and under way: half a metre, and a degree.
    for (const char* name : {"hull_x", "hull_y"}) out.probes.push_back({name, 0.5, 0.05, false});
    out.probes.push_back({"hull_z", 0.1, 0.05, false});
    for (const char* name : {"hull_roll", "hull_pitch"})
        out.probes.push_back({name, 0.02, 0.05, false});
    return out;
}

}  // namespace

std::string_view to_string(GearFamily family) noexcept {
    return kFamilies[static_cast<std::size_t>(family)];
}

std::optional<GearFamily> gear_family(std::string_view name) noexcept {
    for (std::size_t i = 0; i < kFamilies.size(); ++i)
        if (kFamilies[i] == name) return static_cast<GearFamily>(i);
    return std::nullopt;
}

GearCase make_gear_case(GearFamily family, std::uint64_t seed, std::uint64_t number) {
    if (is_passive(family)) return make_passive_case(family, seed, number);
    const std::string_view name = to_string(family);
    if (family == GearFamily::winches) return Winches(name, seed, number).make();
    if (family == GearFamily::guides) return Guides(name, seed, number).make();
    if (family == GearFamily::ships) return make_ship_case(seed, number);
    return Hulls(name, seed, number).make();
}

}  // namespace hawser::bench
