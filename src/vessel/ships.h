// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ships.h
/// What published ships share (hawser/vessel_ships.h).

#include <hawser/vessel_ships.h>

namespace hawser::vessel {

/// Dimensions of a ship.
struct MainSizes {
    double length = 0.0, beam = 0.0, draught = 0.0;  ///< [m].
    double mass = 0.0;                               ///< [kg].
    double density = 1025.0;                         ///< [kg/m³].
};

/// Heave, roll and pitch of a ship without published ones: they stay at rest unless loaded.
/// @param roll  With roll.
void keep_upright(PublishedShip& ship, const MainSizes& sizes, bool roll);

/// Body of this mass with radii of gyration in roll and yaw [m]; pitch has that of yaw.
void set_body(PublishedShip& ship, const MainSizes& sizes, double roll_radius, double yaw_radius);

}  // namespace hawser::vessel
