// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resistances.h
/// Resistance to rolling and spinning of contacts: rows of relative rotation, condensed with the
/// contact. Only surfaces with such a resistance have them; nonsmooth/resistance.h has the law.
///
/// Both sides must be bodies with an orientation. Contacts of point masses or segments have no
/// resistance. Below the bound a spring acts. It is the tangential spring of the contact at the
/// radius of gyration of the rotating bodies: ε [rad/(N m)] = ε_t W_ω/W_v. W_ω is the mean inverse
/// inertia and W_v the inverse mass of both sides. The spring acts on rotation like the tangential
/// one on sliding.
///
/// Memory: while all components stick, the violation g [rad] is a rotation in the frame of side 0.
/// It is the rotation of side 1 relative to side 0 since a reference orientation. It depends on
/// positions, so that bodies at rest do not creep. If a component yields, its g is the deflection
/// that belongs to the torque. The other components follow the velocities, and the reference is
/// reset in the next step. The reference is also reset if bodies turn about a free axis by more
/// than one angle can describe.

#include "assembly/contact_rows.h"
#include "base/memory.h"
#include "collide/contacts.h"
#include "model/bodies.h"

#include <cstdint>

namespace hawser::assembly {

/// State of a resistance that is kept between steps. Plain data: part of the state.
struct ResistanceMemory {
    std::int32_t contact;  ///< Index of the contact in the set of its step; ascending.
    std::int32_t renewed;  ///< 1: the reference is reset, with g from `turned`.
    double reference[4];   ///< q₀* q₁ at g = 0.
    double turned[3];      ///< g from the velocities, world axes [rad].
    double lambda[3];      ///< Impulse of the last step, world axes [N m s].
};

class Resistances {
  public:
    /// Find the resistances of the contacts of a step. Call after Contacts::set() of all contacts.
    /// @throws std::bad_alloc.
    void begin(const collide::ContactSet& set, base::Array<ContactRow>& contacts,
               const model::Bodies& bodies, double h);
    [[nodiscard]] std::size_t count() const noexcept { return laws.size(); }
    /// Set the impulses λ of resistances to those of the last step.
    void recall(const base::Array<ContactRow>& contacts) noexcept;
    /// Apply Contacts::scatter() and collect() to the resistances: three entries for each, from x
    /// and u on.
    void scatter(const base::Array<ContactRow>& contacts, const double* x, double* solution,
                 const std::int32_t* offset) const noexcept;
    void collect(const base::Array<ContactRow>& contacts, const double* solution,
                 const std::int32_t* offset, double* u) const noexcept;
    /// Store the impulses and reference orientations of resistances. Call after the solve and
    /// before the bodies move.
    void remember(const base::Array<ContactRow>& contacts, double h) noexcept;
    /// Return the resistance memory of contact `contact` of the last step; null if there is none.
    [[nodiscard]] const ResistanceMemory* find(std::int32_t contact) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

    base::Array<ResistanceRow> rows;
    base::Array<nonsmooth::Resistance> laws;
    base::Array<ResistanceMemory> memory;  ///< Memory of the last finished step. Part of the state.

  private:
    void recall_turn(std::size_t index, std::int32_t previous, const ContactRow& contact,
                     const model::Bodies& bodies) noexcept;

    base::Array<ResistanceMemory> next_;
};

}  // namespace hawser::assembly
