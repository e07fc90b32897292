// SPDX-License-Identifier: Apache-2.0
#include "validate/sea.h"

namespace hawser::validate {
namespace {

constexpr Case kSeaCases[] = {
    {"S.1", "sea_waves", "lengths of waves in deep and shallow water", case_sea_waves},
    {"S.2", "sea_statistics", "JONSWAP of 20 seeds over 3 h, gusts of NPD", case_sea_statistics},
    {"S.3", "sea_box", "draught and righting levers of a box", case_sea_box},
    {"S.4", "sea_periods", "heave and roll of a box", case_sea_periods},
    {"S.5", "sea_froude_krylov", "pressure of waves on a fixed box", case_sea_froude_krylov},
    {"S.6", "sea_drag", "lumps, chain and drifters in water that moves", case_sea_drag},
    {"S.7", "sea_stability", "drag many times what a step resolves", case_sea_stability},
    {"S.8", "sea_sphere", "a sphere let go: radiation", case_sea_sphere},
};

constexpr Case kLong[] = {
    {"S.10", "sea_stability_hour", "the same for an hour", case_sea_stability_hour},
};

constexpr Case kWithData[] = {
    {"S.9", "rao", "a semi-submersible in regular waves beside WAMIT", case_sea_rao},
};

}  // namespace

std::span<const Case> sea_cases() { return kSeaCases; }
std::span<const Case> long_sea_cases() { return kLong; }
std::span<const Case> data_cases() { return kWithData; }

}  // namespace hawser::validate
