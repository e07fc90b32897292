// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file pin_system.h
/// Drives a guide pin to where it is wanted (hawser/pin.h): at its speed, and where that would be
/// more in a step, by half of what is left, until 1 mm is left.

#include <hawser/pin.h>
#include <hawser/system.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>

namespace hawser::wire {

/// What a pin system drives.
struct PinDrive {
    InteractionId motor{};
    InputId speed{};
    double length = 0.0;  ///< From up to down [m].
    double most = 0.0;    ///< [m/s]
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
    double up_, height_, speed_ = 0.0;  ///< Wanted, and where it is, 1: up; [m/s].
};

}  // namespace hawser::wire
