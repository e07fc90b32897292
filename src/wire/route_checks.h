// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file route_checks.h
/// Checks of the definition of a route (hawser/route.h).

#include <hawser/route.h>

#include <string>

namespace hawser::wire {

/// Reject a definition.
/// @throws DefError with the name of the route.
[[noreturn]] void throw_def_error(const RouteDef& def, const std::string& why);
/// Check numbers against their bounds, and bodies that can hold a line.
/// @throws DefError.
void check(const RouteBodies& bodies, const RouteDef& def);

}  // namespace hawser::wire
