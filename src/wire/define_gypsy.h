// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file define_gypsy.h
/// Chain, grip and bitter end from the definition of a gypsy.

#include <hawser/winch.h>

#include "wire/gypsy.h"

namespace hawser::wire {

/// Return true if the winch is a gypsy instead of a drum.
[[nodiscard]] inline bool is_gypsy(const WinchDef& def) noexcept { return def.gypsy.pockets != 0; }

/// Return the gypsy with defaults filled in.
/// @throws DefError
[[nodiscard]] GypsyWheel complete_gypsy(const WinchDef& def);

/// Add the grip and the bitter end. Wheel and chain must exist.
/// @throws DefError
void add_gypsy_parts(World& world, const WinchDef& def, const GypsyWheel& wheel, WinchIds& ids);

}  // namespace hawser::wire
