// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file ships.h
/// Set the data that published ships have in common (hawser/vessel_ships.h).

#include <hawser/vessel_ships.h>

namespace hawser::vessel {

/// Dimensions of a ship.
struct MainSizes {
    double length = 0.0, beam = 0.0, draught = 0.0;  ///< [m].
    double mass = 0.0;                               ///< [kg].
    double density = 1025.0;                         ///< [kg/m³].
};

/// Set heave, roll and pitch of a ship for which they are not published: it stays upright unless
/// loaded.
/// @param roll  Set roll, too.
void set_default_stability(PublishedShip& ship, const MainSizes& sizes, bool roll);

/// Set mass and inertia from radii of gyration in roll and yaw [m]; pitch uses that of yaw.
void set_body(PublishedShip& ship, const MainSizes& sizes, double roll_radius, double yaw_radius);

}  // namespace hawser::vessel
