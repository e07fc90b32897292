// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file gauss_seidel.h
/// Relax rows by projected Gauss-Seidel. Each body responds to an impulse by its own inverse mass,
/// as if it were free. Rows are solved one after the other for their own impulse, at the current
/// velocities. Sweeps run on one thread in a fixed order, so results do not depend on the number of
/// threads.

#include "context/context.h"

namespace hawser::methods {

/// Reserve the arrays of the Gauss-Seidel method for `contacts` contacts. @throws std::bad_alloc.
void reserve_gauss_seidel(const context::Model& model, context::Newton& newton,
                          std::size_t contacts);

/// Invert M + hD of all bodies and compute the diagonal blocks of contacts. @return false if a
/// matrix is singular.
[[nodiscard]] bool invert_masses(const context::Model& model, context::Newton& newton,
                                 const assembly::View& v) noexcept;

/// Compute M⁻¹ p, the velocity of a body after an impulse p. Both arrays have one entry for each
/// degree of freedom.
void velocity_after_impulse(const context::Newton& newton, std::int32_t body, int dof,
                            const double* p, double* out) noexcept;

/// Add the effect M⁻¹ Jᵀ x of the impulses x of contact k to the velocities v₊.
void push_contact(const context::Model& model, const context::Newton& newton,
                  const assembly::View& v, std::size_t k, const double x[3]) noexcept;

/// Compute the relative velocity u of contact k from v₊ and store it in its cone.
void read_contact(context::Model& model, const assembly::View& v, std::size_t k) noexcept;

/// Perform one relaxation of the tangential impulses of contact k at v₊, and update v₊.
void relax_tangents(context::Model& model, const context::Newton& newton, const assembly::View& v,
                    std::size_t k) noexcept;

/// Perform one relaxation of the normal impulse of contact k at v₊, and update v₊.
void relax_normal(context::Model& model, const context::Newton& newton, const assembly::View& v,
                  std::size_t k) noexcept;

/// Set the laws of contacts to the current impulses: S = 0, p = λ. The status follows from λ.
void freeze_impulses(context::Model& model) noexcept;

}  // namespace hawser::methods
