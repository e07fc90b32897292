// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ledger.h
/// Sums of energy that a step goes on from.

namespace hawser::stepper {

/// Since the start [J], see hawser::Energy.
struct Ledger {
    double work = 0.0, drag = 0.0;
    double drive = 0.0;  ///< See Energy::driven.
    double friction = 0.0, contact = 0.0;
    double damped = 0.0;
};

}  // namespace hawser::stepper
