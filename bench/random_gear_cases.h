// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file random_gear_cases.h
/// Generate random scenes with winches, guides, moored hulls or ships, as scene documents
/// (docs/scenes.md), with the outputs by which two runs of a scene are compared.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hawser::bench {

enum class GearFamily : std::uint8_t {
    winches,  ///< A winch in changing modes lifts a load or hauls a float.
    guides,   ///< A wire over or under a roller between a winch and a float that is pulled away.
    hulls,    ///< A barge on two to four chains, in still water or in waves.
    ships,    ///< Scaled vessels of the library with random orders, Hs 0 to 6 m. Run in the root of
              ///< the source tree.
    passive_posts,    ///< A wire between two masses falls on bollards.
    passive_guides,   ///< A wire from a mass on a table over a roller to a hanging mass.
    passive_hanging,  ///< A box on a wire, taut or slack at the start.
};

[[nodiscard]] std::string_view to_string(GearFamily family) noexcept;
/// Return a family by its name. @return nullopt if no family has this name.
[[nodiscard]] std::optional<GearFamily> gear_family(std::string_view name) noexcept;

/// An output by which two runs are compared. Mean values of intervals may differ by `absolute +
/// relative × scale`. Scale: largest change of the mean since the start, or for tensions the
/// largest mean.
struct Probe {
    std::string output;
    double absolute = 0.0;  ///< In the unit of the output.
    double relative = 0.0;
    bool tension = false;
};

struct GearCase {
    std::string text;            ///< The scene.
    double step = 0.0;           ///< [s]
    double duration = 0.0;       ///< [s]
    double motor_power = 1e300;  ///< Limit of the winch's motor [W].
    bool passive = false;        ///< True if the energy of the scene must not rise.
    std::vector<Probe> probes;
};

/// Generate the case `number` of a seed. It does not depend on other cases.
[[nodiscard]] GearCase make_gear_case(GearFamily family, std::uint64_t seed, std::uint64_t number);

}  // namespace hawser::bench
