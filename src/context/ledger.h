// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ledger.h
/// Sums of energy that a step continues.

namespace hawser::context {

/// Energy that edits of the world add [J]; negative if they remove energy.
struct Edited {
    /// Energy of added and removed bodies and interactions, and of changed masses.
    double given = 0.0;
    double strained = 0.0;  ///< Elastic energy of added and removed nodes of wires.

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

/// Sums since the start [J], see hawser::Energy.
struct Ledger {
    double work = 0.0, drag = 0.0;
    double drive = 0.0;  ///< See Energy::driven.
    Edited edited;       ///< See Energy::edited.
    double friction = 0.0, contact = 0.0;
    double damped = 0.0;
};

}  // namespace hawser::context
