// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stopper_system.h
/// System of a shark jaw or chain stopper (hawser/stopper.h).
///
/// Nodes are inserted at once, before the step (System::before_step()). The joint is added and
/// removed by the edits of the step. The event of its addition is reported in the next step, when
/// its name exists. The event of its removal is reported in the step before.

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

/// The node that a stopper would hold if it closed now.
struct StopperClaim {
    WireId wire{};
    double at = 0.0;  ///< Position of the node along the wire's material from its first end [m].
};
/// Distance within which a stopper uses an existing node instead of a new one [m].
inline constexpr double kStopperAtNode = 0.1;

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
    /// Return the node that the stopper holds or is about to hold; invalid: none.
    [[nodiscard]] BodyId node() const noexcept { return node_; }
    /// Return the node of a wire that the stopper would hold if it closed now. It is empty if no
    /// wire is within reach.
    [[nodiscard]] std::optional<StopperClaim> node_to_hold(const World& world) const noexcept;

  private:
    [[nodiscard]] bool in_state(StopperState state) const noexcept {
        return state_ == static_cast<std::int32_t>(state);
    }
    void set_state(StopperState state) noexcept { state_ = static_cast<std::int32_t>(state); }
    [[nodiscard]] PointOnWire nearest_wire_point(const World& world) const noexcept;
    [[nodiscard]] BodyId node_at(NodeEdits& nodes, const PointOnWire& found) noexcept;
    void close_on_wire(NodeEdits& nodes) noexcept;
    void remove_idle_nodes(NodeEdits& nodes) noexcept;
    void make_joint(Prestep& now) noexcept;
    void update_hold(Prestep& now) noexcept;
    void release_wire(Prestep& now) noexcept;
    void report_joint(const World& world, const PointOnWire& found) noexcept;

    StopperDef def_;
    std::string joint_name_;
    // State.
    double close_ = 0.0;
    std::int32_t state_ = 0, after_ = 0;  ///< StopperState; state after the release.
    std::int32_t reported_ = 1;           ///< 0: an event is due.
    std::int32_t idle_steps_ = 0;
    BodyId node_{}, inserted_{};          ///< Node held; node that it inserted.
    std::array<BodyId, 8> idle_nodes_{};  ///< Inserted earlier, to be removed.
    InteractionId joint_{};
    double hauled_length_ = 0.0;  ///< Length hauled through a chain stopper past its node [m].
    double closing_position_[3] =
        {};                          ///< Position of the node at closing, in the body's frame [m].
    double closing_distance_ = 0.0;  ///< Its distance from the stopper at closing [m].
    // Outputs.
    double state_output_ = 0.0, wire_output_ = 0.0, load_ = 0.0, at_ = 0.0;
};

}  // namespace hawser::wire
