// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pin_system.h
/// System of a guide pin (hawser/pin.h). It moves the pin to the requested height at its speed.
/// Near the target it moves by half of the remaining way per step, until 1 mm remains.

#include <hawser/pin.h>
#include <hawser/system.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hawser::wire {

/// Inputs that a pin system drives.
struct PinDrive {
    InteractionId motor{};
    InputId speed{};
    double length = 0.0;     ///< Distance between up and down [m].
    double max_speed = 0.0;  ///< [m/s]
};

class PinSystem final : public System {
  public:
    PinSystem(std::string name, const PinDrive& drive, bool up)
        : name_(std::move(name)), drive_(drive), up_(up ? 1.0 : 0.0), height_(up_) {}

    [[nodiscard]] std::string_view name() const noexcept override { return name_; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<PinSystem>(name_, drive_, false);
    }

  private:
    std::string name_;
    PinDrive drive_;
    // State.
    double up_, height_, speed_ = 0.0;  ///< Requested and actual height, 1: up; speed [m/s].
};

}  // namespace hawser::wire
