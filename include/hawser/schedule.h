// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file schedule.h
/// Deprecated name of hawser/experimental/schedule.h, for one version.

#pragma message("deprecated header: include <hawser/experimental/schedule.h>")
#include <hawser/experimental/schedule.h>
