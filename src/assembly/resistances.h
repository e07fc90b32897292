// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resistances.h
/// Resistance to rolling and spinning of the contacts whose surface has it: rows of relative
/// rotation, condensed with the contact (nonsmooth/resistance.h has the law).
///
/// Both sides must be bodies with an orientation; a lump or a segment has none, and its contacts
/// no resistance. The spring that holds below the bound is the tangential one of the contact at
/// the radius of gyration of what turns: ε [rad/(N m)] = ε_t W_ω/W_v, with W_ω and W_v the mean
/// inverse inertia and the inverse mass of both sides. It is then to rotation what it is to
/// sliding.
///
/// **Memory.** While all parts of it hold, the violation g [rad] is the rotation of side 1 against
/// side 0 since a reference orientation, in the frame of side 0: a position, so that what rests
/// does not creep. Where a part gives way, g is what the spring of the torque amounts to, the rest
/// goes on by the velocities, and the reference is set anew in the next step; so it is when
/// bodies have turned too far for one angle to tell, about an axis that is free.

#include "assembly/contact_rows.h"
#include "base/memory.h"
#include "collide/contacts.h"
#include "model/bodies.h"

#include <cstdint>

namespace hawser::assembly {

/// What a resistance remembers. Plain data: part of the state.
struct ResistanceMemory {
    std::int32_t contact;  ///< In the set of its step; ascending.
    std::int32_t anew;     ///< 1: the reference is set anew, with g as it is in `turned`.
    double reference[4];   ///< q₀* q₁ where g = 0.
    double turned[3];      ///< g by the velocities, world axes [rad].
    double lambda[3];      ///< Impulse of the last step, world axes [N m s].
};

class Resistances {
  public:
    /// Those of a step's contacts, after Contacts::set() of all. @throws std::bad_alloc.
    void begin(const collide::ContactSet& set, base::Array<ContactRow>& contacts,
               const model::Bodies& bodies, double h);
    [[nodiscard]] std::size_t count() const noexcept { return laws.size(); }
    /// λ of the last step.
    void recall(const base::Array<ContactRow>& contacts) noexcept;
    /// Of Contacts::scatter() and collect(): three more entries each, from x and u on.
    void scatter(const base::Array<ContactRow>& contacts, const double* x, double* solution,
                 const std::int32_t* offset) const noexcept;
    void collect(const base::Array<ContactRow>& contacts, const double* solution,
                 const std::int32_t* offset, double* u) const noexcept;
    /// After the solve, before the bodies move.
    void remember(const base::Array<ContactRow>& contacts, double h) noexcept;
    /// Memory of a contact of the last step's set; null: none.
    [[nodiscard]] const ResistanceMemory* find(std::int32_t contact) const noexcept;
    [[nodiscard]] std::size_t bytes() const noexcept;

    base::Array<ResistanceRow> rows;
    base::Array<nonsmooth::Resistance> laws;
    base::Array<ResistanceMemory> memory;  ///< Of the last step that was done. Part of the state.

  private:
    void recall_turn(std::size_t index, std::int32_t previous, const ContactRow& contact,
                     const model::Bodies& bodies) noexcept;

    base::Array<ResistanceMemory> next_;
};

}  // namespace hawser::assembly
