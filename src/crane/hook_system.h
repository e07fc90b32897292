// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file hook_system.h
/// Run a hook at the start of each step (hawser/hook.h). Prestep::edits adds and removes its legs
/// and their contact shapes. Both are found by their names, which stay valid after a restore.

#include <hawser/hook.h>
#include <hawser/system.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::crane {

class HookSystem final : public System {
  public:
    explicit HookSystem(HookDef def);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override { table.hold(def_.body); }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<HookSystem>(def_);
    }

  private:
    void set_state(HookState state) noexcept { state_ = static_cast<std::int32_t>(state); }
    [[nodiscard]] const CraneLoad& load_of(int number) const noexcept {
        return def_.loads[static_cast<std::size_t>(number - 1)];
    }
    [[nodiscard]] int requested_load() const noexcept;
    [[nodiscard]] bool measure_load(const World& world) noexcept;
    void check_load(Prestep& now) noexcept;
    void remove_leg_shape(Prestep& now, std::size_t i) noexcept;
    void remove_broken_shapes(Prestep& now) noexcept;
    void detach_load(Prestep& now, EventKind kind) noexcept;
    void take(Prestep& now) noexcept;

    HookDef def_;
    std::vector<std::string> leg_names_;
    // State.
    double attach_request_ = 0.0;                 ///< Number of the load to attach, 0: none; input.
    std::int32_t attached_load_ = 0, state_ = 0;  ///< Number of the attached load; HookState.
    std::int32_t reported_ = 0;  ///< 1: the event that the load is out of reach has been reported.
    // Outputs.
    double attached_output_ = 0.0, load_ = 0.0, leg_ = 0.0, as_ = 0.0;
};

}  // namespace hawser::crane
