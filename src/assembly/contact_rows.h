// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file contact_rows.h
/// Contact points as rows, for code compiled per instruction set.
///
/// The velocity of the point, side 1 minus side 0, is Σ w (v + ω × r) over the slots, with w
/// negative on side 0. Rows are its components along the axes n, t₁, t₂. J of a slot is therefore w
/// E [1, −r̂] with the axes as rows of E. Blocks and impulses are computed from w, r, E: J itself
/// is never stored.

#include "nonsmooth/cone.h"
#include "nonsmooth/resistance.h"

#include <cstdint>

namespace hawser::assembly {

struct ContactSlot {
    std::int32_t dof_begin;  ///< Offset in packed velocities; unused without degrees of freedom.
    std::int32_t body;
    std::int32_t dof;  ///< 6, 3 or 0.
    double weight;     ///< Negative on side 0.
    double arm[3];     ///< From the centre of mass to the point, world frame [m].
};

struct ContactRow {
    std::int32_t slots;
    std::int32_t resistance;  ///< Index of its ResistanceRow, or −1.
    ContactSlot slot[4];
    double axis[9];  ///< E, row-major: n, t₁, t₂ in the world frame.
    /// Contribution to u from bodies with a prescribed velocity, along the axes [m/s].
    double carried[3];
};

/// Rows of relative rotation of a contact between two bodies with an orientation, along its axes:
/// J of a slot is w E [0, 1].
struct ResistanceRow {
    std::int32_t contact;
    double carried[3];  ///< Contribution to u from bodies with a prescribed velocity [rad/s].
    double gap[3];      ///< g along the axes at the begin of the step [rad].
    double epsilon;     ///< Compliance [rad/(N m)].
};

/// One block of the matrix that contacts add to: bodies a ≤ b.
struct ContactBlock {
    std::int32_t a, b;
    std::int32_t begin, end;  ///< Range of ContactTerm.
};
/// Slots i (of body a) and j (of body b) of one contact.
struct ContactTerm {
    std::int32_t contact;
    std::int8_t i, j;
};

/// Minimum of Σ/W. Contacts are condensed; for a smaller Σ the masses of the bodies would be lost
/// in rounding. At the default stiffness the limit affects grains of less than a milligram. They
/// sink in by this fraction of their motion under gravity within a step.
inline constexpr double kMinSigma = 1e-10;

/// Doubles of one block: K_ab (6×6, column-major) and K_ba, because K is unsymmetric.
inline constexpr int kContactBlock = 72;

struct ContactKernels {
    /// Compute u of contacts [begin, end) at packed velocities v (null: at rest). Then compute λ =
    /// p − S u and the impulse on each slot, six doubles per slot.
    void (*update)(const ContactRow* rows, nonsmooth::Cone* cones, std::int32_t begin,
                   std::int32_t end, const double* v, double* slot_impulse) noexcept;
    /// Compute u and λ of resistances [begin, end), after update() of their contacts. Adds their
    /// torque to the impulses on slots.
    void (*turn)(const ContactRow* rows, const nonsmooth::Cone* cones,
                 const ResistanceRow* resistance_rows, nonsmooth::Resistance* resistances,
                 std::int32_t begin, std::int32_t end, const double* v,
                 double* slot_impulse) noexcept;
    /// Sum up the changed blocks of [begin, end).
    void (*blocks)(const ContactRow* rows, const nonsmooth::Cone* cones,
                   const nonsmooth::Resistance* resistances, const ContactBlock* blocks,
                   const std::uint8_t* changed, const ContactTerm* terms, std::int32_t begin,
                   std::int32_t end, double* out) noexcept;
};
[[nodiscard]] const ContactKernels& contact_kernels() noexcept;

}  // namespace hawser::assembly

namespace hawser::sse2 {
extern const assembly::ContactKernels kContactKernels;
}
namespace hawser::avx2 {
extern const assembly::ContactKernels kContactKernels;
}
namespace hawser::avx512 {
extern const assembly::ContactKernels kContactKernels;
}
