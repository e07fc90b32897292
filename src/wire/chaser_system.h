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
        return is(ChaserState::on) ? guide_->carried_mass(element) : 0.0;
    }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<ChaserSystem>(def_);
    }

  private:
    /// Event that the next prestep reports.
    enum class Due : std::int32_t { nothing, taken, missed, let_go };

    [[nodiscard]] bool is(ChaserState state) const noexcept {
        return state_ == static_cast<std::int32_t>(state);
    }
    void become(ChaserState state, Due due) noexcept {
        state_ = static_cast<std::int32_t>(state);
        due_ = static_cast<std::int32_t>(due);
    }
    [[nodiscard]] PointOnWire nearest(const World& world) const;
    void take(NodeEdits& nodes);
    void let_go(NodeEdits& nodes);
    void sample(const World& world);
    void tell(Prestep& now) noexcept;

    ChaserDef def_;
    // State.
    std::unique_ptr<GuideSystem> guide_;
    double close_ = 0.0;
    double value_ = 0.0;  ///< Value of the due event.
    std::int32_t state_ = 0, due_ = 0;
    std::int32_t reached_ = 0;  ///< End that was reported.
    std::int32_t wait_ = 0;     ///< Steps until the next try.
    // Outputs.
    double shown_ = 0.0, held_ = 0.0, at_ = 0.0, left_ = 0.0, arrived_ = 0.0, angle_ = 0.0;
    double speed_ = 0.0;
    double tension_[2] = {};
};

}  // namespace hawser::wire
