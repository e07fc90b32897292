// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winches.h
/// Numbers of a winch in a scene. Format and reader use one table.

#include <hawser/fields.h>
#include <hawser/winch.h>

#include <span>

namespace hawser::scene {

[[nodiscard]] std::span<const FieldInfo<WinchDef>> winch_fields() noexcept;
/// Return the fields of a gypsy other than "pockets".
[[nodiscard]] std::span<const FieldInfo<GypsyDef>> gypsy_fields() noexcept;
inline constexpr int kMinPockets = 3, kMaxPockets = 100;

}  // namespace hawser::scene
