// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_judge.h
/// Check of a motion from poses, velocities and definitions alone, without figures of the stepper.
/// It supports bodies under gravity, joints, rods, springs and lines, but no drives, friction or
/// contacts.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

/// Figures of a motion so far.
struct Judged {
    double exchanged = 0.0;  ///< ½ Σ of the changes of kinetic, gravity and elastic energy [J].
    /// Largest rise of mechanical energy above its earlier value, over three successive states [J].
    double created = 0.0;
    /// `created` relative to `exchanged` plus the kinetic energy then.
    double created_share = 0.0;
    double swing_share = 0.0;  ///< The same of one state: includes oscillations within two steps.
    double created_at = 0.0;   ///< [s].
    double violation = 0.0;    ///< Largest of a joint [m]; turns count at half the body's size.
    /// Largest violation relative to the limit: 1 cm or 1 % of the size.
    double violation_share = 0.0;
    double violation_at = 0.0;  ///< [s].
    InteractionId worst{};      ///< Joint with that violation.
    bool finite = true;
    [[nodiscard]] bool wrong() const noexcept {
        return !finite || created_share > 0.01 || violation_share > 1.0;
    }
};

/// Observes a world whose steps all end ok. The energy of a staggered scheme can be evaluated in
/// two ways: at poses, with the mean of the kinetic energies before and after, or half-way between
/// two poses. Either may oscillate within a period without creation of energy. A spring that is far
/// too stiff for the step stores energy by its length, 0.1 mm off, that it never exerts; its force
/// does not show it. The result is the smallest of the three rises, if it lasts for three
/// successive states. If a body whips round within two steps, its energy oscillates by some per
/// cent and returns afterwards. Each halving of the step reduces this by three quarters.
class RandomJudge {
  public:
    explicit RandomJudge(const World& world);
    /// After each step.
    void look(const World& world);
    [[nodiscard]] const Judged& figures() const noexcept { return out_; }

  private:
    /// Elastic element between two points: g²/(2 ε) of its length beyond the one at rest.
    struct Spring {
        InteractionId id{};
        double length = 0.0, compliance = 0.0;
        bool one_sided = false;
    };
    struct Swing {  ///< Rises for one way to evaluate the energy.
        double now = 0.0, least = 0.0;
        bool begun = false;
        [[nodiscard]] double rise(double energy);
    };

    void start(const World& world);
    [[nodiscard]] double gravity(const World& world, const std::vector<Pose>& poses) const;
    [[nodiscard]] double elastic(const World& world, const std::vector<Pose>& poses) const;
    [[nodiscard]] double elastic_by_force(const World& world) const;
    [[nodiscard]] double kinetic(const World& world) const;
    void look_at_joints(const World& world);
    void look_at_energy(const World& world);

    std::vector<BodyId> moving_;
    std::vector<Spring> springs_;
    std::vector<InteractionId> joints_;
    std::vector<double> allowed_, size_;  ///< Limit and size of each joint [m].
    std::vector<Pose> before_;
    double kinetic_ = 0.0, gravity_ = 0.0, elastic_ = 0.0;  ///< Before.
    double floor_ = 0.0;  ///< Energy of all bodies one centimetre higher [J].
    Swing at_poses_, between_, by_force_;
    std::array<double, 2> risen_{};  ///< Smallest of the three in the last two states [J].
    bool begun_ = false;
    Judged out_;
};

}  // namespace hawser::bench
