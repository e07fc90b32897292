// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchor_system.h
/// Soil on a drag-embedment anchor (hawser/anchor.h).
///
/// Each step computes the bounds of the rows from the force p on the anchor. p is the force of the
/// lines at the anchor. Without lines it follows from the equation of motion, p = m Δv/h − F with
/// the force F of the rows. Both horizontal rows together resist H cos θ in the direction of p:
/// ```
///     bound_i = √(H² − |p|² + p_i²)  if |p| ≤ H        bound_i = H |p_i|/|p|  otherwise
/// ```
/// Under a load below the capacity every row is below its bound. Under a larger load the anchor
/// slides in the direction of the load.

#include <hawser/anchor.h>
#include <hawser/system.h>

#include "vessel/anchor_law.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

namespace hawser::vessel {

/// Rows of an anchor and the inputs of their bounds.
struct AnchorRows {
    std::array<InteractionId, 3> slide{}, turn{};
    std::array<InputId, 3> slide_bound{}, turn_bound{};
    bool grounded = false;  ///< True: on the seabed at the start.
    bool carried = false;   ///< True: the body has shapes, whose contacts bear its weight.
    double mass = 0.0;      ///< Mass of the body [kg].
};

/// Bounds of the rows before the first step, without a line [N, N m].
struct AnchorBounds {
    double level = 0.0, up = 0.0, turn = 0.0;
};
[[nodiscard]] AnchorBounds first_bounds(const AnchorDef& def, bool carried, bool grounded);

class AnchorSystem final : public System {
  public:
    AnchorSystem(AnchorDef def, const AnchorRows& rows);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<AnchorSystem>(def_, rows_);
    }
    [[nodiscard]] AnchorView view() const;

  private:
    void read_last_step(const Prestep& now) noexcept;
    void follow_drag(Prestep& now) noexcept;
    void break_out(Prestep& now) noexcept;
    void set_bounds(Prestep& now) noexcept;
    void set_if_changed(Prestep& now, InputId input, double& last, double value) const noexcept;

    AnchorDef def_;
    AnchorCapacity law_;
    AnchorRows rows_;
    // State.
    double drag_, previous_drag_ = 0.0, scraped_ = 0.0;
    std::int32_t set_, begun_ = 0, dragging_ = 0, on_ground_ = 0;
    std::int32_t still_steps_ =
        0;  ///< Number of steps since the anchor last slid, limited to the steps of kMinRestTime.
    double last_[3] = {};      ///< Position of the point in the last step [m].
    double speed_[3] = {};     ///< Velocity of the body in the last step but one [m/s].
    double bound_[3] = {};     ///< Bounds of the sliding rows [N].
    double turn_bound_ = 0.0;  ///< Bound of the rotation rows [N m].
    double pull_[3] = {};      ///< Force of the lines; without lines, the force on the anchor [N].
    // Outputs.
    double capacity_ = 0.0, tension_ = 0.0, angle_ = 0.0, set_output_ = 0.0, depth_ = 0.0;
    double breakout_ = 0.0, utilisation_ = 0.0;
    // Derived values at the beginning of a step.
    double lift_ = 0.0;                    ///< Vertical force on the anchor without its weight [N].
    double moved_ = 0.0;                   ///< Horizontal distance in the last step [m].
    bool slides_ = false, lifts_ = false;  ///< At their bounds in the last step.
};

}  // namespace hawser::vessel
