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
/// The numbers of the last four ships are from the Marine Systems Simulator (MSS, MIT licence).
///
/// Sources do not describe heave, roll and pitch of kvlcc2, mariner and esso_190k, and heave and
/// pitch of s175. These motions have assumed properties: the stiffness of a waterplane of 0.85 L B,
/// a GM of 5 % of the beam, and a damping ratio of 0.2. The bodies are weightless, and calm water
/// does not excite these motions.

#include <hawser/def.h>
#include <hawser/vessel.h>

#include <cstdint>
#include <string_view>

namespace hawser {

/// Published ship: a body at the origin with its bow along x and its approach speed, and its
/// vessel.
struct PublishedShip {
    BodyDef body{};       ///< Body.
    VesselDef vessel{};   ///< Vessel; the caller sets VesselDef::body to the added body.
    double length = 0.0;  ///< L [m].
    double speed = 0.0;   ///< Approach speed U₀ [m/s].
};

/// Scale of the tanker KVLCC2: models of 7 m and 3 m length, or full scale.
enum class KvlccScale : std::uint8_t { l7, l3, full };
/// Return the tanker KVLCC2.
[[nodiscard]] PublishedShip kvlcc2(KvlccScale scale);
/// Return the cargo ship Mariner.
[[nodiscard]] PublishedShip mariner();
/// Return the container ship S175.
[[nodiscard]] PublishedShip s175();
/// Return the tanker Esso 190,000 dwt. Its approach speed is the steady speed at 80 rpm in the
/// given depth of water.
/// @param depth  Depth of the water, above 1.05 draughts, 19.383 m [m]; 1000 or more: deep water.
/// @throws DefError if the depth is too small.
[[nodiscard]] PublishedShip esso_190k(double depth = 1000.0);
/// Return Fossen's offshore supply vessel, at rest.
[[nodiscard]] PublishedShip osv();

/// Names of the ships for published_ship().
inline constexpr const char* kPublishedShips[] = {"kvlcc2", "kvlcc2_l7", "kvlcc2_l3", "mariner",
                                                  "s175",   "esso_190k", "osv"};
/// Return a ship by its name in kPublishedShips.
/// @param depth  Depth of the water for esso_190k() [m].
/// @throws DefError if the name is unknown.
[[nodiscard]] PublishedShip published_ship(std::string_view name, double depth = 1000.0);

}  // namespace hawser
