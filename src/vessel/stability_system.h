// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stability_system.h
/// Gauge that reads the wires and the ship in each step (hawser/stability.h). It puts no load on
/// anything. The permissible tension is renewed every kStepsBetweenUpdates steps.

#include <hawser/stability.h>
#include <hawser/system.h>

#include "vessel/stability_curve.h"

#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>

namespace hawser::vessel {

class StabilitySystem final : public System {
  public:
    static constexpr std::int64_t kStepsBetweenUpdates = 15;

    explicit StabilitySystem(std::shared_ptr<const StabilityCurve> curve);

    [[nodiscard]] std::string_view name() const noexcept override { return curve_->def().name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override { table.hold(curve_->def().body); }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<StabilitySystem>(curve_);
    }
    [[nodiscard]] const StabilityCurve& curve() const noexcept { return *curve_; }

  private:
    [[nodiscard]] double read_towline(const World& world, Vec3& along) const noexcept;
    [[nodiscard]] Vec3 other_wire_forces(const World& world) const noexcept;
    void read_wires(const World& world) noexcept;
    void read_ship(const World& world) noexcept;
    void update_alarms(Prestep& now) noexcept;

    std::shared_ptr<const StabilityCurve> curve_;
    // State and outputs.
    double tension_ = 0.0, alpha_ = 0.0, beta_ = 0.0, moment_ = 0.0, lever_ = 0.0,
           worst_beta_ = 0.0;
    double heel_gm_ = 0.0, heel_ = 0.0, gz_ = 0.0, gz_max_ = 0.0, gz_max_angle_ = 0.0;
    double static_heel_ = 0.0, area_ = 0.0, residual_ = 0.0, permissible_tension_ = 0.0;
    double criterion_ = 0.0, used_ = 0.0, alarm_ = 0.0;
    std::int32_t begun_ = 0;
};

}  // namespace hawser::vessel
