// SPDX-License-Identifier: Apache-2.0
#include "validate/untuned.h"

namespace hawser::validate {
namespace {

constexpr Case kUntunedCases[] = {
    {"U.1", "compliant_joints", "compliance and damping time of redundant joints and loops",
     case_compliant_joints},
    {"U.2", "stops", "motors against the ends of ranges", case_stops},
    {"U.3", "restitution", "bounces: heights, times, energy", case_restitution},
    {"U.4", "frictionless", "contacts of fixed bodies without friction", case_frictionless},
    {"U.5", "rotation", "angle of fast bodies, free asymmetric top", case_rotation},
};

}  // namespace

std::span<const Case> untuned_cases() { return kUntunedCases; }

}  // namespace hawser::validate
