// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "base/index.h"
#include "model/interactions.h"
#include "model/kinds/all.h"

namespace hawser::model {

namespace {

/// True if all rows are springs with dampers that the step does not resolve: z of damping.h exceeds
/// 1. The rotation of a row's direction within the step then causes a speed that the damper
/// converts to a large force.
bool is_stiff_damper(const Interactions& in, int id, double h) noexcept {
    for (int r = 0; r < in.rows[at(id)]; ++r) {
        const auto row = at(in.row_begin[at(id)] + r);
        const double e = in.epsilon[row], soft = h * (in.tau[row] + 0.25 * h) * in.mobility[row];
        if (!(in.row_flags[row] & kRowDamper) || !(e > 0.0) || !(soft > e)) return false;
    }
    return true;
}

}  // namespace

bool kind_completes(InteractionKind kind) noexcept {
    bool completes = false;
    generic::with_kind(kind, [&]<class K>() {
        if constexpr (requires { K::kCompletes; }) completes = K::kCompletes;
    });
    return completes;
}

bool may_ever_complete(const Interactions& in, int id) noexcept {
    return !in.gone(id) && kind_completes(in.kinds[at(id)]) && (in.flags[at(id)] & kByInput) == 0;
}

bool may_complete(const Interactions& in, int id, double h) noexcept {
    if (!may_ever_complete(in, id)) return false;
    for (int r = 0; r < in.rows[at(id)]; ++r) {
        const auto row = at(in.row_begin[at(id)] + r);
        if (in.epsilon[row] != 0.0 || in.tau[row] != 2.0 * h) return is_stiff_damper(in, id, h);
    }
    return true;
}

}  // namespace hawser::model
