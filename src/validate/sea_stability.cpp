// SPDX-License-Identifier: Apache-2.0
// Drag of many times what a step resolves: nothing gains energy that was not exchanged.
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <string>

namespace hawser::validate {
namespace {

/// Energy that came from nothing, over what was exchanged so far, at its worst.
class Balance {
  public:
    /// Of a world with a step behind it: before there are no energies.
    explicit Balance(const World& w) : start_(w.energy()), before_(start_) {}
    void look(const World& w) {
        const Energy e = w.energy();
        // What each account took or gave in this step.
        for (const auto change :
             {e.kinetic - before_.kinetic, e.gravity - before_.gravity, e.elastic - before_.elastic,
              e.added - before_.added, e.system - before_.system, e.dissipated - before_.dissipated,
              e.damped - before_.damped})
            exchanged_ += std::abs(change);
        before_ = e;
        const auto sum = [](const Energy& x) {
            return x.mechanical() - x.applied - x.driven - x.system + x.dissipated + x.friction +
                   x.contact + x.damped;
        };
        created_ = std::max(created_, sum(e) - sum(start_));
    }
    [[nodiscard]] double share() const { return exchanged_ > 0.0 ? created_ / exchanged_ : 0.0; }

  private:
    Energy start_, before_;
    double exchanged_ = 0.0, created_ = 0.0;
};

/// @return speed at the end, or infinity where something was not finite.
double run_wet(World& w, BodyId body, int steps, Balance& balance) {
    for (int i = 0; i < steps; ++i) {
        advance(w, 1);
        balance.look(w);
        if (!w.pose(body).position.allFinite() || !w.velocity(body).linear.allFinite())
            return HUGE_VAL;
    }
    return w.velocity(body).linear.norm();
}

void report_run(Report& report, const std::string& what, World& w, BodyId body, int steps,
                double most_speed, std::span<const BodyId> thrown = {}) {
    advance(w, 1);
    for (const BodyId b : thrown) w.set_velocity(b, {Vec3(40, 0, 0), Vec3::Zero()});
    Balance balance(w);
    const double speed = run_wet(w, body, steps, balance);
    report.compare(what + ": speed after it [m/s]", {0.0}, {speed}, most_speed,
                   "of the water, and of falling", 1.0);
    report.compare(what + ": energy from nothing over what was exchanged", {0.0}, {balance.share()},
                   1e-3, "none comes", 1.0);
}

void check_light_body(Report& report) {
    World w(WorldDef{});
    const BodyId body =
        w.add_body({.name = "light", .kind = BodyKind::lump, .position = {0, 0, -3}, .mass = 1.0});
    SeaDef sea{.depth = 50.0};
    sea.waves.push_back({.kind = WaveKind::jonswap, .height = 4.0, .period = 8.0});
    sea.bodies.push_back(
        {.body = body, .drag_area = Vec3::Constant(5.0), .volume = 1e-3, .height = 0.5});
    w.add(sea);
    report_run(report, "body of 5 m2/kg, thrown at 40 m/s", w, body, 3000, 10.0,
               std::span(&body, 1));
}

void check_slack_rope(Report& report) {
    World w(WorldDef{});
    const BodyId fixed = w.add_body({.name = "fixed", .kind = BodyKind::fixed});
    const WireId rope = w.add_wire({.name = "rope",
                                    .from = fixed,
                                    .from_point = {0, 0, -5},
                                    .elements = 20,
                                    .length = 40.0,
                                    .EA = 1e6,
                                    .mass_per_length = 0.5});
    SeaDef sea{.depth = 100.0};
    sea.lines.push_back(
        {.wire = rope,
         .sections = {{20, {.diameter = 0.03, .cd_normal = 1.8, .cd_tangential = 0.02}}},
         .free_last = true});
    w.add(sea);
    report_run(report, "slack rope at 40 m/s", w, w.nodes(rope).back(), 3000, 10.0,
               w.nodes(rope).subspan(1));
}

void check_plank(Report& report) {
    // 4 × 1 × 0.02 m, of which 0.1 mm are under water: waterplane 1e5 times its mass.
    World w(WorldDef{});
    const double mass = 1025.0 * 4.0 * 1e-4;
    const BodyId body =
        w.add_body({.name = "plank",
                    .position = {0, 0, 0.02},
                    .mass = mass,
                    .inertia = Vec3(mass / 12, 16 * mass / 12, 17 * mass / 12).asDiagonal()});
    SeaDef sea{.depth = 100.0};
    sea.waves.push_back({.kind = WaveKind::jonswap, .height = 0.5, .period = 4.0});
    sea.hulls.push_back({.body = body,
                         .mesh = box_hull({2, 0.5, 0.01}, 8, 2, 1),
                         .damping = {0, 0, 0, 20, 20, 5},
                         .drag_area = {0.02, 0.1, 4.0}});
    w.add(sea);
    report_run(report, "plank of 0.1 mm draught in waves", w, body, 3000, 20.0);
}

}  // namespace

void case_sea_stability(Report& report) {
    check_light_body(report);
    check_slack_rope(report);
    check_plank(report);
}

}  // namespace hawser::validate
