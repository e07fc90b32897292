// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file anchor_soil.h
/// Check the bounds of anchors in the soil against the law that hawser/anchor.h documents.

#include <hawser/world.h>

#include <string>

namespace hawser::verify {

/// Describe the first anchor whose bounds in the last step do not agree with its drag distance and
/// line angle.
/// @return empty: none.
[[nodiscard]] std::string anchor_fault(const World& world);

}  // namespace hawser::verify
