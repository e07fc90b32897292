// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file guide_system.h
/// What a guide does at the beginning of each step (hawser/guide.h).
///
/// *Stops.* Where a side has next to nothing left and no node could go, the slide is held by its
/// friction, whose bound is raised for it, until what holds it would have to push: until it is
/// pulled back. Where the wire ends there (lift.h) it runs off instead, and the guide has none
/// from then on.
///
/// What runs through, dq of the slide, comes off the material before and goes onto that behind. The
/// straight part to the node on each side, of length L, says when nodes come and go: material that
/// lies on the wheel has none.
///
/// *Open guides* (GuideDef::closed) have what visit_place() visits among their state: after a wire
/// came back its parts are others.
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
    /// @param material  Of the elements before and behind [m].
    /// @param stop  The force of its friction beside that of the angle.
    GuideSystem(GuideDef def, const Guide& ids, InputId stop,
                const std::array<double, 2>& material);
    /// What is not the same for all times where a post has it: what lies on it, and how.
    void visit_place(StateVisitor& visitor);
    /// Check the numbers of visit_place().
    void check_place(const World& world, StateRules& rules) const;
    /// The wire runs through from the start [m/s].
    void begin_at(double speed) noexcept { speed_ = speed; }

    [[nodiscard]] const GuideDef& def() const noexcept { return def_; }
    [[nodiscard]] const Guide& ids() const noexcept { return ids_; }
    [[nodiscard]] const std::array<double, 2>& material() const noexcept { return material_; }
    [[nodiscard]] const std::array<double, 2>& tension() const noexcept { return tension_; }
    [[nodiscard]] double angle() const noexcept { return angle_; }
    [[nodiscard]] double slide() const noexcept { return slide_; }
    [[nodiscard]] double speed() const noexcept { return speed_; }
    /// It acts on nothing any more: the wire has parted in it, or run off.
    [[nodiscard]] bool parted() const noexcept { return parted_ != 0; }
    [[nodiscard]] bool ran_off() const noexcept { return parted_ >= kRunsOff; }
    /// The wire has left it, as it has no upper roller, and may come back.
    [[nodiscard]] bool lifted() const noexcept { return parted_ == kLifted; }
    /// Side that has nothing left to run, 0 before it, 1 behind it; −1: both have.
    [[nodiscard]] int stopped() const noexcept { return stopped_; }
    /// What the wire presses on the wheel with, for small angles [N]: its tension by the angle, and
    /// the weight of the half elements that is put on the guide, where it points to the wheel.
    /// Below 0 the wheel would have to hold the wire. @param slack  Angle that does not count
    /// [rad].
    [[nodiscard]] double pressing(const World& world, double slack) const noexcept;

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    /// What came of slide_sideways().
    struct Sideways {
        double by = 0.0;       ///< How far the wire has gone along the axis [m].
        bool off_end = false;  ///< It would go beyond its room, and has not gone.
    };
    /// The wire goes along the axis where it pulls that way by more than friction holds
    /// (sideways.h). After before_step(). @param room  Down and up the axis [m].
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
    [[nodiscard]] bool whole(const World& world) const noexcept {
        return parted_ == 0 && world.intact(ids_.before) && world.intact(ids_.behind);
    }
    [[nodiscard]] double straight(const World& world, std::size_t side) const noexcept;
    /// Of what no lump has of an element [kg].
    [[nodiscard]] double half_mass(std::size_t side) const noexcept;
    /// Whether the wire runs through from a side to the other.
    [[nodiscard]] bool runs_out(std::size_t side) const noexcept {
        return (side == 0 ? -speed_ : speed_) < 0.0;
    }
    /// Whether what is left on a side is next to nothing, and going.
    [[nodiscard]] bool nearly_used_up(const World& world, std::size_t side) const noexcept;
    /// Lets go of a wire that ends where it runs out.
    void run_off(NodeEdits& nodes) noexcept;
    /// Without an upper roller (guide_open.cpp): lets go of a wire that would pull at it, and takes
    /// one that comes back.
    void lift(NodeEdits& nodes) noexcept;
    void come_back(NodeEdits& nodes) noexcept;
    /// @param along  Speed of the wire [m/s]. @param kept  Rest length beside the element's [m].
    bool lay_back(NodeEdits& nodes, InteractionId element, double along, double kept);
    /// Damp a wire that lands on an open guide, in steps that do not resolve the landing.
    void land(const World& world, Loads& loads) noexcept;
    void stop(Prestep& now) noexcept;
    void look(const World& world) noexcept;
    void weigh(const World& world, Loads& loads) const noexcept;

    GuideDef def_;
    Guide ids_;
    InputId stop_;
    // State.
    std::array<double, 2> material_;
    double slide_ = 0.0;
    double bound_ = 0.0;  ///< Of its friction, beside the elements' tensions [N].
    /// 1: the wire has parted in it. Or it has run off, which is to be told, or is.
    std::int32_t parted_ = 0;
    static constexpr std::int32_t kRunsOff = 2, kRanOff = 3;
    static constexpr std::int32_t kLifted = 4;  ///< Of an open guide: no wire lies on it.
    std::int32_t wait_ = 0;                     ///< Steps of landing that are left.
    std::int32_t stopped_ = -1;                 ///< Side that has nothing left to run, −1: none.
    // Outputs.
    double angle_ = 0.0, speed_ = 0.0;
    std::array<double, 2> tension_{};
    /// Of elements that come and go on each side, as room.h has it [m].
    std::array<double, 2> length_{def_.element_length, def_.element_length};
    double hanging_ = 0.0;  ///< Weight of the half elements along the wire [N].
};

}  // namespace hawser::wire
