// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file bodies.h
/// Store the state of all bodies as arrays. Velocities of moving bodies are packed: body b owns
/// dof(b) entries of `v` from dof_begin(b). The entries are (v, ω) of a rigid body in the world
/// frame, v of a point mass (BodyKind::lump), the rate of a scalar body.

#include <hawser/def.h>

#include "base/body_dof.h"
#include "base/memory.h"
#include "base/places.h"

#include <cstdint>
#include <vector>

namespace hawser::model {

using base::dof_of;

/// Return the rotation over the time t at the angular velocity ω[3] (base/turn.h), normalised. The
/// angle is t|ω| up to 2 rad, and less than π.
[[nodiscard]] Quat turn_by(const double* omega, double t) noexcept;

struct Bodies {
    base::Slots slots;  ///< Slots; a removed body leaves a fixed one without a name.
    base::Array<BodyKind> kind;
    /// Number of entries of v reserved at dof_begin, independent of the present body.
    base::Array<std::uint8_t> room;
    base::Array<std::int32_t>
        dof_begin;  ///< Offset in v; unused for bodies without degrees of freedom.
    std::vector<std::int32_t> moving;  ///< Indices of bodies with degrees of freedom, ascending.
    std::vector<std::int32_t> rigid;   ///< Indices of rigid bodies, ascending.
    std::vector<std::int32_t> driven;  ///< Indices of kinematic bodies, ascending.

    base::Array<double> x;  ///< Position, 3 entries per body [m].
    base::Array<double> q;  ///< Quaternion w, x, y, z, 4 entries per body.
    base::Array<double> r;  ///< Rotation matrix of q, row-major, 9 entries per body.
    base::Array<double> v;  ///< Packed velocities at t − h/2 [m/s, rad/s].
    /// Packed start value of the next v, extrapolated: v + (v − previous v). A start closer to the
    /// solution leaves a smaller rounding error. Part of the state.
    base::Array<double> v_start;
    base::Array<double> v_fixed;  ///< Prescribed velocity of kinematic bodies, 6 entries per body.
    /// Prescribed velocity at the last half step, 6 entries per body, if it differs from v_fixed
    /// (ghost bodies, split/cuts.h); else empty.
    base::Array<double> v_before;
    /// Torque-free ω at the end of the current step, 3 entries per body [rad/s].
    base::Array<double> spin_free;
    /// Change of ω by torques in the last step, body frame, 3 entries per body [rad/s]. Part of the
    /// state.
    base::Array<double> spin_change;

    base::Array<double> mass;         ///< Mass [kg].
    base::Array<double> inertia;      ///< Inertia, body frame, 9 entries per body [kg m²].
    base::Array<double> inv_inertia;  ///< Inverse inertia; zero for bodies that are not rigid.
    /// Principal moments and their inverses, 6 entries per body, if the inertia is diagonal; else
    /// zeros.
    base::Array<double> principal;
    /// Applied force and torque, world frame, 6 entries per body [N, N m].
    base::Array<double> force;
    /// Drag coefficients along and about the body's axes, 6 entries per body.
    base::Array<double> damping;
    /// Parts θ and 1 − θ of `damping` that act on the velocities after and before the step, 6
    /// entries per body (damping.h).
    base::Array<double> drag_after, drag_before;
    base::Array<std::uint8_t> weight;  ///< 1: gravity acts on the body.
    /// First interaction that holds the body and its slot, kMaxInteractionBodies id + slot; −1:
    /// none. Maintained by Interactions, see for_each_holder().
    base::Array<std::int32_t> first_holder;

    base::Array<std::uint8_t> asleep;  ///< 1: asleep, see step/sleep.h. Part of the state.
    /// Number of steps for which the body has been at rest. Part of the state.
    base::Array<std::int32_t> quiet;

    std::int32_t dofs = 0;  ///< Number of entries of v, including those of empty slots.

    [[nodiscard]] int count() const noexcept { return static_cast<int>(kind.size()); }
    [[nodiscard]] int dof(int body) const noexcept {
        return dof_of(kind[static_cast<std::size_t>(body)]);
    }
    /// True if a body has an orientation: all bodies except point masses and scalar bodies.
    [[nodiscard]] bool turns(int body) const noexcept {
        const BodyKind k = kind[static_cast<std::size_t>(body)];
        return k != BodyKind::lump && k != BodyKind::scalar;
    }
    [[nodiscard]] BodyId id(int body) const noexcept { return slots.id<BodyId>(body); }
    /// Reserve memory so that add(), append() and remove() do not throw. @throws std::bad_alloc.
    void reserve_more();
    /// Return the first empty slot with as many degrees of freedom, −1: none.
    [[nodiscard]] int vacant_slot_for(BodyKind of) const noexcept {
        return slots.find_vacant(
            [&](std::int32_t p) { return room[static_cast<std::size_t>(p)] == dof_of(of); });
    }
    /// Add a body at the first empty slot with as many degrees of freedom, else at the end. The
    /// definition has been checked. @return its slot.
    int add(const BodyDef& def);
    /// Add a body at the end.
    int append(const BodyDef& def);
    /// Remove a body. Its slot keeps a fixed body without mass, interactions or contacts.
    void remove(int body) noexcept;
    /// Compute the factors of drag on the velocities before and after the step, drag_before and
    /// drag_after. @param h  Step [s].
    void split_drag(double h);
    /// Remove all slots with an index ≥ `kept`, and their bodies.
    void truncate(int kept);
    /// Move a body by time t at constant velocity [m/s]. With ω [rad/s, world frame] also rotate it
    /// by turn_by(). Not for scalar bodies.
    void drift(int body, const double* velocity, const double* omega, double t) noexcept;
    /// Rotate a body: q = turn ⊗ q, normalised; also update r. @param turn  World frame, any
    /// length.
    void turn(int body, const Quat& turn) noexcept;
    /// Recompute r from q of a rigid, fixed or kinematic body.
    void refresh_rotation(int body) noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

  private:
    void write(int body, const BodyDef& def) noexcept;
    /// Add a body to the lists of moving, rigid and kinematic bodies to which its kind belongs.
    void enlist(int body) noexcept;
};

}  // namespace hawser::model
