// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file host.h
/// The machine a run was made on.

#include <array>
#include <cstdint>
#include <string>

namespace hawser::record {

/// As the processor names itself; "unknown" where that cannot be read.
[[nodiscard]] std::string processor_model();
/// Processors this process may use.
[[nodiscard]] int processor_count();
/// Mean number of running tasks over 1, 5 and 15 minutes; −1 where unknown.
[[nodiscard]] std::array<double, 3> load_average();
/// Largest resident size of this process so far [bytes].
[[nodiscard]] std::int64_t peak_memory();

}  // namespace hawser::record
