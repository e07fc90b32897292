// SPDX-License-Identifier: Apache-2.0
// Drag of many times the value that a step resolves: no body gains energy without a source.
#include "validate/sea.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace hawser::validate {
namespace {

/// Largest energy without a source, relative to the energy exchanged since the start.
class Balance {
  public:
    /// Start at a world after at least one step: before, there are no energies.
    explicit Balance(const World& w) : start_(w.energy()), before_(start_) {}
    void sample(const World& w) {
        const Energy e = w.energy();
        // Change of each account in this step.
        for (const auto change :
             {e.kinetic - before_.kinetic, e.gravity - before_.gravity, e.elastic - before_.elastic,
              e.added - before_.added, e.system - before_.system, e.dissipated - before_.dissipated,
              e.damped - before_.damped})
            exchanged_ += std::abs(change);
        before_ = e;
        const auto sum = [](const Energy& x) {
            return x.mechanical() - x.applied - x.driven - x.edited - x.system + x.dissipated +
                   x.friction + x.contact + x.damped;
        };
        created_ = std::max(created_, sum(e) - sum(start_));
    }
    [[nodiscard]] double error_fraction() const {
        return exchanged_ > 0.0 ? created_ / exchanged_ : 0.0;
    }

  private:
    Energy start_, before_;
    double exchanged_ = 0.0, created_ = 0.0;
};

/// A world with a sea of Hs 8 m, or the same without it.
struct WetCase {
    std::string name;
    std::function<std::vector<BodyId>(World&, bool with_sea)> build;  ///< Bodies in the water.
    double thrown = 0.0;     ///< Initial speed of all of them [m/s].
    double max_speed = 0.0;  ///< Afterwards [m/s].
};

void throw_all(World& w, std::span<const BodyId> bodies, double speed) {
    if (speed != 0.0)
        for (const BodyId b : bodies) w.set_velocity(b, {Vec3(speed, 0, 0), Vec3::Zero()});
}

double fastest_wet(const World& w, std::span<const BodyId> bodies) {
    double most = 0.0;
    for (const BodyId b : bodies) {
        const double speed = w.velocity(b).linear.norm();
        if (!std::isfinite(speed) || !w.pose(b).position.allFinite()) return HUGE_VAL;
        most = std::max(most, speed);
    }
    return most;
}

/// Apply f − D v − A v̇ of a load, with v̇ of the previous step, as a program without block
/// matrices does.
void apply_explicitly(World& w, const LoadView& load, const Twist& before) {
    const auto n = static_cast<int>(load.force.size());
    const Twist now = w.velocity(load.body);
    double v[6], rate[6], f[6] = {};
    for (int i = 0; i < 6; ++i) {
        v[i] = i < 3 ? now.linear[i] : now.angular[i - 3];
        rate[i] = 60.0 * (v[i] - (i < 3 ? before.linear[i] : before.angular[i - 3]));
    }
    for (int i = 0; i < n; ++i) {
        f[i] = load.force[std::size_t(i)];
        for (int j = 0; j < n; ++j) {
            const auto k = static_cast<std::size_t>(triangle(std::max(i, j), std::min(i, j)));
            f[i] -= load.damping[k] * v[j] + load.mass[k] * rate[j];
        }
    }
    w.set_force(load.body, Vec3(f[0], f[1], f[2]), Vec3(f[3], f[4], f[5]));
}

/// Return the number of steps until a body reaches 1,000 m/s if the terms are applied as explicit
/// forces; 0: it does not. The terms come from a second world with the sea, which is set to the
/// state of this one.
int explicit_steps(const WetCase& c, int most) {
    World wet(WorldDef{}), dry(WorldDef{});
    const std::vector<BodyId> bodies = c.build(wet, true);
    c.build(dry, false);
    throw_all(dry, bodies, c.thrown);
    std::vector<Twist> before(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) before[i] = dry.velocity(bodies[i]);
    for (int step = 1; step <= most; ++step) {
        std::vector<Twist> now;
        for (const BodyId b : bodies) {
            now.push_back(dry.velocity(b));
            wet.set_pose(b, dry.pose(b));
            wet.set_velocity(b, now.back());
        }
        advance(wet, 1);
        for (const LoadView& load : sea_loads(wet)) {
            const auto at = std::find(bodies.begin(), bodies.end(), load.body);
            if (at != bodies.end())
                apply_explicitly(dry, load, before[static_cast<std::size_t>(at - bodies.begin())]);
        }
        before = now;
        const bool went = dry.step() == Status::ok;
        if (!went || fastest_wet(dry, bodies) > 1e3) return step;
    }
    return 0;
}

void run_wet(Report& report, const WetCase& c, int steps) {
    World w(WorldDef{});
    const std::vector<BodyId> bodies = c.build(w, true);
    advance(w, 1);
    throw_all(w, bodies, c.thrown);
    Balance balance(w);
    double speed = 0.0;
    for (int i = 0; i < steps && std::isfinite(speed); ++i) {
        advance(w, 1);
        balance.sample(w);
        if (i > 60 || i + 1 == steps) speed = std::max(speed, fastest_wet(w, bodies));
    }
    report.compare(c.name + ": highest speed, the first second left out [m/s]", {0.0}, {speed},
                   c.max_speed, "of the water, and of falling", 1.0);
    report.compare(c.name + ": energy from nothing over what was exchanged", {0.0},
                   {balance.error_fraction()}, 1e-3, "none comes", 1.0);
}

WaveDef high_sea() { return {.kind = WaveKind::jonswap, .height = 8.0, .period = 12.0}; }

std::vector<BodyId> build_node(World& w, bool with_sea, double drag, double volume, double added) {
    const BodyId body =
        w.add_body({.name = "lump", .kind = BodyKind::lump, .position = {0, 0, -3}, .mass = 1.0});
    if (!with_sea) return {body};
    SeaDef sea{.depth = 50.0};
    sea.waves.push_back(high_sea());
    sea.bodies.push_back({.body = body,
                          .drag_area = Vec3::Constant(drag),
                          .volume = volume,
                          .added_mass = Vec3::Constant(added),
                          .height = 0.5});
    w.add(sea);
    return {body};
}

std::vector<BodyId> build_rope(World& w, bool with_sea) {
    const BodyId fixed = w.add_body({.name = "fixed", .kind = BodyKind::fixed});
    const WireId rope = w.wires().add({.name = "rope",
                                       .from = fixed,
                                       .from_point = {0, 0, -5},
                                       .elements = 20,
                                       .length = 40.0,
                                       .EA = 1e6,
                                       .mass_per_length = 0.5});
    const auto lumps = w.wires().nodes(rope).subspan(1);
    std::vector<BodyId> bodies(lumps.begin(), lumps.end());
    if (!with_sea) return bodies;
    SeaDef sea{.depth = 100.0};
    sea.waves.push_back(high_sea());
    sea.lines.push_back(
        {.wire = rope,
         .sections = {{20, {.diameter = 0.03, .cd_normal = 1.8, .cd_tangential = 0.02}}},
         .free_last = true});
    w.add(sea);
    return bodies;
}

/// Build a plank of 4 × 1 × 0.02 m with a draught of 0.1 mm: its waterplane stiffness is 1e5 times
/// its mass.
std::vector<BodyId> build_plank(World& w, bool with_sea) {
    const double mass = 1025.0 * 4.0 * 1e-4;
    const BodyId body =
        w.add_body({.name = "plank",
                    .position = {0, 0, 0.02},
                    .mass = mass,
                    .inertia = Vec3(mass / 12, 16 * mass / 12, 17 * mass / 12).asDiagonal()});
    if (!with_sea) return {body};
    SeaDef sea{.depth = 100.0};
    sea.waves.push_back(high_sea());
    sea.hulls.push_back({.body = body,
                         .mesh = box_hull({2, 0.5, 0.01}, 8, 2, 1),
                         .damping = {0, 0, 0, 20, 20, 5},
                         .drag_area = {0.02, 0.1, 4.0}});
    w.add(sea);
    return {body};
}

const std::vector<WetCase>& wet_cases() {
    static const std::vector<WetCase> all = {
        {"added mass of 5 masses",
         [](World& w, bool sea) { return build_node(w, sea, 0.05, 1.1 / 1025.0, 5.0 / 1.1); }, 0.0,
         20.0},
        {"body of 5 m2/kg, thrown at 40 m/s",
         [](World& w, bool sea) { return build_node(w, sea, 5.0, 1e-3, 0.0); }, 40.0, 20.0},
        {"slack rope at 40 m/s", build_rope, 40.0, 20.0},
        {"plank of 0.1 mm draught", build_plank, 0.0, 20.0},
    };
    return all;
}

}  // namespace

void case_sea_stability(Report& report) {
    for (const WetCase& c : wet_cases()) {
        run_wet(report, c, 3'000);
        const int steps = explicit_steps(c, 3'000);
        report.compare(c.name + ": steps until the same terms explicit are at 1,000 m/s", {1.0},
                       {double(steps)}, steps > 0 ? 3e3 : 0.0, "they diverge", 1.0);
    }
}

void case_sea_stability_hour(Report& report) {
    for (const WetCase& c : wet_cases()) run_wet(report, c, 60 * 3'600);
}

}  // namespace hawser::validate
