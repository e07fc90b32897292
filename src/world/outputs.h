// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file outputs.h
/// Outputs of a world. They are evaluated in the order of their ids from the state alone, without
/// allocation.

#include <hawser/outputs.h>
#include <hawser/system.h>

#include "base/places.h"
#include "context/context.h"
#include "world/lookup.h"
#include "world/systems.h"
#include "world/wire_list.h"

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::world {

/// Components of OutputKind::pose, velocity, tension, drum, in the order of the table.
enum PoseComponent : std::uint8_t { kRoll = 3, kPitch, kYaw, kQuaternion };
enum VelocityComponent : std::uint8_t { kTurning = 3 };
enum TensionComponent : std::uint8_t { kFirst, kLast, kLargest };
enum DrumComponent : std::uint8_t { kPaidOut, kLength };
/// Components of OutputKind::statistic. Those up to kStepFigures are figures of a step, which a
/// state does not contain. Energies follow.
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
    kGravity,  ///< This one and the following ones need a pass over all interactions.
    kElastic,
    kMechanical,
};

class Outputs {
  public:
    /// Add a checked definition with its component and unit.
    /// @throws std::bad_alloc; DefError if the name is in use.
    OutputId add(OutputDef def, int component);
    /// Add an output for a signal of a system, which must live as long.
    /// @throws as add().
    OutputId add(const SystemSignal& signal);
    void remove(std::size_t place) noexcept;
    /// Remove all signals of a system that is removed.
    void remove_signals(std::string_view system) noexcept;
    /// Replace the signals by those of systems with the same definition, after a copy of the world.
    void bind(std::span<const SystemSignal> signals) noexcept;
    [[nodiscard]] bool alive(OutputId id) const noexcept { return slots_.names(id); }
    [[nodiscard]] std::span<const OutputId> ids() const noexcept { return ids_; }
    [[nodiscard]] OutputId id(std::int32_t place) const noexcept {
        return slots_.id<OutputId>(place);
    }
    [[nodiscard]] const std::vector<OutputDef>& defs() const noexcept { return defs_; }
    /// Return the index of an id.
    /// @throws DefError if it does not exist.
    [[nodiscard]] std::size_t index_of(OutputId id) const;
    [[nodiscard]] const Names& names() const noexcept { return names_; }
    [[nodiscard]] const std::vector<double>& values() const noexcept { return values_; }
    /// Store the figures of a successful step.
    void store_figures(const StepStats& stats) noexcept;
    /// Clear figures that belong to another state.
    void forget_figures() noexcept { figures_.fill(0.0); }
    /// Return true if an output needs an energy that requires a pass over all interactions.
    [[nodiscard]] bool needs_energy() const noexcept { return needs_energy_; }
    /// Evaluate all outputs.
    /// @param energy  Used if needs_energy().
    void evaluate(const World& world, const context::StepContext& ctx, const WireList& wires,
                  const Systems& systems, const Energy& energy) noexcept;

  private:
    std::vector<OutputDef> defs_;
    std::vector<std::uint8_t> component_;
    std::vector<const double*> signal_;  ///< Signal of a system; null: none.
    std::vector<double> values_;
    std::array<double, kStepFigures> figures_{};
    Names names_;
    base::Slots slots_;
    std::vector<OutputId> ids_;  ///< Ids of existing outputs, ascending.
    bool needs_energy_ = false;
};

/// Check a definition and fill in its component and unit.
/// @param bodies, interactions  Numbers of user objects.
/// @return the number of its component.
/// @throws DefError with the nearest name or another remedy.
int check_output(OutputDef& def, const context::StepContext& ctx, const WireList& wires, int bodies,
                 int interactions);

}  // namespace hawser::world
