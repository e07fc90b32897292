// SPDX-License-Identifier: Apache-2.0
#define HAWSER_KIND_SETUP
#include "base/index.h"
#include "model/interactions.h"
#include "model/kinds/all.h"

namespace hawser::model {

bool may_complete(const Interactions& in, int id, double h) noexcept {
    bool kind = false;
    generic::with_kind(in.def[at(id)].kind, [&]<class K>() {
        if constexpr (requires { K::kCompletes; }) kind = K::kCompletes;
    });
    if (!kind || (in.flags[at(id)] & kByInput)) return false;
    for (int r = 0; r < in.rows[at(id)]; ++r) {
        const auto row = at(in.row_begin[at(id)] + r);
        if (in.epsilon[row] != 0.0 || in.tau[row] != 2.0 * h) return false;
    }
    return true;
}

}  // namespace hawser::model
