// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file attached.h
/// Compute the attachment of an interaction to its bodies from definitions and poses alone.

#include <hawser/hawser.h>

#include <span>

namespace hawser::verify {

/// World points and axes of an interaction's bodies.
class Attached {
  public:
    Attached(const World& world, InteractionId id, std::span<const Pose> pose)
        : world_(world), def_(world.interaction_def(id)), pose_(pose) {}
    /// True if the body of a slot is a node or a scalar body, which has neither rotation nor arms.
    [[nodiscard]] bool is_point(int slot) const;
    [[nodiscard]] Vec3 center(int slot) const { return at(slot).position; }
    [[nodiscard]] Vec3 point(int slot) const;
    [[nodiscard]] Quat frame(int slot) const;
    [[nodiscard]] Vec3 axis(int slot, int k) const { return frame(slot) * Vec3::Unit(k); }
    [[nodiscard]] BodyKind kind(int slot) const;
    [[nodiscard]] const InteractionDef& def() const { return def_; }
    /// Return the velocity of the body of a slot after the solve. Poses are those before the step.
    [[nodiscard]] Twist velocity(int slot) const;

  private:
    [[nodiscard]] const Pose& at(int slot) const;
    const World& world_;
    const InteractionDef& def_;
    std::span<const Pose> pose_;
};

}  // namespace hawser::verify
