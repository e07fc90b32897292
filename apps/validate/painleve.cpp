// SPDX-License-Identifier: Apache-2.0
// Painlevé's rod: friction that turns a sliding rod into the ground.
#include "validate/cases.h"
#include "validate/tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace hawser::validate {
namespace {

/// Return the largest distance of a contact force from Coulomb's cone, over the largest force. It
/// is computed from the contacts, independently of the solver.
double outside_cone(const World& world, double friction) {
    double worst = 0.0, scale = 1e-300;
    for (const ContactView& c : world.contacts()) {
        const double normal = c.force.dot(c.normal);
        const double tangential = (c.force - normal * c.normal).norm();
        scale = std::max(scale, c.force.norm());
        worst = std::max({worst, -normal, tangential - friction * std::max(normal, 0.0)});
    }
    return worst / scale;
}

/// Check the first step of a rod that slides at 1 m/s at an angle, just touching. The acceleration
/// of its end is p = (1 + 3 cos² − 3 μ sin cos)/m per unit of normal force. The force therefore is
/// g/p if p > 0, at any speed. At p ≤ 0 no finite force lets it slide on. The step is so short and
/// the contact so stiff that Σ is a thousandth of p. The rod is so thin that its radius moves the
/// threshold by 1e-5.
void check_first_step(Report& report, double angle, double factor) {
    constexpr double kRadius = 1e-5, kStep = 1e-4;
    const double c = std::cos(angle), s = std::sin(angle);
    const double threshold = (1.0 + 3.0 * c * c) / (3.0 * s * c);
    const double friction = factor * threshold;
    scene::Scene scene = open_scene(
        "painleve", kStep,
        {fmt::format("material_pairs.0.friction={}", friction), "material_pairs.0.stiffness=1e12",
         "settings.staggered_start=false", fmt::format("bodies.rod.shapes.0.radius={}", kRadius),
         fmt::format("bodies.rod.position=[0,0,{:.17g}]", s + kRadius - 1e-13),
         fmt::format("bodies.rod.orientation=[{:.17g},0,{:.17g},0]", std::cos(0.5 * angle),
                     -std::sin(0.5 * angle))});
    advance(scene.world, 1);
    bool slides = false;
    double force = 0.0, speed = 0.0;
    const BodyId rod = body(scene.world, "rod");
    const Twist twist = scene.world.velocity(rod);
    for (const ContactView& contact : scene.world.contacts()) {
        slides = slides || contact.sliding;
        force += contact.force.z();
        const Vec3 arm(-c, 0.0, -s);  // at the start of the step
        speed = (twist.linear + twist.angular.cross(arm)).head<2>().norm();
    }
    const bool certified = scene.world.stats().natural_map <= 1e-6;
    const std::string what = fmt::format("angle {:.1f} deg, friction {:.3f} of {:.3f}",
                                         angle * 180.0 / kPi, friction, threshold);
    const bool beyond = factor > 1.0;
    report.compare(what + ": slides on, certified", {beyond ? 0.0 : 1.0},
                   {slides && certified ? 1.0 : 0.0}, 0.0,
                   beyond ? "it is to stop at once, or to say that there is no solution"
                          : "below the threshold there is one solution",
                   1.0);
    if (beyond) {
        report.compare(what + ": speed after 1e-4 s [m/s]", {0.0}, {certified ? speed : 0.0}, 1e-3,
                       "of the 1 m/s before: it has stopped, or no solution is claimed", 1.0);
        return;
    }
    report.compare(what + ": force [N]", {kGravity / (3.0 * s * c * (threshold - friction))},
                   {force}, 5e-3, "relative; m g/(1 + 3 cos^2 - 3 mu sin cos), contacts give");
}

}  // namespace

void case_painleve(Report& report) {
    // tan(angle) = 2: paradox for mu ≥ 4/3. If friction jams, a step may report that it has no
    // solution. A solution that it reports must obey the law.
    constexpr double kCertified = 1e-6;
    for (const double friction : {1.0, 1.6}) {
        scene::Scene s = open_scene("painleve", 1.0 / 240.0,
                                    {fmt::format("material_pairs.0.friction={}", friction)});
        const BodyId rod = body(s.world, "rod");
        const double start = s.world.pose(rod).position.z();
        double flagged = 0.0, cone = 0.0, highest = start;
        constexpr long kSteps = 120;  // until it lies flat: an impact follows
        for (long k = 0; k < kSteps; ++k) {
            advance(s.world, 1);
            const bool certified = s.world.stats().natural_map <= kCertified;
            flagged += certified ? 0.0 : 1.0;
            if (certified) cone = std::max(cone, outside_cone(s.world, friction));
            highest = std::max(highest, s.world.pose(rod).position.z());
        }
        report.compare(fmt::format("friction {}: steps flagged of {}", friction, kSteps), {0.0},
                       {flagged}, friction > 4.0 / 3.0 ? 2.0 : 0.0,
                       "none below 4/3; above, where sliding stops", 1.0);
        report.compare(fmt::format("friction {}: force outside the cone", friction), {0.0}, {cone},
                       kCertified, "of the largest force, from the contacts", 1.0);
        const double rise = 1.0 / (2.0 * kGravity);  // all of its energy, (1 m/s)^2/2g
        report.compare(fmt::format("friction {}: rise above v^2/2g [m]", friction), {0.0},
                       {std::max(0.0, highest - start - rise)}, 1e-9, "no energy is made", 1.0);
    }
    for (const double angle : {std::atan(2.0), kPi / 4.0}) {
        check_first_step(report, angle, 0.975);
        check_first_step(report, angle, 1.025);
    }
}

}  // namespace hawser::validate
