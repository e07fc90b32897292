// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file route_checks.h
/// What a definition of a route must be (hawser/route.h).

#include <hawser/route.h>

#include <string>

namespace hawser::wire {

/// @throws DefError that names the route.
[[noreturn]] void refuse(const RouteDef& def, const std::string& why);
/// Numbers within their bounds, and bodies that can hold a line. @throws DefError.
void check(const RouteBodies& bodies, const RouteDef& def);

}  // namespace hawser::wire
