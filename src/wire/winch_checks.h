// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file winch_checks.h
/// Errors of a winch's definition, with its name.

#include <hawser/def.h>
#include <hawser/winch.h>

#include "wire/bounds.h"

#include <string>

namespace hawser::wire {

[[noreturn]] inline void throw_def_error(const WinchDef& def, const std::string& what) {
    throw DefError("winch '" + def.name + "': " + what);
}

/// Check a number.
/// @throws DefError if it is below `least`, or equal to it when `above` is set.
inline void check_number(const WinchDef& def, const char* what, double value, double least,
                         bool above) {
    if (value > least || (!above && value == least)) {
        if (value <= 1e30) return;
    }
    throw_def_error(def, std::string(what) + " = " + number(value) + ": give a number " +
                             (above ? "above " : "from ") + number(least) + (above ? "" : " on"));
}

/// Check overload protection and heave compensation (winch_aids.cpp). @throws DefError
void check_aids(const WinchDef& def);

}  // namespace hawser::wire
