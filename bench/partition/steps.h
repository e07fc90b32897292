// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file steps.h
/// Time saved by a partition: factorisations with its separators last, and whole steps with its
/// cuts coupled by compliance. Our parts and those of METIS alternate.

#include <nlohmann/json_fwd.hpp>

namespace hawser::bench {

nlohmann::json compare_steps(int parts, int rounds);

}  // namespace hawser::bench
