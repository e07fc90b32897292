// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file define_gypsy.h
/// From the definition of a gypsy to its chain, its grip and its bitter end.

#include <hawser/winch.h>

#include "wire/gypsy.h"

namespace hawser::wire {

/// Whether it is a gypsy, no drum.
[[nodiscard]] inline bool is_gypsy(const WinchDef& def) noexcept { return def.gypsy.pockets != 0; }

/// A gypsy with what was left out. @throws DefError
[[nodiscard]] GypsyWheel gypsy_of(const WinchDef& def);

/// The grip and the bitter end, where wheel and chain are there. @throws DefError
void add_gypsy_parts(World& world, const WinchDef& def, const GypsyWheel& wheel, WinchIds& ids);

}  // namespace hawser::wire
