// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file step.h
/// One step of the world: eight stages, in order.
/// ```
///     prestep     systems act: loads, inputs                         prestep.h
///     collide     contacts at the present poses; islands that wake   sleep.h
///     graph       groups that follow the state                       split.h
///     analyse     if the system has changed                          split.h, contact.h
///     assemble    rows and body terms                                assemble_rows.h
///     factor      the matrix, written while factorised, and solved   factor.h, solve.h
///     nonsmooth   contacts and bounds, with factorisations between   nonsmooth.h, completion.h
///     integrate   the solution becomes the state                     integrate.h
/// ```
///
/// The scheme is SPOOK. Source: Lacoursière, "Ghosts and machines: regularized variational methods
/// for interactive simulations of multibodies with dry frictional contacts", 2007. Positions are at
/// t, velocities at t − h/2; the matrix and right-hand side are in assembly/view.h.

#include "context/context.h"

namespace hawser::step {

/// Advance the world by one step h. The state changes only if the result is ok.
Status step(context::StepContext& ctx) noexcept;

}  // namespace hawser::step
