// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file with_count.h
/// Loops over a number of columns that is a constant for the compiler.

#include "base/simd.h"

namespace hawser::HAWSER_ISA {

/// Call f with n = 1 … 8 as a constant.
template <class F>
HAWSER_INLINE void with_count(int n, F&& f) {
    switch (n) {
        case 1:
            f.template operator()<1>();
            break;
        case 2:
            f.template operator()<2>();
            break;
        case 3:
            f.template operator()<3>();
            break;
        case 4:
            f.template operator()<4>();
            break;
        case 5:
            f.template operator()<5>();
            break;
        case 6:
            f.template operator()<6>();
            break;
        case 7:
            f.template operator()<7>();
            break;
        default:
            f.template operator()<8>();
            break;
    }
}

}  // namespace hawser::HAWSER_ISA
