// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file newton_laws.h
/// Laws of contacts and resistances about an iterate, and how far an iterate is from obeying them.

#include "context/context.h"

#include <cstdint>

namespace hawser::stepper {

/// Linearise a contact about the iterate; see linearise(). @param law  That of the last iterate;
/// the new one. @param changes  Of its state in these iterations.
void renew_law(nonsmooth::Cone& cone, nonsmooth::Law& law, std::uint8_t& changes) noexcept;

/// Where the laws of the iterate before stand.
enum class LastLaws : std::uint8_t {
    none,  ///< Newton::laws are of another solve.
    known  ///< In Newton::laws: a direction of sliding that has turned since is noticed.
};

/// Linear laws of all contacts about the iterate. With `known`, sliding that turns round passes
/// through sticking (nonsmooth/cone.h), and a contact that has changed more than kMostChanges times
/// in these iterations goes on with lagged coupling. In the convex phase laws are those of
/// convex_phase.h. @return contacts whose status changed.
std::int32_t linearise(Model& model, Work& work, runtime::Pool& pool, LastLaws last) noexcept;
/// Σ (W + Σ) ‖λ − P‖² over all, a share t of the way: an energy [J].
[[nodiscard]] double merit(const Model& model, const Newton& newton, double t) noexcept;

}  // namespace hawser::stepper
