// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch_system.h
/// System of a winch (hawser/winch.h).
///
/// *Layers.* Turning changes the length L on the drum: L' = L − r Δθ, with the radius r of the
/// last step. The layer follows from L. When the layer changes, the element's radius changes. Its
/// length and drum_zero change too, so that the rest length, the tension and the energy do not
/// jump. Within a step r is constant, so the work of the wire, T r Δθ, equals that on the drum.
///
/// *Wound wire.* The drum's body has the inertia of the bare drum. The inertia of the wire on it,
/// J(L), is added mass A of a load. Wire that leaves the drum moves as the drum does. It carries
/// its own momentum dJ ω along and leaves ω unchanged, which is the effect of a changed A (Loads).
/// The energy ½ dJ ω² counts as work of systems.
///
/// *Nodes.* The element at the drum has the material a [m], a' = −L'. Half of it acts on its
/// first node by a load with its weight, mass and drag. The other half acts on the fairlead and,
/// along the wire, on the drum. The tension at the fairlead is therefore that of the element plus
/// the weight of half of it. Both halves change with a as the inertia of the wound wire does. A
/// node inserted with a piece f takes f from a, and half of f goes to each of two nodes. The load
/// on the fairlead is unchanged.
///
/// *Clutch.* An engaged clutch adds the motor's inertia J_m to A. A motor at rest is accelerated
/// in one step, (J + J_m) ω₊ = J ω, by the force −J_m ω/h in addition to A. The loss counts as work
/// of systems.

#include <hawser/system.h>
#include <hawser/winch.h>

#include "wire/drum_geometry.h"
#include "wire/gypsy.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace hawser::wire {

/// Inputs of interactions that a winch system drives.
struct WinchInputs {
    InputId speed, low, high;                 ///< Motor.
    InputId hold, back;                       ///< Brake.
    InputId radius, length, drum_zero;        ///< Element.
    InputId grip_speed, grip_low, grip_high;  ///< Grip of a gypsy.
    InputId end;                              ///< Bitter end of a gypsy.
};

/// Drum or gypsy of a winch.
struct WinchWheel {
    DrumGeometry drum{};
    std::optional<GypsyWheel> gypsy{};  ///< Replaces the drum.
};

class WinchSystem final : public System {
  public:
    /// Create the system of a winch.
    /// @param at_drum  Material of the element at the drum [m].
    WinchSystem(WinchDef def, const WinchWheel& wheel, const WinchIds& ids,
                const WinchInputs& inputs, double at_drum);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override {
        // May be negative if more wire was hauled than existed.
        return element == ids_.line && makes_nodes() && parted_ == 0
                   ? def_.mass_per_length * at_drum_
                   : 0.0;
    }
    /// Return the length paid out, by the count of the wire on the drum.
    [[nodiscard]] double paid_out(const World& world,
                                  InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<WinchSystem>(def_, WinchWheel{drum_, wheel_}, ids_, inputs_,
                                             at_drum_);
    }

  private:
    /// Speed and bounds of motor and brake in the step that begins [rad/s, N m].
    struct MotorOrders {
        double speed = 0.0, low = 0.0, high = 0.0;
        double hold = 0.0, back = 1.0;
    };
    /// Last value of each input, so that it is set only when it changes.
    struct LastInputs {
        double speed, low, high, hold, back;
    };

    /// State of protection and compensation.
    struct Aids {
        double aops = 1.0, mops = 0.0;                                  // inputs
        double out = 0.0, rate = 0.0, peak = 0.0, protection_on = 0.0;  // outputs: wire_out and on
        double lost_length = 0.0, error = 0.0;                          // overload_out, heave_error
        double first = 0.0;                    ///< Wire outboard less that paid out since [m].
        double height = 0.0, paid = 0.0;       ///< At the begin of the compensation [m].
        double pull = 0.0;                     ///< Value in the last step [N].
        double speed = 0.0;                    ///< Speed of the compensation [m/s].
        std::int32_t is_begun = 0;             ///< `first` is known.
        std::int32_t balances_inertia = 0;     ///< The drive balances the drum's inertia.
        std::int32_t pays_out_protection = 0;  ///< The protection pays out.
        std::int32_t compensates_heave = 0;    ///< The compensation has begun.
    };

