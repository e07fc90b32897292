// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gypsy.h
/// Chain on a wheel with pockets, and jumps of the chain.
///
/// ```
///   outboard, T  ___        A flat link lies in a pocket, the next link stands between two
///    o-0-o-0-o-/ o  \       pockets. A turn pays out n 2p (n pockets, pitch p of a link), so
///              |  +  o      r = n p/π. The chain is a scalar body with the angle θ_c, the wheel
///               \_ o/       has the angle θ_w. The chain has jumped by s = r (θ_c − θ_w).
///                 0
///                 o         The fall into the locker: its weight T_0 = ρ g fall pulls inboard, and
///                 0         ρ v² while chain is taken from the heap (Cayley).
///              8o8o8o8
/// ```
/// The grip is the row of a scalar_clutch: r (θ_c − θ_w)' = u, with a range of forces.
/// - *Seated*, s a whole number of pockets: u = 0, |F| ≤ jump_load. The chain jumps in the step in
///   which T − T_0, minus the force that accelerates the chain on the wheel, reaches jump_load.
/// - *Between pockets*: u = 0 and |F| ≤ jump_friction. Links slide on the wheel at the bound and
///   rest below it.
/// - *Near the next pocket*, with T − T_0 ≤ jump_load: u moves them to its middle within the step,
///   with an unlimited force that brakes and no force that pushes. The links fall into the pocket,
///   and the next step removes their velocity relative to the wheel. Above jump_load they move on
///   to the next pocket.
///
/// The work of the row counts as driven, like that of motors.

#include <hawser/id.h>
#include <hawser/system.h>
#include <hawser/winch.h>
#include <hawser/world.h>

#include <cstdint>

namespace hawser::wire {

/// A gypsy with all values known.
struct GypsyWheel {
    double radius = 0.0;         ///< r [m].
    double pocket = 0.0;         ///< 2 p [m].
    double jump_load = 0.0;      ///< [N].
    double jump_friction = 0.0;  ///< [N].
    double fall = 0.0;           ///< [m].
    double locker = 0.0;         ///< Capacity of the locker [m].
    double zero = 0.0;           ///< θ_c − θ_w at s = 0.
};

/// Speed and bounds of the grip's row in a step [rad/s, N m].
struct GripOrder {
    double speed = 0.0, low = 0.0, high = 0.0;
};

/// State of the chain on its wheel.
class GypsyChain {
  public:
    explicit GypsyChain(const GypsyWheel& wheel) noexcept : wheel_(wheel) {}

    /// Read the result of the last step.
    /// @param separation  θ_c − θ_w [rad].
    /// @param rate  Its rate [rad/s].
    /// @param torque  Torque of the grip's row on the chain [N m].
    /// @param pull  T − T_0 [N].
    /// @return the load at which the chain has begun to jump or passed to another pocket [N]; 0:
    /// neither.
    [[nodiscard]] double sample(double separation, double rate, double torque,
                                double pull) noexcept;
    /// Return the position and torque that the grip of the wheel must apply to the chain in the
    /// next step of h [s].
    [[nodiscard]] GripOrder order(double h) const noexcept;
    [[nodiscard]] bool jumps() const noexcept { return jumping_ != 0; }
    void visit_state(StateVisitor& v);
    void check_state(StateRules& rules) const;
    void signals(SignalTable& table);
    void set_tail_tension(double tail) noexcept { tail_ = tail; }
    [[nodiscard]] double tail() const noexcept { return tail_; }

  private:
    GypsyWheel wheel_;
    double pocket_ = 0.0;  ///< Pocket that it is in, or behind [pockets].
    /// Distance and speed from there [m, m/s], and the change of speed in the last step.
    double pocket_distance_ = 0.0, rate_ = 0.0, gained_ = 0.0;
    double pull_ = 0.0;
    double count_ = 0.0, jumped_ = 0.0, grip_ = 0.0, tail_ = 0.0;  ///< Outputs.
    std::int32_t jumping_ = 0, caught_ = 0;
};

}  // namespace hawser::wire
