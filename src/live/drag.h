// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drag.h
/// A pointer pulls at a body by a damped spring.
///
/// ```
///     point of the body ●/\/\/\/● target        F = k (target − p) − c v
/// ```
/// The force goes in as an applied force between steps, so that a recording has it as a change like
/// any other and a replay needs none of this. It is explicit: it stays stable where k h² and c h
/// are small against the mass m that the point shows, 1/m = 1/M + ‖r‖² tr I⁻¹ at least, so that
/// both are limited to a quarter and a half of it (a free mass would stand k h² < 4 m, c h < 2 m).

#include "live/command.h"

#include <hawser/world.h>

#include <cstdint>
#include <vector>

namespace hawser::live {

class Drags {
  public:
    /// Begin one of a client, or go on with another target. @throws DefError where the body cannot
    /// be pulled.
    void begin(World& world, std::uint32_t client, BodyId body, const Vec3& point,
               const Vec3& target, double stiffness);
    void end(World& world, std::uint32_t client);
    void end_all(World& world);
    /// Forces of the step to come.
    void before_step(World& world);
    /// Take the forces away until the next step: so that a state that is saved has none.
    void lift(World& world);
    [[nodiscard]] bool any() const noexcept { return !drags_.empty(); }

  private:
    struct Drag {
        std::uint32_t client;
        BodyId body;
        Vec3 point, target;
        double stiffness;
    };
    /// What acted on a body before it was pulled at.
    struct Base {
        BodyId body;
        Vec3 force, torque;
    };
    void put_back(World& world, BodyId body);
    void drop_gone(const World& world);

    std::vector<Drag> drags_;
    std::vector<Base> bases_;
};

/// The node of a wire nearest to a share of its length, 0 to 1, that is a lump. @throws DefError
/// where it has none.
[[nodiscard]] BodyId node_near(const World& world, WireId wire, double share);

}  // namespace hawser::live
