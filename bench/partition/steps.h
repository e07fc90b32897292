// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file steps.h
/// Benefit of a partition in time: factorisations with its separators last, and whole steps with
/// its cuts coupled by compliance, for Hawser's parts and METIS's in turns.

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench {

nlohmann::json compare_steps(int parts, int rounds);

}  // namespace hawser::bench
