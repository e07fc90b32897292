// SPDX-License-Identifier: Apache-2.0
#include "validate/robust.h"

namespace hawser::validate {
namespace {

constexpr Case kRobustCases[] = {
    {"R.1", "zigzag_wires", "wires bent to and fro, at steps that do not resolve their swing",
     case_zigzag_wires},
    {"R.2", "long_wire", "a tug at the end of 300 m of wire, steps up to half a second",
     case_long_wire},
    {"R.3", "wire_sway", "first swing of a taut wire at 30 and 120 steps a period", case_wire_sway},
    {"R.4", "wires_come_taut", "taut wires of half-metre and five-metre elements, bent",
     case_wires_come_taut},
    {"R.5", "damping_orders", "order of dampers, drag and hydrostatic heave", case_damping_orders},
    {"R.11", "repeated_joints", "a boom on two hinges, slewing", case_repeated_joints},
    {"R.12", "overconstrained", "loops of Bricard and Bennett", case_overconstrained},
    {"R.13", "ships_on_chain", "heavy ships on rigid chains", case_ships_on_chain},
    {"R.14", "long_motions", "double pendulum, chain of rods: energy and momentum",
     case_long_motions},
    {"R.15", "governor", "flyball governor: course, momentum of a free bearing", case_governor},
};

}  // namespace

std::span<const Case> robust_cases() { return kRobustCases; }

}  // namespace hawser::validate
