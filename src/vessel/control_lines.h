// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file control_lines.h
/// Checks of the control of a vessel, and its tension feed-forward.

#include "vessel/control.h"

#include <vector>

namespace hawser::vessel {

/// Check the control of a vessel. @throws DefError "vessel 'NAME': control/field: reason".
void check_control(const World& world, const VesselDef& def);
/// Return the ends of the lines in VesselControl::lines. @throws DefError
[[nodiscard]] std::vector<FedLine> fed_lines(const World& world, const VesselDef& def);
/// Return the sum of the lines' tensions as a force and moment at O. @param axes  Marine axes in
/// the world. @param origin  O in the world [m].
[[nodiscard]] Vec3 line_load(const World& world, const VesselDef& def,
                             const std::vector<FedLine>& lines, const Mat3& axes,
                             const Vec3& origin) noexcept;

}  // namespace hawser::vessel
