// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_ships.h
/// Ships with published coefficients, as bodies and vessels (vessel.h).
///
/// | ship | source | freedoms |
/// |---|---|---|
/// | kvlcc2 | MMG standard method, H. Yasukawa and Y. Yoshimura 2015 | surge, sway, yaw |
/// | mariner | M. S. Chislett and J. Strøm-Tejsen 1965 | surge, sway, yaw |
/// | s175 | K. H. Son and K. Nomoto 1981 | surge, sway, yaw, roll |
/// | esso_190k | W. B. van Berlekom and T. A. Goddard 1972, depth of water | surge, sway, yaw |
/// | osv | T. I. Fossen's offshore supply vessel (MSS, osv.m) | six |
///
/// Numbers of the last four are from the Marine Systems Simulator (MSS, MIT licence).
///
/// Heave, roll and pitch of kvlcc2, mariner and esso_190k, and heave and pitch of s175, are
/// assumed, not published. They have the stiffness of a waterplane of 0.85 L B, a GM of 5 % of the
/// beam, and a damping ratio of 0.2. The bodies are weightless, and calm water does not excite
/// these motions.

#include <hawser/def.h>
#include <hawser/vessel.h>

#include <cstdint>
#include <string_view>

namespace hawser {

/// A body at the origin with its bow along x, at its approach speed, and the vessel on it.
struct PublishedShip {
    BodyDef body{};
    VesselDef vessel{};   ///< The caller sets VesselDef::body.
    double length = 0.0;  ///< L [m].
    double speed = 0.0;   ///< Approach speed U₀ [m/s].
};

enum class KvlccScale : std::uint8_t { l7, l3, full };
[[nodiscard]] PublishedShip kvlcc2(KvlccScale scale);
[[nodiscard]] PublishedShip mariner();
[[nodiscard]] PublishedShip s175();
/// Return Esso 190,000 dwt. The approach speed is that of 80 rpm in this depth. @param depth  Depth
/// of the water, above 19.5 m [m]; 1000 or more: deep. @throws DefError.
[[nodiscard]] PublishedShip esso_190k(double depth = 1000.0);
/// Return Fossen's offshore supply vessel, at rest.
[[nodiscard]] PublishedShip osv();

/// Names of ships: "kvlcc2_l7", "kvlcc2_l3", "kvlcc2", "mariner", "s175", "esso_190k", "osv".
inline constexpr const char* kPublishedShips[] = {"kvlcc2", "kvlcc2_l7", "kvlcc2_l3", "mariner",
                                                  "s175",   "esso_190k", "osv"};
/// Return a ship by its name. @throws DefError if the name is unknown.
[[nodiscard]] PublishedShip published_ship(std::string_view name, double depth = 1000.0);

}  // namespace hawser
