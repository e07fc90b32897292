// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file edited_stretch.h
/// Account of the elastic energy that edits of nodes add to wires within a step.
///
/// A node that comes or goes may change rest lengths, and with them the stretch of elements, though
/// nothing has moved. The change is measured at the poses xₙ before the step:
/// ```
///     ΔV = Σ V(elements after the edit, at xₙ) − Σ V(elements before, at xₙ)     V = ½ g² EA/l₀
/// ```
/// Elements after the edit are known at the end of the step only. Nodes and slides have moved by h
/// v since, which gives xₙ. The length of an element at xₙ is that between its ends; on a wheel of
/// radius R it also changes by R times the turn of its direction.
///
/// Kinetic energy and gravity of edits are not counted: part of the mass at drums and guides is on
/// no body.

#include <hawser/hawser.h>

#include <span>

namespace hawser::verify {

class EditedStretch {
  public:
    /// Store the elastic energy of the wires before a step.
    void before_step(const World& world) { before_ = elastic_energy(world); }
    /// Return ΔV of a step that edited wires [J]. @param pose  Poses of all bodies before the step,
    /// by index; of nodes and slides they are computed.
    [[nodiscard]] double elastic_change(const World& world, std::span<const Pose> pose) const;

  private:
    [[nodiscard]] static double elastic_energy(const World& world);
    double before_ = 0.0;  ///< Σ V before the step [J].
};

}  // namespace hawser::verify
