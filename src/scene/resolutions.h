// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file resolutions.h
/// Numbers of a cable's resolution in a scene. Format and reader use one table.

#include <hawser/fields.h>
#include <hawser/resolution.h>

#include <span>

namespace hawser::scene {

/// Return the fields of a resolution (lengths, times and counts), in the order of the reference
/// page.
[[nodiscard]] std::span<const FieldInfo<ResolutionDef>> resolution_fields() noexcept;

}  // namespace hawser::scene
