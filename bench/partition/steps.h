// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file steps.h
/// What a partition is worth in time: factorisations with its separators last, and whole steps
/// with its cuts coupled by compliance, under our parts and those of METIS by turns.

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench {

nlohmann::json compare_steps(int parts, int rounds);

}  // namespace hawser::bench
