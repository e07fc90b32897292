// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file partition.h
/// Deprecated name of hawser/experimental/partition.h, for one version.

#pragma message("deprecated header: include <hawser/experimental/partition.h>")
#include <hawser/experimental/partition.h>
