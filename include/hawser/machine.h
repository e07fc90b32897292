// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file machine.h
/// What the library is, and what it runs on.

namespace hawser {

/// Instruction set that the dispatcher chose: "sse2", "avx2" or "avx512". The environment
/// variable HAWSER_ISA chooses a lesser one than the processor has.
[[nodiscard]] const char* instruction_set() noexcept;

/// What World's constructor does first. @throws EnvironmentError where HAWSER_ISA is set and names
/// no instruction set, or one that the processor has not.
void check_environment();

/// Version of the library, e.g. "0.1.0".
[[nodiscard]] const char* version() noexcept;

}  // namespace hawser
