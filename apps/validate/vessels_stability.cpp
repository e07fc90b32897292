// SPDX-License-Identifier: Apache-2.0
// Static heel of a box-shaped ship by a wire, capsize beyond its largest lever, and the gauge.
#include <hawser/sea.h>
#include <hawser/stability.h>

#include "validate/tools.h"
#include "validate/vessels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace hawser::validate {
namespace {

constexpr double kHeelStep = 1.0 / 60.0, kHeelDegree = kPi / 180.0;
// A box of 80 x 18 x 8 m with a draught of 5 m and its centre of mass 6 m above the keel.
constexpr double kHeelBeam = 18.0, kHeelDepth = 8.0, kHeelDraught = 5.0, kHeelKg = 6.0,
                 kHeelLong = 80.0;
constexpr double kShipMass = 1025.0 * kHeelLong * kHeelBeam * kHeelDraught;
constexpr double kUpperWire = 3.0, kLowerWire = -4.0;  ///< z of the wires at the ship [m].

/// A ship between two buoys that pull abeam, the upper wire to starboard, the lower one to port.
struct Heeled {
    World w{WorldDef{.step = kHeelStep}};
    BodyId ship{}, buoy[2]{};
    WireId wire[2]{};

    Heeled() {
        constexpr double kFar = 500.0;
        ship = w.add_body({.name = "ship",
                           .position = {0, 0, kHeelKg - kHeelDraught},
                           .mass = kShipMass,
                           .inertia = Vec3(40.0, 550.0, 550.0).asDiagonal() * kShipMass});
        for (int k = 0; k < 2; ++k) {
            const double z = k == 0 ? kUpperWire : kLowerWire, side = k == 0 ? -1.0 : 1.0;
            buoy[k] = w.add_body({.name = k == 0 ? "upper" : "lower",
                                  .kind = BodyKind::lump,
                                  .position = {0, side * kFar, z + kHeelKg - kHeelDraught},
                                  .mass = 1e5,
                                  .linear_damping = Vec3::Constant(1e5),
                                  .gravity = false});
            wire[k] = w.wires().add({.name = k == 0 ? "tow" : "hold",
                                     .from = ship,
                                     .from_point = {0, 0, z},
                                     .to = buoy[k],
                                     .elements = 1,
                                     .length = kFar,
                                     .EA = 1e9,
                                     .mass_per_length = 1.0});
        }
        HullMesh mesh = box_hull({0.5 * kHeelLong, 0.5 * kHeelBeam, 0.5 * kHeelDepth});
        for (Vec3& v : mesh.vertices) v.z() += 0.5 * kHeelDepth - kHeelKg;
        SeaDef sea{.depth = 200.0};
        sea.hulls.push_back(
            {.body = ship, .mesh = mesh, .damping = {1e6, 1e6, 5e6, 1e8, 1e9, 1e9}});
        w.add(sea);
        w.add(StabilityDef{
            .name = "gauge", .body = ship, .wire = wire[0], .pin = {0, 0, kUpperWire}});
    }
    void pull(double force) {
        w.set_force(buoy[0], {0, -force, 0}, Vec3::Zero());
        w.set_force(buoy[1], {0, force, 0}, Vec3::Zero());
    }
    /// Return the heel to starboard [rad].
    [[nodiscard]] double heel() const {
        const Mat3 r = w.pose(ship).orientation.toRotationMatrix();
        return std::atan2(r(2, 1), r(2, 2));
    }
    /// Return the lever of the wires about the centre of mass [m].
    [[nodiscard]] double lever() const {
        double moment = 0.0;
        for (const WireId id : wire) {
            const InteractionId element = w.wires().elements(id).front();
            const auto at = w.wires().ends(element);
            const Vec3 f = tension(w, element) * (at[1] - at[0]).normalized();
            moment += (at[0] - w.pose(ship).position).cross(f).x();
        }
        return moment / (kShipMass * kGravity);
    }
};

/// Return the righting lever of a wall-sided ship, by the formula of textbooks.
double wall_sided(double heel) {
    const double bm = kHeelBeam * kHeelBeam / (12.0 * kHeelDraught),
                 gm = 0.5 * kHeelDraught + bm - kHeelKg;
    return std::sin(heel) * (gm + 0.5 * bm * std::tan(heel) * std::tan(heel));
}

void report_static_heel(Report& report) {
    Heeled h;
    for (const double force : {2e6, 4e6, 6e6}) {
        h.pull(force);
        advance(h.w, 120 * 60);
        const double heel = h.heel();
        const std::string what = fmt::format("box ship, {:g} MN abeam", 1e-6 * force);
        report.compare(what + ": lever of the wires at the heel against the wall-sided GZ [m]",
                       {wall_sided(heel)}, {h.lever()}, 2e-3, "relative; at rest, edges dry");
        report.compare(what + ": GZ of the gauge [m]", {wall_sided(heel)},
                       {h.w.system_signal("gauge.gz")}, 1e-3, "relative; its table");
        report.compare(what + ": heel of the gauge [rad]", {heel},
                       {h.w.system_signal("gauge.heel")}, 1e-6, "relative; a step earlier");
    }
}

void report_capsize(Report& report) {
    double most = 0.0;  // force that the levers bear [N]
    {
        Heeled h;
        for (const auto& [heel, gz] : gz_curve(h.w, "gauge"))
            if (heel < 70.0 * kHeelDegree)
                most = std::max(
                    most, gz * kShipMass * kGravity / ((kUpperWire - kLowerWire) * std::cos(heel)));
    }
    for (const double share : {0.97, 1.03}) {
        Heeled h;
        for (int i = 0; i < 600 && h.heel() < 60.0 * kHeelDegree; ++i) {
            h.pull(share * most * std::min(i / 300.0, 1.0));
            advance(h.w, 60);
        }
        report.compare(
            fmt::format("box ship, {:g} of the force at its largest lever: capsizes", share),
            {share > 1.0 ? 1.0 : 0.0}, {h.heel() >= 60.0 * kHeelDegree ? 1.0 : 0.0}, 0.0,
            "0: it stands", 1.0);
    }
}

/// Check the gauge of the OSV of T. I. Fossen at 1 MN, 30 degrees to starboard and 30 degrees down.
void report_gauge(Report& report) {
    constexpr double kForce = 1e6, kAngle = 30.0 * kHeelDegree, kTow = 1000.0, kStiff = 1e8;
    World w{WorldDef{.step = kHeelStep}};
    const Vec3 pin(-41.5, -2.0, 4.5);
    const Vec3 along(-std::cos(kAngle) * std::cos(kAngle), -std::cos(kAngle) * std::sin(kAngle),
                     -std::sin(kAngle));
    const BodyId ship = w.add_body({.name = "ship",
                                    .mass = 4.9768875e6,
                                    .inertia = Vec3(2e8, 2e9, 2e9).asDiagonal(),
                                    .gravity = false});
    const BodyId far =
        w.add_body({.name = "far", .kind = BodyKind::fixed, .position = pin + kTow * along});
    const WireId tow = w.wires().add({.name = "tow",
                                      .from = ship,
                                      .from_point = pin,
                                      .to = far,
                                      .elements = 1,
                                      .length = kTow / (1.0 + kForce / kStiff),
                                      .EA = kStiff,
                                      .mass_per_length = 1.0});
    w.add(StabilityDef{.name = "gauge",
                       .body = ship,
                       .wire = tow,
                       .pin = pin,
                       .thrust_height = 0.0,
                       .gm = 2.06575});
    advance(w, 2);
    const auto check = [&](const char* signal, double reference, double scale = 1.0) {
        report.compare(fmt::format("gauge, worked example: {}", signal), {reference},
                       {scale * w.system_signal(std::string("gauge.") + signal)}, 1e-4, "relative");
    };
    check("moment", 2948.56e3);
    check("lever", 0.060392);
    check("heel_gm", 1.67457, 1.0 / kHeelDegree);
    check("worst_beta", 41.634, 1.0 / kHeelDegree);
}

/// Compare the criteria of a ship with GZ = GM sin φ with closed forms.
void report_permissible(Report& report) {
    constexpr double kGm = 1.2, kGaugeMass = 5e6, kAlpha = 40.0 * kHeelDegree, kHigh = 6.0;
    World w{WorldDef{.step = kHeelStep}};
    const BodyId ship = w.add_body({.name = "ship",
                                    .mass = kGaugeMass,
                                    .inertia = Vec3(2e8, 2e9, 2e9).asDiagonal(),
                                    .gravity = false});
    const BodyId far =
        w.add_body({.name = "far", .kind = BodyKind::fixed, .position = {-500, 0, 0}});
    const WireId tow = w.wires().add({.name = "tow",
                                      .from = ship,
                                      .to = far,
                                      .elements = 1,
                                      .length = 500.0,
                                      .EA = 1e8,
                                      .mass_per_length = 1.0});
    StabilityDef def{
        .body = ship, .wire = tow, .pin = {0, 0, kHigh}, .thrust_height = 0.0, .gm = kGm};
    // Level wire: HL = k cos φ, so that tan φ₁ = k/GM, and the residual lever √(GM² + k²) − 0 …
    def.name = "heel";
    w.add(def);
    const double k1 = kGm * std::tan(15.0 * kHeelDegree);
    const double unit = kHigh * std::sin(kAlpha) / (kGaugeMass * 9.81);
    report.compare("gauge, level wire: permissible tension by 15 degrees of heel [N]", {k1 / unit},
                   {permissible_tension(w, "heel", kAlpha, 0.0)}, 1e-4,
                   "relative; samples of 0.5 degrees");
    // Residual area from φ₁ to 90°: √(GM² + k²) − k … = GM cos φ₁ − k (1 − sin φ₁).
    def.name = "area";
    def.most_heel = 1.5;
    def.residual_lever = 0.0;
    def.residual_area = 0.6;
    w.add(def);
    const double tension = permissible_tension(w, "area", kAlpha, 0.0), k = tension * unit;
    const double first = std::atan2(k, kGm);
    const double area = kGm * std::cos(first) - k * (1.0 - std::sin(first));
    const StabilityCheck at = check_stability(w, "area", tension, kAlpha, 0.0);
    report.compare("gauge, level wire: residual area [m rad]", {area}, {at.residual_area}, 1e-3,
                   "relative; samples of 0.5 degrees");
    report.compare("gauge, level wire: first intersection [rad]", {first}, {at.static_heel}, 1e-4,
                   "relative; samples of 0.5 degrees");
}

}  // namespace

void case_vessel_stability(Report& report) {
    report_static_heel(report);
    report_capsize(report);
    report_gauge(report);
    report_permissible(report);
}

}  // namespace hawser::validate
