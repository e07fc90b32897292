// SPDX-License-Identifier: Apache-2.0
#include "random_passive_cases.h"

#include "dice.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::bench {
namespace {

using PassiveJson = nlohmann::ordered_json;

constexpr std::array<double, 3> kPassiveSteps{1.0 / 60.0, 1.0 / 30.0, 0.05};
constexpr double kPassiveDuration = 6.0;

PassiveJson triple(double x, double y, double z) { return PassiveJson::array({x, y, z}); }
PassiveJson triple(const Vec3& x) { return triple(x.x(), x.y(), x.z()); }

/// Base of the generators: document, random numbers, line type.
class PassiveMaker {
  public:
    PassiveMaker(GearFamily family, std::uint64_t seed, std::uint64_t number)
        : dice_(seed, number), step_(kPassiveSteps[number % kPassiveSteps.size()]) {
        doc_ = {{"version", 1}, {"name", fmt::format("{}_{}_{}", to_string(family), seed, number)}};
        doc_["settings"] = {{"duration", kPassiveDuration}, {"step", step_}};
        doc_["bodies"] = PassiveJson::array();
        doc_["cables"] = PassiveJson::array();
        doc_["outputs"] = PassiveJson::array();
    }

  protected:
    /// Draw a wire rope (4,500 d² kg/m) or a chain (20,000 d² kg/m). @return its mass per length.
    double add_line_type(bool bends) {
        const double diameter = dice_.spread(0.02, 0.12), square = diameter * diameter;
        const double mass = (dice_.chance(0.6) ? 4500.0 : 20000.0) * square;
        PassiveJson type{{"mass_per_length", mass},
                         {"EA", (dice_.chance(0.7) ? 8e10 : 4e10) * square},
                         {"diameter", diameter}};
        if (dice_.chance(0.5))
            type["axial_damping"] = std::array<double, 4>{0.0, 0.1, 0.5, 2.0}[pick(4)];
        if (dice_.chance(0.25)) type["drag"] = mass * dice_.from(0.1, 0.5);
        if (bends && dice_.chance(0.25))
            type["EI"] = 1.5e9 * square * square * dice_.from(0.3, 1.0);
        if (dice_.chance(0.25)) type["submerged_factor"] = dice_.from(0.8, 0.9);
        doc_["line_types"]["w"] = type;
        return mass;
    }
    std::size_t pick(int count) { return static_cast<std::size_t>(dice_.number(0, count - 1)); }
    void probe(const char* body, const char* component, double length) {
        const std::string name = fmt::format("{}_{}", body, component);
        doc_["outputs"].push_back(
            {{"name", name}, {"kind", "pose"}, {"body", body}, {"component", component}});
        // Snap loads and whips over a bollard are not resolved: the path is that of a coarse run.
        result_.probes.push_back({name, 0.05 * length, 0.25, false});
    }
    GearCase finish() {
        result_.step = step_;
        result_.duration = kPassiveDuration;
        result_.passive = true;
        result_.text = doc_.dump(1);
        return std::move(result_);
    }

    Dice dice_;
    double step_;
    PassiveJson doc_;
    GearCase result_;
};

/// A wire between two masses that falls on one to three bollards.
class PassivePosts : public PassiveMaker {
  public:
    using PassiveMaker::PassiveMaker;
    GearCase make() {
        const double mass = add_line_type(false);
        const double half = dice_.from(4.0, 10.0), element = dice_.from(0.7, 1.3);
        const double length = 2.0 * half * dice_.from(1.0, 1.02);
        const double first = mass * length * dice_.spread(0.5, 30.0);
        doc_["bodies"].push_back({{"name", "q"}, {"kind", "fixed"}});
        double top = 0.0, x = dice_.from(-1.0, 1.0);
        doc_["posts"] = PassiveJson::array();
        const int posts = dice_.number(1, 3);
        for (int i = 0; i < posts; ++i) {
            const double radius = dice_.from(0.15, 0.5);
            doc_["posts"].push_back({{"name", fmt::format("p{}", i)},
                                     {"on", "q"},
                                     {"from", triple(x, -6, 1.5)},
                                     {"to", triple(x, 6, 1.5)},
                                     {"radius", radius},
                                     {"friction", dice_.from(0.0, 0.4)}});
            top = std::max(top, 1.5 + radius);
            x += (x > 0.0 ? -1.0 : 1.0) * dice_.from(2.0, 0.4 * half + 2.0);
        }
        const double height = top + dice_.from(0.1, 1.0);
        const double left = -half + dice_.from(-0.5, 0.5);
        mass_point("a", triple(left, dice_.from(-1.0, 1.0), height), first);
        mass_point("b", triple(left + 2.0 * half, dice_.from(-1.0, 1.0), height),
                   first * dice_.from(0.7, 1.3));
        if (dice_.chance(0.7))
            doc_["bodies"].back()["velocity"] = triple(0.0, dice_.from(-1.0, 1.0), 0.0);
        const PassiveJson &a = doc_["bodies"][1]["position"], &b = doc_["bodies"][2]["position"];
        const double chord = Vec3(b[0].get<double>() - a[0].get<double>(),
                                  b[1].get<double>() - a[1].get<double>(), 0.0)
                                 .norm();
        doc_["cables"].push_back({{"name", "w"},
                                  {"line_type", "w"},
                                  {"elements", std::max(6, int(length / element))},
                                  {"length", std::max(length, 1.002 * chord)},
                                  {"from", {{"body", "a"}}},
                                  {"to", {{"body", "b"}}},
                                  {"consistent_mass", true},
                                  {"contact", PassiveJson::object()}});
        for (const char* body : {"a", "b"})
            for (const char* component : {"x", "z"}) probe(body, component, length);
        return finish();
    }

