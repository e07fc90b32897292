// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file host.h
/// Describe the machine of a run.

#include <array>
#include <cstdint>
#include <string>

namespace hawser::record {

/// Return the name that the processor reports; "unknown" if it cannot be read.
[[nodiscard]] std::string processor_model();
/// Return the number of processors that this process may use.
[[nodiscard]] int processor_count();
/// Return the mean number of running tasks over 1, 5 and 15 minutes; −1 if unknown.
[[nodiscard]] std::array<double, 3> load_average();
/// Return the largest resident size of this process since its start [bytes].
[[nodiscard]] std::int64_t peak_memory();

}  // namespace hawser::record
