// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stability.h
/// Stability gauge of a ship with a towline. It reports the permissible tension for the present
/// direction of the wire, the heel, the righting lever and the residual area.
///
/// ```cpp
/// world.add(hawser::StabilityDef{.name = "gauge", .body = ship, .wire = tow,
///                                .pin = {-36.0, 2.0, 4.5}, .thrust_height = -3.0,
///                                .bollard_pull = 1.5e6});
/// world.system_signal("gauge.permissible");     // [N]
/// ```
/// *Heeling lever.* A tension F has the horizontal angle α to the centreline and β below the
/// waterplane. Its lever (IMO, International Code on Intact Stability, part B, 2.7, MSC.415(97))
/// is:
/// ```
///     HM = F (h sin α cos β + y sin β)       HL = HM/Δ cos φ       y = y₀ + x tan α
/// ```
/// Here h is the height of the pin above the thrust line, and y₀ its distance from the
/// centreline. The stern is at the distance x from the pin. Δ is the weight of the ship plus F sin
/// β.
///
/// *Righting lever.* GZ is that of the mesh of the hull in the sea, with the added weight F sin β
/// at the height of the pin on the centreline. Without a mesh it is GM sin φ.
///
/// *Criteria.* The permissible tension is the largest F with all of:
/// 1. first intersection of HL and GZ ≤ the angle with half of the largest GZ, the deck edge in the
///    water, and `most_heel`;
/// 2. area between GZ and HL from there to the second intersection or the flooding angle ≥
///    `residual_area`;
/// 3. largest GZ − HL ≥ `residual_lever`;
/// 4. freeboard at the stern ≥ `freeboard` (if `stern` is given).
///
/// *Several wires.* F and its direction are those of the summed forces of all wires. A towline acts
/// by its first element beyond the pin. A wire of `others` acts by the element that crosses the
/// plane of the pin, across the ship.
///
/// Outputs, as "name.signal":
/// - `tension` [N], `alpha`, `beta` [rad], `moment` [N m];
/// - `lever` HM/Δ [m] with Δ the weight of the ship alone;
/// - `worst_beta` [rad] of the largest moment;
/// - `heel_gm` [rad] = atan(lever/GM), `heel` [rad] (positive to starboard), `gz` [m] at it;
/// - `gz_max` [m], `gz_max_angle` [rad], `static_heel` [rad];
/// - `residual_area` [m rad], `residual_lever` [m], `permissible` [N];
/// - `criterion` (number of the criterion that limits it), `utilisation` [1];
/// - `alarm` (0 none, 1 warning, 2 alarm).
///
/// Events of the body: `alarm` and `alarm_end`, value: utilisation. Level 1 begins at `warn`, level
/// 2 at 1 or at |heel| ≥ `most_heel`; a level ends `hysteresis` below.
///
/// Limits: calm water, heel about the ship's x axis at level trim; docs/anchors.md.

#include <hawser/id.h>
#include <hawser/interactions.h>
#include <hawser/math.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace hawser {

class World;
class System;

/// Definition of a gauge; World::add() copies it.
struct StabilityDef {
    std::string name = "stability";  ///< Unique name among systems.
    BodyId body{};  ///< Ship, a rigid body; its x axis points to the bow. Required.
    WireId wire{};  ///< Towline; its end on the ship's side is found. Required.
    /// Further wires that may pass the stern, such as a pennant on a hook or a chain in a shark
    /// jaw. Their ends need not be on the ship.
    std::vector<WireId> others{};
    Vec3 pin{0.0, 0.0, 0.0};  ///< Inner side of the towing pin at the highest support of the
                              ///< wire, in the body's frame [m]. Required.
    /// Height z of the thrust line in the body's frame [m]. Default: half of the mesh's draught.
    double thrust_height = kDefault;
    double stern_x = kDefault;  ///< Position x of the stern [m]; default: that of the pin.
    double bollard_pull = 0.0;  ///< BP [N]; limits the angle β of the largest moment.
    double mass = kDefault;     ///< Displacement [kg]; default: mass of the body.
    double gm = kDefault;       ///< Metacentric height [m]; required without a mesh.
    double most_heel = 0.2617993877991494;  ///< [rad]; 15°.
    double deck_edge = kDefault;   ///< Heel with the deck edge in the water [rad]; default: none.
    double flooding = kDefault;    ///< Flooding angle [rad]; default: none.
    double residual_area = 0.070;  ///< [m rad].
    double residual_lever = 0.2;   ///< [m].
    Vec3 stern{kDefault, kDefault, kDefault};  ///< Deck at the stern on the centreline, in the
                                               ///< body's frame [m]; default: no criterion 4.
    double freeboard = kDefault;               ///< [m]; default: 0.005 of the mesh's length.
    double gravity = 9.81;                     ///< [m/s²].
    double warn = 0.8;                         ///< Utilisation of level 1 [1].
    double hysteresis = 0.05;                  ///< [1].
};

/// Return the heeling moment HM of a towline [N m].
[[nodiscard]] double towing_moment(double force, double alpha, double beta, double height,
                                   double y) noexcept;
/// Return β of the largest moment [rad], at least acos(1.5 BP/(F cos α)) if that exists.
[[nodiscard]] double worst_towing_angle(double force, double alpha, double height, double y,
                                        double bollard_pull) noexcept;

/// Result of the criteria for one tension.
struct StabilityCheck {
    double moment = 0.0;          ///< HM [N m].
    double static_heel = 0.0;     ///< First intersection [rad]; NaN: none.
    double residual_area = 0.0;   ///< [m rad].
    double residual_lever = 0.0;  ///< Largest GZ − HL [m].
    int criterion = 0;            ///< First criterion that fails; 0: none.
};
/// Compute the criteria of a gauge at a tension and direction.
/// @throws DefError if there is no such gauge.
[[nodiscard]] StabilityCheck check_stability(const World& world, std::string_view name,
                                             double force, double alpha, double beta);
/// Compute the permissible tension of a gauge for a direction [N].
/// @throws DefError if there is no such gauge.
[[nodiscard]] double permissible_tension(const World& world, std::string_view name, double alpha,
                                         double beta);
/// Return the GZ curve of a gauge without towline, as pairs of heel [rad] and lever [m].
/// @throws DefError if there is no such gauge.
[[nodiscard]] std::vector<std::array<double, 2>> gz_curve(const World& world,
                                                          std::string_view name);

/// Add a gauge; World::add() calls it, after the sea with the ship's hull.
/// @throws DefError "stability 'NAME': field: reason".
System* define(World& world, const StabilityDef& def);

}  // namespace hawser
