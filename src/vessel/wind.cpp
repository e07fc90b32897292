// SPDX-License-Identifier: Apache-2.0
/// Wind on ships by W. Blendermann, "Parameter identification of wind loads on ships", 1994.
#include <hawser/vessel_hull.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace hawser {
namespace {

struct WindParameters {
    const char* name;
    double transverse;  ///< C_Dt.
    double bow, stern;  ///< C_Dl,AF.
    double cross;       ///< δ.
    double roll;        ///< κ.
};
constexpr WindParameters kWindShips[] = {{"none", 0.0, 0.0, 0.0, 0.0, 0.0},
                                         {"car_carrier", 0.95, 0.55, 0.60, 0.80, 1.2},
                                         {"cargo", 0.85, 0.65, 0.55, 0.40, 1.7},
                                         {"container", 0.90, 0.55, 0.55, 0.40, 1.4},
                                         {"diving_support", 0.90, 0.60, 0.80, 0.55, 1.7},
                                         {"drilling", 1.00, 0.85, 0.925, 0.10, 1.7},
                                         {"ferry", 0.90, 0.45, 0.50, 0.80, 1.1},
                                         {"fishing", 0.95, 0.70, 0.70, 0.40, 1.1},
                                         {"gas_tanker", 0.70, 0.60, 0.65, 0.50, 1.1},
                                         {"offshore_supply", 0.90, 0.55, 0.80, 0.55, 1.2},
                                         {"research", 0.85, 0.55, 0.65, 0.60, 1.4},
                                         {"tanker_loaded", 0.70, 0.90, 0.55, 0.40, 3.1},
                                         {"tanker_ballast", 0.70, 0.75, 0.55, 0.40, 2.2},
                                         {"tender", 0.85, 0.55, 0.55, 0.65, 1.1}};
static_assert(sizeof kWindShips / sizeof kWindShips[0] == kWindShipCount);

}  // namespace

const char* to_string(WindShip ship) noexcept {
    return kWindShips[static_cast<std::size_t>(ship)].name;
}

WindCoefficients wind_coefficients(const WindLoad& load, double angle) noexcept {
    const WindParameters& p = kWindShips[static_cast<std::size_t>(load.ship)];
    if (load.ship == WindShip::none || !(load.lateral_area > 0.0)) return {};
    const double e = std::abs(angle), side = angle < 0.0 ? -1.0 : 1.0;
    const double along = e <= 0.5 * std::numbers::pi ? p.bow : p.stern;
    const double lateral = along * load.frontal_area / load.lateral_area;
    const double twice = std::sin(2.0 * e);
    const double share = 1.0 - 0.5 * p.cross * (1.0 - lateral / p.transverse) * twice * twice;
    WindCoefficients out;
    out.x = -along * std::cos(e) / share;
    // Wind from starboard pushes to port.
    out.y = -side * p.transverse * std::sin(e) / share;
    const double mean_height = load.lateral_area / load.length;
    out.k = p.roll * load.height / mean_height * out.y;  // acts at z = -height: K = height Y
    out.n = (load.centre / load.length - 0.18 * (e - 0.5 * std::numbers::pi)) * out.y;
    return out;
}

}  // namespace hawser
