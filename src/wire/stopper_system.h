// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stopper_system.h
/// What a shark jaw or chain stopper does before each step begins (hawser/stopper.h).
///
/// Nodes are put on wires at once, before the step (System::before_step()); the joint comes and
/// goes by the edits of the step, so that the world has it from then on. The event of its coming is
/// told in the next step, when its name is there, that of its going in the step before.

#include <hawser/stopper.h>
#include <hawser/system.h>

#include "wire/place_on_wire.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace hawser::wire {

/// What a stopper would hold if it closed now.
struct StopperClaim {
    WireId wire{};
    double at = 0.0;  ///< Of the node, along the wire's material from its first end [m].
};
/// A lump so near to the place that a stopper takes is used instead of a new one [m].
inline constexpr double kStopperAtLump = 0.1;

class StopperSystem final : public System {
  public:
    explicit StopperSystem(StopperDef def);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override { table.hold(def_.body); }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<StopperSystem>(def_);
    }
    [[nodiscard]] const StopperDef& def() const noexcept { return def_; }
    /// The lump that it holds or is about to hold; invalid: none.
    [[nodiscard]] BodyId node() const noexcept { return node_; }
    /// None: no wire is within its reach.
    [[nodiscard]] std::optional<StopperClaim> claim(const World& world) const noexcept;

  private:
    [[nodiscard]] bool is(StopperState state) const noexcept {
        return state_ == static_cast<std::int32_t>(state);
    }
    void become(StopperState state) noexcept { state_ = static_cast<std::int32_t>(state); }
    [[nodiscard]] PlaceOnWire nearest(const World& world) const noexcept;
    [[nodiscard]] BodyId lump_at(NodeEdits& nodes, const PlaceOnWire& found) noexcept;
    void take(NodeEdits& nodes) noexcept;
    void drop_idle(NodeEdits& nodes) noexcept;
    void make_joint(Prestep& now) noexcept;
    void hold(Prestep& now) noexcept;
    void let_go(Prestep& now) noexcept;
    void tell(const World& world, const PlaceOnWire& found) noexcept;

    StopperDef def_;
    std::string joint_name_;
    // State.
    double close_ = 0.0;
    std::int32_t state_ = 0, after_ = 0;  ///< StopperState; what follows where it lets go.
    std::int32_t told_ = 1;               ///< 0: an event is due.
    std::int32_t idle_steps_ = 0;
    BodyId node_{}, put_{};         ///< Held; put there by it; to go.
    std::array<BodyId, 8> idle_{};  ///< Once put there, to go.
    InteractionId joint_{};
    double came_in_ = 0.0;  ///< Through a chain stopper, past its node [m].
    double place_[3] = {};  ///< Of the node as it was taken, in the body's frame [m].
    double far_ = 0.0;      ///< Then from the stopper [m].
    // Outputs.
    double shown_ = 0.0, held_ = 0.0, load_ = 0.0, at_ = 0.0;
};

}  // namespace hawser::wire
