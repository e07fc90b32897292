// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file machine.h
/// Version of the library, and properties of the machine.

namespace hawser {

/// Return the instruction set that the kernels use: "sse2", "avx2" or "avx512". It is the best one
/// of the processor, unless the environment variable HAWSER_ISA selects a lesser one.
[[nodiscard]] const char* instruction_set() noexcept;

/// Check the environment variables; World's constructor calls it first.
/// @throws EnvironmentError if HAWSER_ISA names no instruction set, or one that the processor
/// lacks.
void check_environment();

/// Return the version of the library, e.g. "0.1.0".
[[nodiscard]] const char* version() noexcept;

}  // namespace hawser
