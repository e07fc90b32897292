// SPDX-License-Identifier: Apache-2.0
#include "validate_robust.h"

namespace hawser::cli {
namespace {

constexpr Case kRobust[] = {
    {"R.11", "repeated_joints", "a boom on two hinges, slewing", case_repeated_joints},
    {"R.12", "overconstrained", "loops of Bricard and Bennett", case_overconstrained},
    {"R.13", "ships_on_chain", "heavy ships on rigid chains", case_ships_on_chain},
    {"R.14", "long_motions", "double pendulum, chain of rods: energy and momentum",
     case_long_motions},
    {"R.15", "governor", "flyball governor: course, momentum of a free bearing", case_governor},
};

}  // namespace

std::span<const Case> robust_cases() { return kRobust; }

}  // namespace hawser::cli
