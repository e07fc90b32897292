// SPDX-License-Identifier: Apache-2.0
// Cranes: falls, cylinders, pendants, limits, and the scenes crane_knuckle and crane_lattice.
#include "validate/cranes.h"

#include "validate/cases.h"
#include "validate/tools.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <utility>

namespace hawser::validate {
namespace {

constexpr double kCraneStep = 1.0 / 60.0, kSling = 1.0;

/// A crane on a quay, with a weight on its hook from the start.
struct Quay {
    World w{WorldDef{.step = kCraneStep}};
    CraneIds ids;

    template <class Def>
    Quay(Def (*make)(BodyId), double mass, const std::function<void(Def&)>& change = {}) {
        Def def = make(w.add_body({.name = "quay", .kind = BodyKind::fixed}));
        const BodyId box = w.add_body({.name = "box",
                                       .kind = BodyKind::lump,
                                       .position = point_of(make) - Vec3(0, 0, kSling),
                                       .mass = mass});
        def.loads = {{.body = box,
                      .eyes = {{0, 0, 0}},
                      .sling_length = kSling,
                      .sling_EA = 5e10,
                      .reach = 0.01}};
        def.take = 1;
        if (change) change(def);
        ids = w.add(def);
    }
    /// Return the initial position of the hook of the crane that `make` defines.
    template <class Def>
    static Vec3 point_of(Def (*make)(BodyId)) {
        World scratch;
        const Def def = make(scratch.add_body({.kind = BodyKind::fixed}));
        const CraneIds at = scratch.add(def);
        return scratch.world_point(at.hook, {0, 0, -0.5 * def.hook.height});
    }
    [[nodiscard]] InteractionId part(const std::string& name) const {
        return interaction(w, "crane/" + name);
    }
    /// Return the mean of `read()` over the next `seconds` of the run.
    double mean(double seconds, const std::function<double()>& read) {
        const long steps = std::lround(seconds / kCraneStep);
        double sum = 0.0;
        for (long i = 0; i < steps; ++i) {
            advance(w, 1);
            sum += read();
        }
        return sum / static_cast<double>(steps);
    }
    void run(double seconds) { advance(w, std::lround(seconds / kCraneStep)); }
};

/// Return the length of the hoist line of knuckle_crane() from its geometry [m]: from the drum over
/// the knuckle's sheave, along the jib, and two falls. The hook hangs one sheave diameter lower.
double line_length(const KnuckleCraneDef& d) {
    const double r = d.hoist.sheave_radius, x = d.boom.length - d.hoist.drum.x();
    const double z = d.hoist.drum.z(), first = std::sqrt(x * x + z * z - r * r);
    const double comes = std::asin(r / std::hypot(x, z)) - std::atan2(z, x);
    return first + d.jib.length + 2.0 * d.hook.hang +
           r * (comes - d.jib_angle + 0.5 * kPi + d.boom_angle + d.jib_angle + 2.0);
}

/// Return the force with which a cylinder balances a moment about the pin of its boom [N].
double push_against(const CraneCylinder& c, const Vec3& pin, double angle, double moment) {
    const double co = std::cos(angle), si = std::sin(angle);
    const Vec3 head(c.head.x() * co - c.head.z() * si, 0, c.head.x() * si + c.head.z() * co);
    const Vec3 way = pin + head - c.foot;
    return moment * way.norm() / (way.z() * head.x() - way.x() * head.z());
}

void report_falls(Report& report) {
    constexpr double kMass = 20e3;
    // Compliant booms would change the length of line on their sheaves.
    const auto rigid = [](KnuckleCraneDef& def) {
        def.boom_cylinder.stiffness = def.jib_cylinder.stiffness = 1e13;
    };
    Quay soft(knuckle_crane, kMass, std::function<void(KnuckleCraneDef&)>(rigid));
    const KnuckleCraneDef d = knuckle_crane({});
    soft.run(20.0);
    const double k = 4.0 * d.hoist.EA / line_length(d);
    const double hang = soft.mean(20.0, [&] { return soft.w.system_signal("crane.hang"); });
    report.compare("knuckle boom: stretch of two falls under 20 t [m]", {kMass * kGravity / k},
                   {hang - d.hook.hang}, 0.01, "W L/(n^2 EA); mean of 20 s: the load swings");
    Quay stiff(knuckle_crane, kMass, std::function([&](KnuckleCraneDef& def) {
                   rigid(def);
                   def.hoist.damping_time = 0.0;
               }));
    std::vector<double> bounce;
    const double rest = d.hook.hang + kMass * kGravity / k;
    for (int i = 0; i < 1200; ++i) {
        advance(stiff.w, 1);
        bounce.push_back(stiff.w.system_signal("crane.hang") - rest);
    }
    const std::vector<double> zeros = upward_zeros(bounce, kCraneStep);
    const double count = static_cast<double>(zeros.size() - 1);
    report.compare("knuckle boom: bounce of hook and load [Hz]",
                   {std::sqrt(k / (kMass + d.hook.mass)) / (2.0 * kPi)},
                   {count / (zeros.back() - zeros.front())}, 0.01,
                   "n sqrt(EA/(L m))/(2 pi), rigid booms; second order in the step");
}

void report_cylinders(Report& report) {
    constexpr double kMass = 20e3;
    Quay q(knuckle_crane, kMass);
    const KnuckleCraneDef d = knuckle_crane({});
    q.run(20.0);
    const double boom = q.w.coordinate(q.part("luff")), jib = q.w.coordinate(q.part("knuckle"));
    const double all = boom + jib, hangs = kMass + d.hook.mass;
    const double head = d.boom.length * std::cos(boom), arm = d.jib.length * std::cos(all);
    const double on_boom = kGravity * (0.5 * head * d.boom.mass + (head + 0.5 * arm) * d.jib.mass +
                                       (head + arm) * hangs);
    const double on_jib =
        kGravity * (0.5 * arm * d.jib.mass + arm * hangs - 0.5 * hangs * d.hoist.sheave_radius);
    const double pushes[] = {
        q.mean(20.0, [&] { return q.w.motor_force(q.part("luff/motor")); }),
        q.mean(20.0, [&] { return q.w.motor_force(q.part("knuckle/motor")); })};
    const Vec3 knuckle(d.boom.length, 0, 0);
    report.compare("knuckle boom: forces of both cylinders [N]",
                   {push_against(d.boom_cylinder, d.boom_foot, boom, on_boom),
                    push_against(d.jib_cylinder, knuckle, jib, on_jib)},
                   {pushes[0], pushes[1]}, 5e-3, "moments about the pins; means of 20 s");
    Quay weak(knuckle_crane, kMass,
              std::function([](KnuckleCraneDef& def) { def.boom_cylinder.push = 1.9e6; }));
    double most = 0.0;
    for (int i = 0; i < 120; ++i) {
        advance(weak.w, 1);
        most = std::max(most, weak.w.motor_force(weak.part("luff/motor")));
    }
    report.compare("knuckle boom: largest force of a cylinder of 1.9 MN [N]", {1.9e6}, {most}, 1e-9,
                   "it gives way at it");
}

void report_lattice(Report& report) {
    constexpr double kMass = 500e3, kFalls = 12.0, kEta = 0.98;
    Quay q(lattice_crane, kMass);
    const LatticeCraneDef d = lattice_crane({});
    q.run(60.0);
    const double weight = (kMass + d.hook.mass) * kGravity;
    std::vector<double> falls;
    for (const InteractionId fall : q.ids.falls)
        falls.push_back(q.mean(10.0, [&] { return tension(q.w, fall); }));
    report.compare("lattice boom: 12 falls of 500 t [N]", std::vector(12, weight / kFalls), falls,
                   0.01, "W/12, no sheave rubs; means of 10 s");
    double worst = 0.0;
    for (const double speed : {0.05, -0.05}) {
        Quay rubs(lattice_crane, kMass,
                  std::function([](LatticeCraneDef& def) { def.hoist.efficiency = kEta; }));
        rubs.run(40.0);
        rubs.w.set_system_signal("crane.hoist", speed);
        rubs.run(30.0);
        const double lead =
            rubs.mean(20.0, [&] { return tension(rubs.w, rubs.part("hoist/part1")); });
        const double whole = std::pow(kEta, kFalls);
        const double expected = speed > 0.0 ? weight * (1.0 - kEta) / (kEta * (1.0 - whole))
                                            : weight * whole * (1.0 - kEta) / (1.0 - whole);
        worst = std::max(worst, std::abs(lead / expected - 1.0));
    }
    report.compare("lattice boom: lead line over its closed form at 0.98", {1.0}, {1.0 + worst},
                   5e-3, "largest, hoisting and lowering; means of 20 s");
}

/// Read the control file of a scene. The result maps times to inputs and values.
std::multimap<double, std::pair<std::string, double>> read_control_values(const std::string& file) {
    std::ifstream in(file);
    std::multimap<double, std::pair<std::string, double>> out;
    std::vector<std::string> names;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::stringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        if (names.empty()) {
            names = row;
            continue;
        }
        for (std::size_t i = 1; i < row.size(); ++i)
            out.emplace(std::stod(row[0]), std::pair(names[i], std::stod(row[i])));
    }
    return out;
}

/// Move a load from deck to deck. @return the distance of the load from its target at the end [m].
double move_load_to_deck(double mass, double& alarm) {
    scene::Scene s =
        open_scene("crane_knuckle", kCraneStep, {"bodies.load.mass=" + std::to_string(mass)});
    std::filesystem::path file(s.path);
    file.replace_extension(".control.csv");
    const auto control = read_control_values(file.string());
    if (control.empty()) throw std::runtime_error("there is no " + file.string());
    auto next = control.begin();
    for (long i = 0; i < std::lround(s.duration / kCraneStep); ++i) {
        for (; next != control.end() && next->first <= s.world.time() + 1e-9; ++next)
            s.world.set_system_signal(next->second.first, next->second.second);
        advance(s.world, 1);
        alarm = std::max(alarm, s.world.system_signal("crane.alarm"));
    }
    return s.world.output(s.world.find_output("off_target"));
}

}  // namespace

void case_cranes(Report& report) {
    report_falls(report);
    report_cylinders(report);
    report_lattice(report);
    double light = 0.0, heavy = 0.0;
    const double off = move_load_to_deck(20e3, light);
    (void)move_load_to_deck(25e3, heavy);
    report.compare("crane_knuckle: load from its target at the end [m]", {0.0}, {off}, 0.2,
                   "set down and let go", 1.0);
    report.compare("crane_knuckle: highest alarm with 20 t and with 25 t", {0.0, 2.0},
                   {light, heavy}, 1e-12, "23.4 t are rated there", 1.0);
}

}  // namespace hawser::validate
