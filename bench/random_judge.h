// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_judge.h
/// Whether a motion can be: reckoned from poses, velocities and definitions alone, with no figure
/// of the stepper. It knows bodies under gravity, joints, rods, springs and lines; nothing that
/// drives, rubs or touches.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

/// Figures of a motion so far.
struct Judged {
    double exchanged = 0.0;  ///< ½ Σ of what kinetic, gravity and elastic energy changed by [J].
    /// Largest rise of mechanical energy above what it was before, of three states running [J].
    double created = 0.0;
    double created_share = 0.0;    ///< The same over `exchanged` and kinetic energy then.
    double swing_share = 0.0;      ///< Of one state: what comes and goes within two steps, too.
    double created_at = 0.0;       ///< [s].
    double violation = 0.0;        ///< Largest of a joint [m]; turns count at half the body's size.
    double violation_share = 0.0;  ///< Largest over what is allowed: 1 cm or 1 % of the size.
    double violation_at = 0.0;     ///< [s].
    InteractionId worst{};         ///< Where that is.
    bool finite = true;
    [[nodiscard]] bool wrong() const noexcept {
        return !finite || created_share > 0.01 || violation_share > 1.0;
    }
};

/// Watches a world whose steps all came out well. The energy of a staggered scheme can be taken at
/// poses, with the mean of the kinetic energies before and after, or half-way between two poses;
/// either may swing within a period while nothing is created. A spring that is far too stiff for
/// the step stores by its length at a pose, a tenth of a millimetre off, what it never exerts; by
/// its force it does not. What counts is the smallest of the three rises, as far as it is there in
/// three states running: where a body whips round within two steps, its energy swings by some per
/// cent and is back afterwards, and each halving of the step takes three quarters of that.
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
    struct Swing {  ///< Of one way to take the energy.
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
    std::vector<double> allowed_, size_;  ///< Of each joint [m].
    std::vector<Pose> before_;
    double kinetic_ = 0.0, gravity_ = 0.0, elastic_ = 0.0;  ///< Before.
    double floor_ = 0.0;  ///< Energy of all bodies one centimetre higher [J].
    Swing at_poses_, between_, by_force_;
    std::array<double, 2> risen_{};  ///< Smallest of the three in the last two states [J].
    bool begun_ = false;
    Judged out_;
};

}  // namespace hawser::bench
