// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_judge.h
/// Check that a motion is possible, from poses, velocities and definitions alone, without figures
/// of the stepper. It supports bodies under gravity, joints, rods, springs and lines; no drives,
/// friction or contacts.

#include <hawser/hawser.h>

#include <vector>

namespace hawser::bench {

/// Figures of a motion.
struct JointErrors {
    double exchanged = 0.0;  ///< ½ Σ of changes of kinetic, gravity and elastic energy [J].
    /// Largest rise of mechanical energy above its earlier value, in three consecutive states [J].
    double created = 0.0;
    double created_fraction = 0.0;  ///< The same over `exchanged` and the kinetic energy at that
                                    ///< time.
    double oscillation_fraction =
        0.0;                  ///< In one state: includes changes that vanish within two steps.
    double created_at = 0.0;  ///< [s].
    double violation = 0.0;   ///< Largest of a joint [m]; rotations count at half the body's
                              ///< size.
    double violation_fraction = 0.0;  ///< Largest over the limit: 1 cm or 1 % of the size.
    double violation_at = 0.0;        ///< [s].
    InteractionId worst{};            ///< Joint with this violation.
    bool finite = true;
    [[nodiscard]] bool wrong() const noexcept {
        return !finite || created_fraction > 0.01 || violation_fraction > 1.0;
    }
};

/// Monitors a world whose steps all succeeded.
///
/// The energy of a staggered scheme can be computed at poses, with the mean of the kinetic energies
/// before and after, or midway between two poses. Either may oscillate within a period without
/// created energy. The length of a spring that is much too stiff for the step has an error of a
/// tenth of a millimetre at a pose. Energy by this length is never exerted; energy by the force is.
///
/// The smallest of the three rises counts, if it is present in three consecutive states. A body
/// that whips round within two steps changes its energy by some per cent, which returns afterwards.
/// Each halving of the step reduces this to a quarter.
class RandomMonitor {
  public:
    explicit RandomMonitor(const World& world);
    /// Check the state after a step.
    void sample(const World& world);
    [[nodiscard]] const JointErrors& figures() const noexcept { return out_; }

  private:
    /// Elastic element between two points: g²/(2 ε) of its length beyond the rest length.
    struct Spring {
        InteractionId id{};
        double length = 0.0, compliance = 0.0;
        bool one_sided = false;
    };
    struct Swing {  ///< Sums of one definition of the energy.
        double now = 0.0, least = 0.0;
        bool begun = false;
        [[nodiscard]] double rise(double energy);
    };

    void start(const World& world);
    [[nodiscard]] double gravity(const World& world, const std::vector<Pose>& poses) const;
    [[nodiscard]] double elastic(const World& world, const std::vector<Pose>& poses) const;
    [[nodiscard]] double elastic_by_force(const World& world) const;
    [[nodiscard]] double kinetic(const World& world) const;
    void check_joints(const World& world);
    void check_energy(const World& world);

    std::vector<BodyId> moving_;
    std::vector<Spring> springs_;
    std::vector<InteractionId> joints_;
    std::vector<double> allowed_, size_;  ///< Limit and size of each joint [m].
    std::vector<Pose> before_;
    double kinetic_ = 0.0, gravity_ = 0.0, elastic_ = 0.0;  ///< Values of the state before.
    double floor_ = 0.0;  ///< Energy of all bodies one centimetre higher [J].
    Swing at_poses_, at_midpoint_, by_force_;
    std::array<double, 2> risen_{};  ///< Smallest of the three in the last two states [J].
    bool begun_ = false;
    JointErrors out_;
};

}  // namespace hawser::bench
