// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file body_dof.h
/// Degrees of freedom of the kinds of bodies.

#include <hawser/def.h>

namespace hawser::base {

/// Return the number of degrees of freedom of a body of this kind, which is its number of entries
/// of v.
[[nodiscard]] constexpr int dof_of(BodyKind kind) noexcept {
    switch (kind) {
        case BodyKind::rigid:
            return 6;
        case BodyKind::lump:
            return 3;
        case BodyKind::scalar:
            return 1;
        case BodyKind::fixed:
        case BodyKind::kinematic:
            break;
    }
    return 0;
}

}  // namespace hawser::base
