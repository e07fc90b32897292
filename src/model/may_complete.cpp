// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "base/index.h"
#include "model/interactions.h"
#include "model/kinds/all.h"

namespace hawser::model {

namespace {

/// Value of z above which a step does not resolve a compliant row. A linearised row takes the
/// rotation of its direction within the step for motion. From z = 0.1 on this motion causes a
/// notable force. Below 0.1 the iteration gains nothing (docs/theory/compliance.md).
constexpr double kUnresolved = 0.1;

/// True if a row is rigid, or if the step does not resolve it: z (damping.h, with its damping)
/// exceeds kUnresolved.
bool is_unresolved(const Interactions& in, std::size_t row, double h) noexcept {
    const double e = in.epsilon[row], z = h * (in.tau[row] + 0.25 * h) * in.mobility[row];
    return e == 0.0 || z > kUnresolved * e;
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

bool is_compliant(const Interactions& in, int id) noexcept {
    for (int r = 0; r < in.rows[at(id)]; ++r)
        if (in.epsilon[at(in.row_begin[at(id)] + r)] > 0.0) return true;
    return false;
}

bool may_complete(const Interactions& in, int id, double h) noexcept {
    if (!may_ever_complete(in, id)) return false;
    for (int r = 0; r < in.rows[at(id)]; ++r)
        if (!is_unresolved(in, at(in.row_begin[at(id)] + r), h)) return false;
    return true;
}

}  // namespace hawser::model
