// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_system.h
/// System of a guide (hawser/guide.h).
///
/// *Stops.* If a side is nearly used up and no node could be removed, the bound of the friction is
/// raised, so that it holds the slide. It is lowered when the slide is pulled back, that is when
/// the stop would have to push. If the wire ends there (lift.h), it runs off instead, and the guide
/// has no wire from then on.
///
/// The length dq that runs through moves from the material before to the material behind. The
/// straight part of length L to the node on each side decides when nodes are inserted or removed.
/// Material on the wheel has no nodes.
///
/// *Open guides* (GuideDef::closed) have the data of visit_geometry() in their state: after a wire
/// has returned, its parts are new interactions.
/// ```
///              a
///               \ L = √(d² − R²)         d from the axis to the node, square to the axis
///          R .-'-\'
///           (  c  )
/// ```

#include <hawser/guide.h>
#include <hawser/system.h>
#include <hawser/world.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>

namespace hawser::wire {

class GuideSystem final : public System {
  public:
    /// Create the system of a guide.
    /// @param material  Material of the elements before and behind [m].
    /// @param stop  Input: friction force in addition to that of the angle.
    GuideSystem(GuideDef def, const Guide& ids, InputId stop,
                const std::array<double, 2>& material);
    /// Call the visitor for the variable data of a guide at a bollard: position of the wire on it,
    /// and geometry.
    void visit_geometry(StateVisitor& visitor);
    /// Check the restored data of visit_geometry().
    void check_position(const World& world, StateRules& rules) const;
    /// Start with a wire that runs over the guide at a speed [m/s].
    void begin_at(double speed) noexcept { speed_ = speed; }

    [[nodiscard]] const GuideDef& def() const noexcept { return def_; }
    [[nodiscard]] const Guide& ids() const noexcept { return ids_; }
    [[nodiscard]] const std::array<double, 2>& material() const noexcept { return material_; }
    [[nodiscard]] const std::array<double, 2>& tension() const noexcept { return tension_; }
    [[nodiscard]] double angle() const noexcept { return angle_; }
    [[nodiscard]] double slide() const noexcept { return slide_; }
    [[nodiscard]] double speed() const noexcept { return speed_; }
    /// True if the guide no longer acts on a wire, because the wire has broken at the guide or has
    /// run off.
    [[nodiscard]] bool parted() const noexcept { return parted_ != 0; }
    [[nodiscard]] bool has_run_off() const noexcept { return parted_ >= kRunsOff; }
    /// True if the wire has left a guide without upper roller; it may return.
    [[nodiscard]] bool lifted() const noexcept { return parted_ == kLiftedState; }
    /// Return the side of the wire that is used up, 0: before the guide, 1: behind it; −1: none.
    [[nodiscard]] int used_up_side() const noexcept { return used_up_side_; }
    /// Return the force by which the wire presses on the wheel, for small angles [N]: its tension
    /// times the angle, plus the weight of the half elements towards the wheel. A negative value
    /// means that the wheel would have to pull the wire.
    /// @param slack  Angle that counts as straight [rad].
    [[nodiscard]] double pressing_force(const World& world, double slack) const noexcept;

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    /// Result of slide_sideways().
    struct Sideways {
        double by = 0.0;           ///< Displacement of the wire along the axis [m].
        bool reached_end = false;  ///< True if the wire would leave its range; it has not moved.
    };
    /// Move the wire along the axis of the bollard if its sideways pull exceeds friction
    /// (sideways.h). Call after before_step().
    /// @param room  Range down and up the axis [m].
    Sideways slide_sideways(NodeEdits& nodes, const std::array<double, 2>& room) noexcept;

    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<GuideSystem>(def_, ids_, stop_, material_);
    }

  private:
    [[nodiscard]] InteractionId element(std::size_t side) const noexcept {
        return side == 0 ? ids_.before : ids_.behind;
    }
    [[nodiscard]] bool parts_intact(const World& world) const noexcept {
        return parted_ == 0 && world.intact(ids_.before) && world.intact(ids_.behind);
    }
    [[nodiscard]] double straight(const World& world, std::size_t side) const noexcept;
    /// Return half of the mass of the element on a side that is not lumped at nodes [kg].
    [[nodiscard]] double half_mass(std::size_t side) const noexcept;
    /// Return true if the wire runs out of a side.
    [[nodiscard]] bool runs_out(std::size_t side) const noexcept {
        return (side == 0 ? -speed_ : speed_) < 0.0;
    }
    /// Return true if a side is nearly used up and the wire still runs out of it.
    [[nodiscard]] bool is_nearly_used_up(const World& world, std::size_t side) const noexcept;
    /// Release a wire from the guide if its end has reached the turning point.
    void release_at_end(NodeEdits& nodes) noexcept;
    /// Disengage a wire that would pull at a guide without upper roller, and engage it again when
    /// it returns (guide_open.cpp).
    void update_lift(NodeEdits& nodes) noexcept;
    void return_to_wheel(NodeEdits& nodes) noexcept;
    /// Engage the wire with an open guide to which it returns. @param along  Speed of the wire
    /// [m/s]. @param kept  Rest length that the removal of a node has just taken from the wire [m].
    bool reengage(NodeEdits& nodes, InteractionId element, double along, double kept);
    /// Damp a wire that lands on an open guide, in steps that do not resolve the landing.
    void damp_landing(const World& world, Loads& loads) noexcept;
    void stop(Prestep& now) noexcept;
    void sample(const World& world) noexcept;
    void load_end_masses(const World& world, Loads& loads) const noexcept;

    GuideDef def_;
    Guide ids_;
    InputId stop_;
    // State.
    std::array<double, 2> material_;
    double slide_ = 0.0;
    double bound_ = 0.0;  ///< Bound of its friction in addition to the elements' tensions [N].
    /// 1: the wire has broken in it. kRunsOff: it has run off, to be reported. kReportedOff:
    /// reported.
    std::int32_t parted_ = 0;
    static constexpr std::int32_t kRunsOff = 2, kReportedOff = 3;
    static constexpr std::int32_t kLiftedState = 4;  ///< State of an open guide without a wire.
    std::int32_t landing_steps_left_ = 0;            ///< Steps of landing that are left.
    std::int32_t used_up_side_ = -1;  ///< Side that has nothing left to run, −1: none.
    // Outputs.
    double angle_ = 0.0, speed_ = 0.0;
    std::array<double, 2> tension_{};
    /// Lengths of inserted elements on each side, by room.h [m].
    std::array<double, 2> length_{def_.element_length, def_.element_length};
    double half_element_weight_ = 0.0;  ///< Weight of the half elements along the wire [N].
};

}  // namespace hawser::wire
