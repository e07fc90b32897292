// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drag.h
/// Pull at a body by a damped spring between a point of the body and a pointer.
///
/// ```
///     point of the body ●/\/\/\/● target        F = k (target − p) − c v
/// ```
/// The force is an applied force that is set between steps. A recording stores it like any other
/// change, so a replay does not need this file. The force is explicit: it is stable if k h² and c h
/// are small against the effective mass m at the point. A bound is 1/m = 1/M + ‖r‖² tr I⁻¹.
/// Therefore k h² is limited to m/4 and c h to m/2. A free mass would be stable for
/// k h² < 4 m, c h < 2 m.

#include "live/command.h"

#include <hawser/world.h>

#include <cstdint>
#include <vector>

namespace hawser::live {

class Drags {
  public:
    /// Begin a drag of a client, or change its target. @throws DefError if the body cannot be
    /// moved.
    void begin(World& world, std::uint32_t client, BodyId body, const Vec3& point,
               const Vec3& target, double stiffness);
    void end(World& world, std::uint32_t client);
    void end_all(World& world);
    /// Apply the forces by which clients drag bodies, for the next step.
    void before_step(World& world);
    /// Remove the forces of drags until the next step, so that a saved state does not contain them.
    void remove_forces(World& world);
    [[nodiscard]] bool any() const noexcept { return !drags_.empty(); }

  private:
    struct Drag {
        std::uint32_t client;
        BodyId body;
        Vec3 point, target;
        double stiffness;
    };
    /// Force and torque on a body before it was dragged.
    struct Base {
        BodyId body;
        Vec3 force, torque;
    };
    void restore_force(World& world, BodyId body);
    void remove_gone_bodies(const World& world);

    std::vector<Drag> drags_;
    std::vector<Base> bases_;
};

/// Return the node of a wire nearest to a fraction of its length, 0 to 1. @throws DefError if the
/// wire has no node.
[[nodiscard]] BodyId node_near(const World& world, WireId wire, double share);

}  // namespace hawser::live
