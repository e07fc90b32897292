// SPDX-License-Identifier: Apache-2.0
#include "validate/wires.h"

namespace hawser::validate {
namespace {

constexpr Case kWireCases[] = {
    {"W.1", "wire_catenary", "elastic catenaries of 20, 40 and 100 elements", case_wire_catenary},
    {"W.2", "wire_touchdown", "a chain on the seabed, with friction and without",
     case_wire_touchdown},
    {"W.3", "wire_events", "nodes that come and go: momenta, energy, tension", case_wire_events},
    {"W.4", "wire_parting", "recoil of a wire that parts, at any damping", case_wire_parting},
    {"W.5", "wire_pulse", "a pulse across, from elements of 5 m into 10 m", case_wire_pulse},
    {"W.6", "payout", "a winch lowers an anchor by 600 m and hauls it up again", case_payout},
    {"W.7", "tow_payout", "a tug pays out its tow line over the stern roller", case_tow_payout},
    {"W.8", "wire_resolution", "nodes by tension, curvature and contact: rest, a roller, chance",
     case_wire_resolution},
    {"W.9", "wire_cross_parting", "a wire parts beside wires that cross it, 100 at random",
     case_wire_cross_parting},
};

}  // namespace

std::span<const Case> wire_cases() { return kWireCases; }

}  // namespace hawser::validate