    void sample(const Prestep& now) noexcept;
    void count_slip(Prestep& now) noexcept;
    void count_rendering(Prestep& now) noexcept;
    void follow_layer(Prestep& now) noexcept;
    void follow_chain(const GypsyWheel& wheel, Prestep& now, Loads& loads) noexcept;
    [[nodiscard]] DrumGeometry::Place wire_end() const noexcept;
    [[nodiscard]] double leaving_radius() const noexcept;
    [[nodiscard]] double wound_inertia() const noexcept;
    /// Return the body that pays out the element at the drum.
    [[nodiscard]] BodyId paying_out_body() const noexcept {
        return wheel_ ? ids_.chain : ids_.drum;
    }
    void check_fastening(Prestep& now) noexcept;
    void count_release(Prestep& now) noexcept;
    // True if overload protection or heave compensation is defined, which have signals and state
    // (winch_aids.cpp).
    [[nodiscard]] bool has_aids() const noexcept {
        return def_.overload_limit > 0.0 || def_.heave_speed > 0.0;
    }
    void visit_aids(StateVisitor& visitor);
    void check_aids(StateRules& rules) const;
    void add_aid_signals(SignalTable& table);
    void follow_aids(Prestep& now) noexcept;
    void follow_heave(const Prestep& now) noexcept;
    [[nodiscard]] double max_tension() const noexcept;
    void limit_overload(MotorOrders& out) const noexcept;
    [[nodiscard]] MotorOrders orders() noexcept;
    void order_motor(MotorOrders& out) noexcept;
    void apply_orders(Prestep& now, const MotorOrders& orders) noexcept;
    void add_line_inertia(const Prestep& now, Loads& loads) noexcept;
    void weigh_element(const World& world, Loads& loads) const noexcept;
    [[nodiscard]] Vec3 weight_of_half(const World& world) const noexcept;
    [[nodiscard]] bool carries_body(const World& world) const noexcept;
    [[nodiscard]] Vec3 element_chord(const World& world) const noexcept;
    [[nodiscard]] bool makes_nodes() const noexcept { return def_.element > 0.0; }
    [[nodiscard]] std::size_t node_slot(const World& world) const noexcept;
    [[nodiscard]] WinchMode mode() const noexcept;
    [[nodiscard]] bool is_hauled_in() const noexcept;

    WinchDef def_;
    DrumGeometry drum_;
    std::optional<GypsyWheel> wheel_;
    GypsyChain chain_;
    WinchIds ids_;
    WinchInputs inputs_;

    // Inputs.
    double mode_, speed_, tension_, brake_ = 1.0, clutch_ = 1.0;
    // State.
    double stored_, at_drum_, angle_ = 0.0, radius_ = 0.0, clock_ = 0.0;
    double slip_ = 0.0, heat_ = 0.0;
    LastInputs last_inputs_;
    GripOrder grip_set_{0.0, -1e30, 1e30};
    double end_set_ = 0.0;  ///< Bound of the bitter end [N m].
    std::int32_t slipping_ = 0, parted_ = 0, empty_ = 0, released_ = 0, engaged_ = 1;
    std::int32_t rendering_ = 0;
    Aids aids_;
    // Outputs.
    double layer_ = 1.0, wraps_ = 0.0, across_ = 0.0, pull_ = 0.0, pull_limit_ = 0.0;
    double inertia_ = 0.0, state_ = 0.0;
    // Values of the step that begins.
    /// Turn of the wire [rad]; speed of the drum; speed of the wire [rad/s].
    double turned_ = 0.0, omega_ = 0.0, leaving_ = 0.0;
    bool insertion_failed_ = false;  ///< True if a node could not be inserted for the first time.
    /// True if the element at the drum is or will soon be at its least length.
    bool hauled_in_ = false;
    bool is_at_min_length_ = false;  ///< True if it is at its least length.
    bool began_to_jam_ = false;      ///< True if it reached its least length in the last step.
};

}  // namespace hawser::wire
