// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Outputs of a world as they are evaluated: in the order of their ids, from the state alone,
/// without asking for memory.

#include <hawser/outputs.h>

#include "context/context.h"
#include "world/lookup.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::world {

/// Components of OutputKind::pose, velocity, tension, drum, as the table has them.
enum PoseComponent : std::uint8_t { kRoll = 3, kPitch, kYaw, kQuaternion };
enum VelocityComponent : std::uint8_t { kTurning = 3 };
enum TensionComponent : std::uint8_t { kFirst, kLast, kLargest };
enum DrumComponent : std::uint8_t { kPaidOut, kLength };
/// Components of OutputKind::statistic. Up to kStepFigures those of a step, which a state does not
/// tell; then energies.
enum Statistic : std::uint8_t {
    kResidual,
    kRowResidual,
    kViolation,
    kStretchError,
    kNaturalMap,
    kContacts,
    kStepTime,
    kSolverTime,
    kStepFigures,
    kAsleep = kStepFigures,
    kKinetic,
    kApplied,
    kDriven,
    kDissipated,
    kFriction,
    kContactLoss,
    kDamped,
    kGravity,  ///< This one and those behind it take a pass over all interactions.
    kElastic,
    kMechanical,
};

class Outputs {
  public:
    /// A definition that has been checked, with its component and unit filled in. @throws
    /// std::bad_alloc, DefError where the name is taken.
    OutputId add(OutputDef def, int component);
    [[nodiscard]] const std::vector<OutputDef>& defs() const noexcept { return defs_; }
    /// The place of an id. @throws DefError for one of nothing.
    [[nodiscard]] std::size_t place(OutputId id) const;
    [[nodiscard]] const Names& names() const noexcept { return names_; }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }
    /// Keep the figures of a good step.
    void keep_figures(const StepStats& stats) noexcept;
    /// They are of another state than the one there is now.
    void forget_figures() noexcept { figures_.fill(0.0); }
    /// Whether some output asks for an energy that only a pass over all interactions gives.
    [[nodiscard]] bool wants_energy() const noexcept { return wants_energy_; }
    /// All values. @param energy  Where wants_energy().
    void evaluate(const stepper::StepContext& ctx, const Energy& energy) noexcept;

  private:
    std::vector<OutputDef> defs_;
    std::vector<std::uint8_t> component_;
    std::vector<double> values_;
    std::array<double, kStepFigures> figures_{};
    Names names_;
    bool wants_energy_ = false;
};

/// Check a definition and fill in its component and unit. @param bodies, interactions  Of the user.
/// @return the number of its component. @throws DefError with the nearest name or another remedy.
int check_output(OutputDef& def, const stepper::StepContext& ctx, int bodies, int interactions);

}  // namespace hawser::world
