// SPDX-License-Identifier: Apache-2.0
#include "validate/untuned.h"

namespace hawser::validate {
namespace {

constexpr Case kUntuned[] = {
    {"U.1", "compliant_joints", "compliance and damping time of redundant joints and loops",
     case_compliant_joints},
};

}  // namespace

std::span<const Case> untuned_cases() { return kUntuned; }

}  // namespace hawser::validate