  private:
    void mass_point(const char* name, const PassiveJson& at, double mass) {
        doc_["bodies"].push_back(
            {{"name", name}, {"kind", "lump"}, {"position", at}, {"mass", mass}});
    }
};

/// A wire from a mass on a table over a roller to a mass that hangs.
class PassiveGuides : public PassiveMaker {
  public:
    using PassiveMaker::PassiveMaker;
    GearCase make() {
        const double mass = add_line_type(false);
        const double element = dice_.from(0.9, 3.0);
        const double radius = dice_.spread(0.05, std::min(0.8, 0.45 * element));
        const int lying = dice_.number(4, 8), hanging = dice_.number(3, 7);
        // The element on the roller has the straight parts `beside`, and a quarter of the circle.
        const double beside = 0.5 * (element - 1.5707963 * radius);
        const double out = beside + lying * element, down = beside + hanging * element;
        const double length = (lying + hanging + 1) * element * dice_.from(1.0, 1.005);
        const double first = mass * length * dice_.spread(0.3, 100.0);
        doc_["bodies"].push_back({{"name", "q"}, {"kind", "fixed"}});
        doc_["bodies"].push_back(
            {{"name", "a"},
             {"kind", "lump"},
             {"position", triple(-out, 0, radius)},
             {"mass", first},
             {"shapes", PassiveJson::array({{{"kind", "sphere"}, {"radius", 0.5 * radius}}})}});
        doc_["bodies"].push_back({{"name", "b"},
                                  {"kind", "lump"},
                                  {"position", triple(radius, 0, -down)},
                                  {"mass", first * dice_.from(0.7, 1.3)}});
        doc_["bodies"].push_back(
            {{"name", "table"},
             {"kind", "fixed"},
             {"position", triple(-1001, 0, 0.5 * radius - 1.0)},
             {"box", triple(1000, 5, 1)},
             {"shapes",
              PassiveJson::array({{{"kind", "box"}, {"half_size", triple(1000, 5, 1)}}})}});
        const int elements = lying + hanging + 1;
        PassiveJson shape = PassiveJson::array();
        for (int i = 1; i < elements; ++i)
            shape.push_back(i <= lying ? triple(-out + i * element, 0, radius)
                                       : triple(radius, 0, -beside - (i - lying - 1) * element));
        doc_["cables"].push_back({{"name", "w"},
                                  {"line_type", "w"},
                                  {"elements", elements},
                                  {"length", length},
                                  {"from", {{"body", "a"}}},
                                  {"to", {{"body", "b"}}},
                                  {"shape", shape},
                                  {"consistent_mass", true}});
        PassiveJson guide{{"name", "r"},
                          {"cable", "w"},
                          {"on", "q"},
                          {"point", triple(0, 0, 0)},
                          {"axis", triple(0, 1, 0)},
                          {"radius", radius},
                          {"element", element}};
        if (dice_.chance(0.5))
            guide["friction"] = dice_.from(0.0, 0.3);
        else
            guide["efficiency"] = dice_.from(0.9, 1.0);
        doc_["guides"] = PassiveJson::array({guide});
        probe("a", "x", length);
        for (const char* component : {"x", "z"}) probe("b", component, length);
        return finish();
    }
};

/// A box on a wire from a fixed point, taut or slack at the start.
class PassiveHanging : public PassiveMaker {
  public:
    using PassiveMaker::PassiveMaker;
    GearCase make() {
        const double mass = add_line_type(true);
        const double length = dice_.spread(15.0, 150.0);
        const bool slack = dice_.chance(0.5);
        const double distance = length * (slack ? dice_.from(0.5, 0.95) : dice_.from(0.98, 1.0));
        const double load = mass * length * dice_.spread(1.0, 30.0);
        const double size = 0.5 * std::cbrt(load / 2000.0);
        const double angle = dice_.from(0.0, 1.2), about = dice_.from(0.0, 6.28);
        const Vec3 at = distance * Vec3(std::sin(angle) * std::cos(about),
                                        std::sin(angle) * std::sin(about), -std::cos(angle));
        doc_["bodies"].push_back({{"name", "m"},
                                  {"position", triple(at - size * Vec3::UnitZ())},
                                  {"mass", load},
                                  {"box", triple(size, size, size)},
                                  {"velocity", triple(dice_.vector(1.5))},
                                  {"angular_velocity", triple(dice_.vector(0.5))}});
        doc_["cables"].push_back({{"name", "w"},
                                  {"line_type", "w"},
                                  {"elements", dice_.number(10, 45)},
                                  {"length", length},
                                  {"from", {{"at", triple(0, 0, 0)}}},
                                  {"to", {{"body", "m"}, {"point", triple(0, 0, size)}}},
                                  {"shape", dice_.chance(0.5) ? "straight" : "hanging"}});
        for (const char* component : {"x", "y", "z"}) probe("m", component, length);
        return finish();
    }
};

}  // namespace

bool is_passive(GearFamily family) noexcept {
    return family == GearFamily::passive_posts || family == GearFamily::passive_guides ||
           family == GearFamily::passive_hanging;
}

GearCase make_passive_case(GearFamily family, std::uint64_t seed, std::uint64_t number) {
    if (family == GearFamily::passive_posts) return PassivePosts(family, seed, number).make();
    if (family == GearFamily::passive_guides) return PassiveGuides(family, seed, number).make();
    return PassiveHanging(family, seed, number).make();
}

}  // namespace hawser::bench
