// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file rigid_turning.h
/// Members of Turning that rigid joints and spins set.
///
/// The compiler contracts products by the shape of a function. Kernels that accumulate these three
/// members alone keep their rounding when compliant joints add to Turning.
#include "assembly/view.h"

namespace hawser::HAWSER_ISA {

struct RigidTurning {
    double change = 0.0;  ///< See Turning.
    double gap = 0.0;
    double spin = 0.0;
    /// Keep the larger of both; NaN is kept.
    void add(const RigidTurning& other) noexcept {
        if (!(other.change <= change)) change = other.change;
        if (!(other.gap <= gap)) gap = other.gap;
        if (!(other.spin <= spin)) spin = other.spin;
    }
};

/// Return a complete result. @param weighted  Weighted change of compliant joints.
inline assembly::Turning whole_turning(const RigidTurning& t, double weighted = 0.0) noexcept {
    return {t.change, t.gap, t.spin, weighted};
}

}  // namespace hawser::HAWSER_ISA
