// SPDX-License-Identifier: Apache-2.0
#pragma once
/// Coupling of translations and rotations of a rigid body by loads of systems (View::coupled): C =
/// B(3…5, 0…2) of the 6×6 block B. It is stored separately from the two 3×3 blocks of the body.
#include "assembly/isa/rows.h"

namespace hawser::HAWSER_ISA {

/// Return the lower triangle of the coupling block B of a body; null if it has none.
inline const double* coupled_block(const assembly::View& view, std::int32_t body) {
    if (view.coupled == nullptr || view.coupled[body] < 0) return nullptr;
    return view.coupling + view.coupled[body];
}
/// Return C(i, j) from the lower triangle of B.
inline double coupled_entry(const double* b, int i, int j) { return b[(3 + i) * (4 + i) / 2 + j]; }
/// Subtract [0 Cᵀ; C 0] v from the six entries of out.
inline void subtract_coupled(const double* b, const double* v, double* out) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double c = coupled_entry(b, i, j);
            out[3 + i] -= c * v[j];
            out[j] -= c * v[3 + i];
        }
}
/// True if a load couples translation and rotation of any of `count` bodies from `body` on.
inline bool any_coupled(const assembly::View& view, std::int32_t body, int count) {
    if (view.coupled == nullptr) return false;
    for (int l = 0; l < count; ++l)
        if (view.coupled[body + l] >= 0) return true;
    return false;
}

}  // namespace hawser::HAWSER_ISA
