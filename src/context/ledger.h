// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ledger.h
/// Sums of energy that a step goes on from.

namespace hawser::stepper {

/// Energy that edits of the world bring in [J], negative where they take it away.
struct Edited {
    double given = 0.0;     ///< Bodies and interactions that come and go, masses that change.
    double strained = 0.0;  ///< Elastic energy by nodes of wires that come and go.

    Edited& operator+=(const Edited& other) noexcept {
        given += other.given;
        strained += other.strained;
        return *this;
    }
    Edited& operator-=(const Edited& other) noexcept {
        given -= other.given;
        strained -= other.strained;
        return *this;
    }
    [[nodiscard]] friend Edited operator+(Edited a, const Edited& b) noexcept { return a += b; }
    [[nodiscard]] friend Edited operator-(Edited a, const Edited& b) noexcept { return a -= b; }
    [[nodiscard]] double sum() const noexcept { return given + strained; }
};

/// Since the start [J], see hawser::Energy.
struct Ledger {
    double work = 0.0, drag = 0.0;
    double drive = 0.0;  ///< See Energy::driven.
    Edited edited;       ///< See Energy::edited.
    double friction = 0.0, contact = 0.0;
    double damped = 0.0;
};

}  // namespace hawser::stepper
