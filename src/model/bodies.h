// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bodies.h
/// State of all bodies as arrays. Velocities of moving bodies are packed: body b owns
/// dof(b) entries of `v` from dof_begin(b): rigid (v, ω) in the world frame, lump v, scalar rate.

#include <hawser/def.h>

#include "base/memory.h"
#include "base/places.h"

#include <cstdint>
#include <vector>

namespace hawser::model {

/// Degrees of freedom of a kind.
[[nodiscard]] constexpr int dof_of(BodyKind kind) noexcept {
    switch (kind) {
        case BodyKind::rigid:
            return 6;
        case BodyKind::lump:
            return 3;
        case BodyKind::scalar:
            return 1;
        case BodyKind::fixed:
        case BodyKind::kinematic:
            break;
    }
    return 0;
}

struct Bodies {
    base::Places places;  ///< Where a body was removed, a fixed one without name is left.
    base::Array<BodyKind> kind;
    base::Array<std::uint8_t> room;       ///< Entries of v at dof_begin, whatever is there now.
    base::Array<std::int32_t> dof_begin;  ///< Into v; for bodies without freedom: unused.
    std::vector<std::int32_t> moving;     ///< Bodies with freedom, ascending.
    std::vector<std::int32_t> rigid;      ///< Rigid bodies, ascending.
    std::vector<std::int32_t> driven;     ///< Kinematic bodies, ascending.

    base::Array<double> x;  ///< 3 a body: position [m].
    base::Array<double> q;  ///< 4 a body: quaternion w, x, y, z.
    base::Array<double> r;  ///< 9 a body: rotation matrix of q, row-major.
    base::Array<double> v;  ///< Packed velocities at t − h/2.
    /// Packed velocities that the next v is taken for before it is known: v + (v − the one before).
    /// The nearer, the less rounding a solution that starts there leaves. Part of the state.
    base::Array<double> v_start;
    base::Array<double> v_fixed;  ///< 6 a body: prescribed velocity of kinematic bodies.
    /// 6 a body: prescribed velocity at the last half step, where it is another one than v_fixed
    /// (images, split/cuts.h); else empty.
    base::Array<double> v_before;
    base::Array<double> spin_free;    ///< 3 a body: ω after the step being taken without torque.
    base::Array<double> spin_change;  ///< 3 a body: what torques changed ω by in the last step,
                                      ///< body frame [rad/s]. Part of the state.

    base::Array<double> mass;         ///< 1 a body [kg].
    base::Array<double> inertia;      ///< 9 a body, body frame [kg m²].
    base::Array<double> inv_inertia;  ///< Its inverse; zero for bodies that are not rigid.
    /// 6 a body: its moments of inertia and their inverses where they are all that the inertia has,
    /// zeros elsewhere.
    base::Array<double> principal;
    base::Array<double> force;    ///< 6 a body: applied force and torque, world frame [N, N m].
    base::Array<double> damping;  ///< 6 a body: drag along and about the body's axes.
    /// 6 a body: the shares θ and 1 − θ of `damping` that act on the velocities after and before
    /// the step (damping.h).
    base::Array<double> drag_after, drag_before;
    base::Array<std::uint8_t> weight;  ///< 1: gravity acts.
    /// First interaction that holds it and its slot there, kMaxInteractionBodies id + slot; −1:
    /// none does. Kept by Interactions, see for_each_holder().
    base::Array<std::int32_t> first_holder;

    base::Array<std::uint8_t> asleep;  ///< 1: asleep, see step/sleep.h. Part of the state.
    base::Array<std::int32_t> quiet;   ///< Steps for which it has been at rest. Part of the state.

    std::int32_t dofs = 0;  ///< Entries of v, those of empty places included.

    [[nodiscard]] int count() const noexcept { return static_cast<int>(kind.size()); }
    [[nodiscard]] int dof(int body) const noexcept {
        return dof_of(kind[static_cast<std::size_t>(body)]);
    }
    /// Whether a body has an orientation: all but lumps and scalar bodies.
    [[nodiscard]] bool turns(int body) const noexcept {
        const BodyKind k = kind[static_cast<std::size_t>(body)];
        return k != BodyKind::lump && k != BodyKind::scalar;
    }
    [[nodiscard]] BodyId id(int body) const noexcept { return places.id<BodyId>(body); }
    /// So that add(), append() and remove() do not throw. @throws std::bad_alloc.
    void make_room();
    /// First empty place with as many degrees of freedom, −1: none.
    [[nodiscard]] int place_for(BodyKind of) const noexcept {
        return places.find_vacant(
            [&](std::int32_t p) { return room[static_cast<std::size_t>(p)] == dof_of(of); });
    }
    /// Add one body, at the first empty place with as many degrees of freedom, else behind all
    /// others; the definition has been checked. @return its place.
    int add(const BodyDef& def);
    /// Add one behind all others.
    int append(const BodyDef& def);
    /// What is left at its place weighs nothing, does not move, and nothing touches it.
    void remove(int body) noexcept;
    /// Sets drag_after and drag_before for the step h [s].
    void share_drag(double h);
    /// Take away the places from `kept` on, with what is there.
    void truncate(int kept);
    /// Move by time t at constant velocity [m/s]; with ω [rad/s, world frame] also turn, by the
    /// Cayley map of t ω. Scalars: not for them.
    void drift(int body, const double* velocity, const double* omega, double t) noexcept;
    /// q = turn ⊗ q, normalised, and r. @param turn  World frame, any length.
    void turn(int body, const Quat& turn) noexcept;
    /// Recompute r from q for every rigid, fixed and kinematic body.
    void refresh_rotation(int body) noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void write(int body, const BodyDef& def) noexcept;
    /// Lists of moving, rigid and kinematic bodies.
    void enlist(int body) noexcept;
};

}  // namespace hawser::model
