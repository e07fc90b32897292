// SPDX-License-Identifier: Apache-2.0
#pragma once
/// What loads of systems couple of a rigid body's translations with its rotations (View::coupled):
/// C = B(3…5, 0…2) of the 6×6 block B, which comes in beside the body's own two blocks of three.
#include "assembly/isa/rows.h"

namespace hawser::HAWSER_ISA {

/// Lower triangle of B of a body, null: it couples nothing.
inline const double* coupled_block(const assembly::View& view, std::int32_t body) {
    if (view.coupled == nullptr || view.coupled[body] < 0) return nullptr;
    return view.coupling + view.coupled[body];
}
/// C(i, j) by the lower triangle of B.
inline double coupled_entry(const double* b, int i, int j) { return b[(3 + i) * (4 + i) / 2 + j]; }
/// out −= [0 Cᵀ; C 0] v. Six entries.
inline void subtract_coupled(const double* b, const double* v, double* out) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double c = coupled_entry(b, i, j);
            out[3 + i] -= c * v[j];
            out[j] -= c * v[3 + i];
        }
}
/// Some of these bodies is coupled.
inline bool any_coupled(const assembly::View& view, std::int32_t body, int count) {
    if (view.coupled == nullptr) return false;
    for (int l = 0; l < count; ++l)
        if (view.coupled[body + l] >= 0) return true;
    return false;
}

}  // namespace hawser::HAWSER_ISA
