// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch_checks.h
/// Refusals of a winch's definition, by its name.

#include <hawser/def.h>
#include <hawser/winch.h>

#include "wire/bounds.h"

#include <string>

namespace hawser::wire {

[[noreturn]] inline void refuse(const WinchDef& def, const std::string& what) {
    throw DefError("winch '" + def.name + "': " + what);
}

/// @throws DefError for a number below the least one, or at it where it has to be above.
inline void check_number(const WinchDef& def, const char* what, double value, double least,
                         bool above) {
    if (value > least || (!above && value == least)) {
        if (value <= 1e30) return;
    }
    refuse(def, std::string(what) + " = " + number(value) + ": give a number " +
                    (above ? "above " : "from ") + number(least) + (above ? "" : " on"));
}

/// Check overload protection and heave compensation (winch_aids.cpp). @throws DefError
void check_aids(const WinchDef& def);

}  // namespace hawser::wire
