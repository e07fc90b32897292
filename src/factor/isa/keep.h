// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file keep.h
/// Products of register blocks use each operand several times. g++ prefers to read it from memory
/// each time, as part of the instruction, and the loads then take longer than the products.

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// v, in a register from here on, where registers are many.
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
