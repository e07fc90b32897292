// SPDX-License-Identifier: Apache-2.0
#include "validate/firstday.h"

namespace hawser::validate {
namespace {

constexpr Case kFirstDay[] = {
    {"F.1", "first_chains", "chains along an axis in still water", case_first_chains},
    {"F.2", "first_lines", "lines in the sea start at rest", case_first_lines},
    {"F.3", "first_waves", "a barge in short waves beside diffraction theory", case_first_waves},
    {"F.4", "first_drag", "drag of hulls by draught", case_first_drag},
    {"F.5", "first_memory", "ends of radiation memories, negative damping", case_first_memory},
    {"F.6", "first_warnings", "warnings of hawser check", case_first_warnings},
    {"F.7", "first_winches", "power of a winch; a bare drum to its stop and out",
     case_first_winches},
    {"F.8", "first_routes", "ends at eyes, bollards, guides on the other side", case_first_routes},
};

}  // namespace

std::span<const Case> firstday_cases() { return kFirstDay; }

}  // namespace hawser::validate
