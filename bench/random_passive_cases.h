// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_passive_cases.h
/// Generate random scenes of passive wires: bollards, guides and hanging loads without motor and
/// sea. Mechanical energy must not rise in them (passive_energy.h).

#include "random_gear_cases.h"

#include <cstdint>

namespace hawser::bench {

/// True for the families of passive wires.
[[nodiscard]] bool is_passive(GearFamily family) noexcept;

/// Generate the case `number` of a seed. The steps are 1/60, 1/30 and 0.05 s in turn. A case does
/// not depend on other cases.
[[nodiscard]] GearCase make_passive_case(GearFamily family, std::uint64_t seed,
                                         std::uint64_t number);

}  // namespace hawser::bench
