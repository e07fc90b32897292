// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file keep.h
/// Products of register blocks use each operand several times. g++ prefers to read an operand from
/// memory each time, as part of the instruction. The loads then take longer than the products.

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// Return v, and force the compiler to keep it in a register if the instruction set has enough
/// registers.
HAWSER_INLINE Part keep(Part v) {
#if defined(__AVX512F__)
    asm("" : "+v"(v));
#endif
    return v;
}
#if !defined(__AVX512F__)
HAWSER_INLINE V8 keep(const V8& v) { return v; }
#endif

}  // namespace hawser::HAWSER_ISA
