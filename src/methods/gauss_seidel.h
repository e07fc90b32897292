// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gauss_seidel.h
/// Bodies as projected Gauss-Seidel sees them: each answers an impulse by its own inverse mass, as
/// if nothing held it. Row after row is solved for its own impulse at the velocities of that
/// moment. Sweeps run on one thread, in one order: results do not depend on the number of threads.

#include "context/context.h"

namespace hawser::stepper {

/// Room for it. @throws std::bad_alloc.
void reserve_gauss_seidel(const Model& model, Newton& newton, std::size_t contacts);

/// Inverses of M + hD of all bodies, own blocks of contacts. @return false: one is singular.
[[nodiscard]] bool invert_masses(const Model& model, Newton& newton,
                                 const assembly::View& v) noexcept;

/// M⁻¹ p of a body: its velocity after an impulse p. Both have as many entries as it has freedoms.
void answer(const Newton& newton, std::int32_t body, int dof, const double* p,
            double* out) noexcept;

/// v₊ += M⁻¹ Jᵀ x for impulses x of contact k.
void push_contact(const Model& model, const Newton& newton, const assembly::View& v, std::size_t k,
                  const double x[3]) noexcept;

/// u of contact k at v₊, into its cone.
void read_contact(Model& model, const assembly::View& v, std::size_t k) noexcept;

/// Relax the tangents of contact k at v₊; v₊ follows.
void relax_tangents(Model& model, const Newton& newton, const assembly::View& v,
                    std::size_t k) noexcept;

/// Relax the normal of contact k at v₊; v₊ follows.
void relax_normal(Model& model, const Newton& newton, const assembly::View& v,
                  std::size_t k) noexcept;

/// Impulses as they are become the laws: S = 0, p = λ, status by λ.
void freeze_impulses(Model& model) noexcept;

}  // namespace hawser::stepper
