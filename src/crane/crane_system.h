// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file crane_system.h
/// Run a crane at the start of each step (hawser/crane.h). It measures the position of its hook and
/// its load, drives its motions, and attaches or releases loads.
///
/// Drives: a ramp follows the requested speed. At 0 the brake is set and the motor is off. Before a
/// motion starts, the motor is switched on and the brake is reduced to the friction of the bearing.
/// Cylinders have no brake: their motor holds them up to the limits of its force, like a locked
/// valve.
///
/// Slings: these are interactions that Prestep::edits adds and removes. They are found by their
/// names, which stay valid after a restore.

#include <hawser/crane.h>
#include <hawser/system.h>

#include "crane/common.h"

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::crane {

enum Motion : std::uint8_t { kSlew, kLuff, kKnuckle, kHoist };
inline constexpr int kMaxMotions = 4;

/// One motion and its drive.
struct Drive {
    bool exists = false;
    double max_speed = 0.0;              ///< Largest requested speed in both directions.
    double ratio = 1.0;                  ///< Speed of the motor over the requested speed.
    double low = 0.0, high = 0.0;        ///< Range of the motor's force while it runs.
    double brake = 0.0, friction = 0.0;  ///< Bound of the brake when set; when released.
    BodyId scalar{};                     ///< Drum or stroke; invalid for the slew.
    InteractionId motor{}, friction_id{};
    InputId speed{}, force_low{}, force_high{}, bound{};
    /// Length of a cylinder at the start, its lower and upper limit [m].
    double start = 0.0, shortest_length = -kUnbounded, longest_length = kUnbounded;
};

/// Bodies and interactions of a crane in a world.
struct CraneParts {
    BodyId on{}, column{}, boom{}, tip{}, hook{};  ///< `tip` is the link that the hook hangs from.
    Vec3 mount{0.0, 0.0, 0.0};  ///< Position of the mount in the frame of `on` [m].
    Quat orientation = Quat::Identity();
    /// Positions in the frames of boom and tip [m].
    Vec3 boom_pin{0, 0, 0}, tip_pin{0, 0, 0}, head{0, 0, 0};
    double luff_sign = 1.0, knuckle_sign = 1.0;  ///< Sign of dθ/dt over the requested speed.
    std::vector<InteractionId> falls{};
    std::array<Drive, kMaxMotions> drives{};
};

/// Parts of a definition that the system needs.
struct CraneTask {
    std::string name{};
    CraneHook hook{};
    CraneRating rating{};
    std::vector<CraneLoad> loads{};
    int take = 0;
    double ramp = 0.0;
};

class CraneSystem final : public System {
  public:
    CraneSystem(CraneTask task, CraneParts parts);

    [[nodiscard]] std::string_view name() const noexcept override { return definition_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<CraneSystem>(definition_, parts_);
    }

  private:
    /// State of a drive.
    struct Order {
        double wanted = 0.0;  ///< Requested speed; input.
        double ramped = 0.0;
        double speed = 0.0;  ///< Last speed sent to the motor.
        std::int32_t is_braked = 1;
    };

    void sample(const Prestep& now) noexcept;
    void measure_load(const Prestep& now) noexcept;
    void update_alarm(Prestep& now) noexcept;
    void drive(Prestep& now, int motion) noexcept;
    [[nodiscard]] bool at_end(const World& world, int motion, double wanted) const noexcept;
    [[nodiscard]] bool raises_moment(int motion, double wanted) const noexcept;
    void update_attachment(Prestep& now) noexcept;
    [[nodiscard]] bool in_reach(const World& world, const CraneLoad& load) const noexcept;
    void attach_load(Prestep& now, int number) noexcept;
    void detach_load(Prestep& now) noexcept;
    [[nodiscard]] Vec3 hook_point() const noexcept {
        return {0.0, 0.0, -0.5 * definition_.hook.height};
    }

    CraneTask definition_;
    CraneParts parts_;
    std::vector<std::string> sling_names_;

    // State.
    std::array<Order, kMaxMotions> orders_{};
    double attach_request_ = 0.0;  ///< Number of the load to attach, 0: none; input.
    double clock_ = 0.0;
    std::int32_t step_ = 0, attached_load_ = 0;
    // Outputs, part of the state.
    double radius_ = 0.0, height_ = 0.0, hoist_length_ = 0.0, load_ = 0.0, rated_ = 0.0;
    double utilisation_ = 0.0, moment_ = 0.0, alarm_ = 0.0, attached_output_ = 0.0, cut_ = 0.0;
    // Values of the current step.
    double boom_rise_ = 0.0, tip_rise_ = 0.0;  ///< Height of the head over the pins [m].
};

/// Return the rated load at a radius [kg].
[[nodiscard]] double rated_load(const CraneRating& rating, double radius) noexcept;

}  // namespace hawser::crane
