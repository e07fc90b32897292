// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file end_stops.h
/// End stops of lines at their last turning point (hawser/route.h, stop_ends()).
///
/// ```
///     end ●──── part ────(o)═══ line ═══      rest length of the part:  l = l₀ + r (q − q₀)
///                       point, slide q
/// ```
/// If a step would end with l + r q̇ h < ε l₀ (ε = 1 %) while the line runs out, the slide receives
/// the damping D = T/v. It balances the tension T at the speed v = 1e-6 m/s, so the slide is
/// almost at rest. The damping does not act when the line runs back. The stop has no state: its
/// condition follows from coordinate and speed of the slide.

#include <hawser/system.h>

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace hawser::wire {

class EndStops final : public System {
  public:
    EndStops(std::string name, std::vector<InteractionId> parts)
        : name_(std::move(name)), parts_(std::move(parts)) {}

    [[nodiscard]] std::string_view name() const noexcept override { return name_; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<EndStops>(name_, parts_);
    }

  private:
    std::string name_;
    std::vector<InteractionId> parts_;
};

}  // namespace hawser::wire
