// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_laws.h
/// Laws of contacts and resistances about an iterate, and how far an iterate is from obeying them.

#include "context/context.h"

#include <cstdint>

namespace hawser::contact {

/// Replace the law of a contact by its linearisation about the iterate; see linearise().
/// @param law  In: law of the last iterate; out: the new one.
/// @param changes  Number of changes of its status in these iterations.
void renew_law(nonsmooth::Cone& cone, nonsmooth::Law& law, std::uint8_t& changes) noexcept;

/// Validity of the laws of the previous iterate.
enum class LastLaws : std::uint8_t {
    none,  ///< Newton::laws belong to another solve.
    known  ///< Newton::laws are valid, so a reversed direction of sliding is detected.
};

/// Compute linear laws of all contacts about the iterate. With `known`, reversing sliding passes
/// through sticking (nonsmooth/cone.h). A contact that has changed more than kMaxChanges times in
/// these iterations continues with lagged coupling. In the convex phase the laws are those of
/// convex_phase.h.
/// @return the number of contacts whose status changed.
std::int32_t linearise(context::Model& model, context::Work& work, runtime::Pool& pool,
                       LastLaws last) noexcept;
/// Return Σ (W + Σ) ‖λ − P‖² over contacts and bounded rows, at a fraction t of the way from the
/// stored iterate [J].
[[nodiscard]] double merit(const context::Model& model, const context::Newton& newton,
                           double t) noexcept;

}  // namespace hawser::contact
