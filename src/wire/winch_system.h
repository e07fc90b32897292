// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch_system.h
/// What a winch does at the beginning of each step (hawser/winch.h).
///
/// **Layers.** The length L on the drum is what turns take from it, L' = L − r Δθ, r the radius
/// that the last step had. The layer follows from L. Where it changes, the element's radius does,
/// with its length and drum_zero so that the rest length of now is what it was: tension and energy
/// do not jump. Within a step r is constant, so that the work of the wire, T r Δθ, is that on the
/// drum.
///
/// **Wound wire.** The drum's body has the bare drum's inertia; that of the wire on it, J(L), is
/// added mass A of a load. Wire that leaves the drum moves as the drum does, so that it takes its
/// own momentum dJ ω along and leaves ω as it was: just what a changed A does (Loads). The energy
/// ½ dJ ω² that goes with it is booked as work of systems.
///
/// **Nodes.** The element at the drum has the material a [m], a' = −L'. Half of it acts on its
/// first node by a load, with its weight, mass and drag, half on the fairlead and, along the wire,
/// on the drum; so that the tension at the fairlead is that of the element and the weight of half
/// of it. Both halves change with a as the wound wire's inertia does. A node that comes with the
/// piece f takes f from a, and half of f into each of two lumps: what the fairlead feels stays.
///
/// **Clutch.** Engaged it adds the motor's inertia J_m to A. A motor that stood is taken along in
/// one step, (J + J_m) ω₊ = J ω: the force −J_m ω/h beside A. What is lost is booked with it.

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

/// What of a winch's world a system drives.
struct WinchInputs {
    InputId speed, low, high;                 ///< Of the motor.
    InputId hold, back;                       ///< Of the brake.
    InputId radius, length, drum_zero;        ///< Of the element.
    InputId grip_speed, grip_low, grip_high;  ///< Of a gypsy's grip …
    InputId end;                              ///< … and of its bitter end.
};

/// What the wire lies on.
struct WinchWheel {
    DrumGeometry drum{};
    std::optional<GypsyWheel> gypsy{};  ///< Instead of the drum.
};

class WinchSystem final : public System {
  public:
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
        // Below 0 where more has come in than there was: it is the winch's account all the same.
        return element == ids_.line && feeds() && parted_ == 0 ? def_.mass_per_length * at_drum_
                                                               : 0.0;
    }
    /// By the account of what is on the drum, which begins anew with no node.
    [[nodiscard]] double paid_out(const World& world,
                                  InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<WinchSystem>(def_, WinchWheel{drum_, wheel_}, ids_, inputs_,
                                             at_drum_);
    }

  private:
    /// What motor and brake may do in the step that begins [rad/s, N m].
    struct Orders {
        double speed = 0.0, low = 0.0, high = 0.0;
        double hold = 0.0, back = 1.0;
    };
    /// What an input was last set to, so that it is set where it changes.
    struct Set {
        double speed, low, high, hold, back;
    };

    /// State of protection and compensation.
    struct Aids {
        double aops = 1.0, mops = 0.0;                          // inputs
        double out = 0.0, rate = 0.0, peak = 0.0, shown = 0.0;  // outputs: wire_out and on
        double lost = 0.0, error = 0.0;                         // overload_out, heave_error
        double first = 0.0;               ///< Wire outboard less that paid out since [m].
        double height = 0.0, paid = 0.0;  ///< At the begin of the compensation [m].
        double pull = 0.0;                ///< Of the step before [N].
        double speed = 0.0;               ///< Speed of the compensation [m/s].
        std::int32_t begun = 0;           ///< `first` is known.
        std::int32_t guards = 0;          ///< The drive balances the drum's inertia.
        std::int32_t yields = 0;          ///< The protection pays out.
        std::int32_t heaves = 0;          ///< The compensation has begun.
    };

    void look(const Prestep& now) noexcept;
    void count_slip(Prestep& now) noexcept;
    void count_rendering(Prestep& now) noexcept;
    void follow_layer(Prestep& now) noexcept;
    void follow_chain(const GypsyWheel& wheel, Prestep& now, Loads& loads) noexcept;
    [[nodiscard]] DrumGeometry::Place place() const noexcept;
    [[nodiscard]] double leaving_radius() const noexcept;
    [[nodiscard]] double wound_inertia() const noexcept;
    /// What the element at the drum is paid out by.
    [[nodiscard]] BodyId wound() const noexcept { return wheel_ ? ids_.chain : ids_.drum; }
    void check_fastening(Prestep& now) noexcept;
    void count_release(Prestep& now) noexcept;
    // winch_aids.cpp
    /// True if protection or compensation is defined: their signals and state exist.
    [[nodiscard]] bool assisted() const noexcept {
        return def_.overload_limit > 0.0 || def_.heave_speed > 0.0;
    }
    void visit_aids(StateVisitor& visitor);
    void check_aids(StateRules& rules) const;
    void add_aid_signals(SignalTable& table);
    void follow_aids(Prestep& now) noexcept;
    void follow_heave(const Prestep& now) noexcept;
    [[nodiscard]] double most_tension() const noexcept;
    void limit_overload(Orders& out) const noexcept;
    [[nodiscard]] Orders orders() noexcept;
    void order_motor(Orders& out) noexcept;
    void give(Prestep& now, const Orders& orders) noexcept;
    void turn_along(const Prestep& now, Loads& loads) noexcept;
    void weigh_element(const World& world, Loads& loads) const noexcept;
    [[nodiscard]] Vec3 weight_of_half(const World& world) const noexcept;
    [[nodiscard]] Vec3 along_element(const World& world) const noexcept;
    [[nodiscard]] bool feeds() const noexcept { return def_.element > 0.0; }
    [[nodiscard]] std::size_t node_slot(const World& world) const noexcept;
    [[nodiscard]] WinchMode mode() const noexcept;
    [[nodiscard]] bool full() const noexcept;

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
    Set set_;
    GripOrder grip_set_{0.0, -1e30, 1e30};
    double end_set_ = 0.0;  ///< Bound of the bitter end [N m].
    std::int32_t slipping_ = 0, parted_ = 0, empty_ = 0, released_ = 0, engaged_ = 1;
    std::int32_t rendering_ = 0;
    Aids aids_;
    // Outputs.
    double layer_ = 1.0, wraps_ = 0.0, across_ = 0.0, pull_ = 0.0, pull_limit_ = 0.0;
    double inertia_ = 0.0, state_ = 0.0;
    // Of the step that begins.
    double turned_ = 0.0, omega_ = 0.0, leaving_ = 0.0;  ///< Of wire, drum and wire.
    bool crowded_ = false;    ///< A node could not be put for the first time.
    bool hauled_in_ = false;  ///< The element at the drum has next to no length left, or will soon.
    bool jams_ = false;       ///< It has.
    bool jams_now_ = false;   ///< It has since the last step.
};

}  // namespace hawser::wire
