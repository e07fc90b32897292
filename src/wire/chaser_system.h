// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file chaser_system.h
/// System of a chaser (hawser/chaser.h): closes on a wire and releases it before a step. The wire
/// in the ring runs over a guide on the ring, which exists while the ring is closed.

#include <hawser/chaser.h>
#include <hawser/system.h>

#include "wire/guide_system.h"
#include "wire/place_on_wire.h"

#include <cstdint>
#include <memory>
#include <string_view>

namespace hawser::wire {

class ChaserSystem final : public System {
  public:
    explicit ChaserSystem(ChaserDef def);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override {
        return in_state(ChaserState::on) ? guide_->carried_mass(element) : 0.0;
    }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<ChaserSystem>(def_);
    }

  private:
    /// Event that the next prestep reports.
    enum class Due : std::int32_t { nothing, taken, missed, let_go };

    [[nodiscard]] bool in_state(ChaserState state) const noexcept {
        return state_ == static_cast<std::int32_t>(state);
    }
    void set_state(ChaserState state, Due due) noexcept {
        state_ = static_cast<std::int32_t>(state);
        due_event_ = static_cast<std::int32_t>(due);
    }
    [[nodiscard]] PointOnWire nearest_wire_point(const World& world) const;
    void close_on_wire(NodeEdits& nodes);
    void open_ring(NodeEdits& nodes);
    void sample(const World& world);
    void report_events(Prestep& now) noexcept;

    ChaserDef def_;
    // State.
    std::unique_ptr<GuideSystem> guide_;
    double close_ = 0.0;
    double value_ = 0.0;  ///< Value of the due event.
    std::int32_t state_ = 0, due_event_ = 0;
    std::int32_t reached_ = 0;            ///< End that was reported.
    std::int32_t steps_until_retry_ = 0;  ///< Steps until the next try.
    // Outputs.
    double state_output_ = 0.0, wire_output_ = 0.0, start_distance_ = 0.0, end_distance_ = 0.0,
           arrived_ = 0.0, angle_ = 0.0;
    double speed_ = 0.0;
    double tension_[2] = {};
};

}  // namespace hawser::wire
