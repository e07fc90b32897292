// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file stability.h
/// Stability gauge: a system that reports whether the pull of a towline or work wire endangers a
/// ship. It computes the permissible tension for the present direction of the wire, the heel, the
/// righting lever and the residual area.
///
/// ```cpp
/// world.add(hawser::StabilityDef{.name = "gauge", .body = ship, .wire = tow,
///                                .pin = {-36.0, 2.0, 4.5}, .thrust_height = -3.0,
///                                .bollard_pull = 1.5e6});
/// world.system_signal("gauge.permissible");     // [N]
/// ```
/// *Heeling lever.* A tension F acts at the horizontal angle α to the centreline, and at β below
/// the waterplane. It has the heeling moment HM and the lever HL (IMO, International Code on Intact
/// Stability, part B, 2.7, MSC.415(97)):
/// ```
///     HM = F (h sin α cos β + y sin β)       HL = HM/Δ cos φ       y = y₀ + x tan α
/// ```
/// Here φ is the heel, h the height of the pin above the thrust line, and y₀ the distance of the
/// pin from the centreline. The stern is at the distance x from the pin. Δ is the weight of the
/// ship plus F sin β.
///
/// *Righting lever.* GZ(φ) follows from the mesh of the hull in the sea, with the added weight F
/// sin β at the height of the pin on the centreline. Without a mesh GZ = GM sin φ.
///
/// *Criteria.* The permissible tension is the largest F that meets all of these criteria:
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
/// - `tension` [N], `alpha`, `beta` [rad]: tension and direction of the wire, α > 0 to starboard;
/// - `moment`: HM [N m]; `lever`: HM over the weight of the ship without F sin β [m];
/// - `worst_beta`: β at which the moment is largest [rad];
/// - `heel_gm`: atan(lever/GM) [rad];
/// - `heel`, `gz`: present heel, > 0 to starboard [rad], and GZ at this heel [m];
/// - `gz_max`, `gz_max_angle`: largest GZ [m] and its heel [rad];
/// - `static_heel` [rad], `residual_area` [m rad], `residual_lever` [m]: criteria 1 to 3 at the
/// present
///   tension;
/// - `permissible` [N], `criterion`: permissible tension, number of the criterion that limits it;
/// - `utilisation`: tension over permissible tension [1];
/// - `alarm`: 0 none, 1 warning, 2 alarm.
///
/// Events of the body: `alarm` and `alarm_end`, with the larger one of the utilisation and
/// |heel|/`most_heel` as value. Level 1 begins at the utilisation `warn`, level 2 when either ratio
/// reaches 1. A level ends at `hysteresis` below its beginning.
///
/// Limits: calm water; heel about the ship's x axis at level trim; the permissible tension is
/// computed every 15 steps. See docs/anchors.md.

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
    double stern_x = kDefault;  ///< Position x of the stern in the body's frame [m]; default: x of
                                ///< the pin.
    double bollard_pull = 0.0;  ///< Bollard pull BP [N]; lower limit of `worst_beta`, see
                                ///< worst_towing_angle().
    double mass = kDefault;     ///< Displacement [kg]; default: mass of the body.
    double gm = kDefault;       ///< Metacentric height GM [m]; required without a mesh.
    double most_heel = 0.2617993877991494;  ///< Largest permitted static heel [rad]; 15°.
    double deck_edge = kDefault;   ///< Heel with the deck edge in the water [rad]; default: none.
    double flooding = kDefault;    ///< Flooding angle [rad]; default: none.
    double residual_area = 0.070;  ///< Least area of criterion 2 [m rad].
    double residual_lever = 0.2;   ///< Least lever of criterion 3 [m].
    Vec3 stern{kDefault, kDefault, kDefault};  ///< Deck at the stern on the centreline, in the
                                               ///< body's frame [m]; default: no criterion 4.
    double freeboard = kDefault;               ///< Least freeboard of criterion 4 [m]; default:
                                               ///< 0.005 of the mesh's length.
    double gravity = 9.81;                     ///< Gravity [m/s²].
    double warn = 0.8;                         ///< Utilisation at which alarm level 1 begins [1].
    double hysteresis = 0.05;                  ///< Difference of the utilisations at which a level
                                               ///< begins and ends [1].
};

/// Return the heeling moment HM of a towline [N m].
/// @param force  Tension F [N].
/// @param alpha, beta  Horizontal angle to the centreline, angle below the waterplane [rad].
/// @param height  Height h of the pin above the thrust line [m].
/// @param y  Distance y of the force from the centreline, y₀ + x tan α [m].
[[nodiscard]] double towing_moment(double force, double alpha, double beta, double height,
                                   double y) noexcept;
/// Return the angle β at which the moment HM is largest [rad]. It is at least acos(1.5 BP/(F cos
/// α)), if this exists: at smaller β the force along the ship, F cos α cos β, would exceed 1.5 BP.
/// Parameters as towing_moment().
/// @param bollard_pull  Bollard pull BP [N].
[[nodiscard]] double worst_towing_angle(double force, double alpha, double height, double y,
                                        double bollard_pull) noexcept;

/// Result of the criteria for one tension.
struct StabilityCheck {
    double moment = 0.0;          ///< Heeling moment HM [N m].
    double static_heel = 0.0;     ///< Heel of the first intersection of HL and GZ [rad]; NaN: none.
    double residual_area = 0.0;   ///< Area of criterion 2 [m rad].
    double residual_lever = 0.0;  ///< Largest GZ − HL [m].
    int criterion = 0;            ///< Number of the first criterion that fails; 0: none.
};
/// Compute the criteria of a gauge at a given tension and direction.
/// @param name  Name of the gauge.
/// @param force  Tension F [N].
/// @param alpha, beta  Direction, as in towing_moment() [rad].
/// @throws DefError if there is no such gauge.
[[nodiscard]] StabilityCheck check_stability(const World& world, std::string_view name,
                                             double force, double alpha, double beta);
/// Compute the permissible tension of a gauge for a given direction [N]. Parameters as
/// check_stability().
/// @throws DefError if there is no such gauge.
[[nodiscard]] double permissible_tension(const World& world, std::string_view name, double alpha,
                                         double beta);
/// Compute the GZ curve of the ship of a gauge without a towline, as pairs of heel [rad] and lever
/// [m].
/// @param name  Name of the gauge.
/// @throws DefError if there is no such gauge.
[[nodiscard]] std::vector<std::array<double, 2>> gz_curve(const World& world,
                                                          std::string_view name);

/// Add a gauge; World::add() calls it, after the sea with the ship's hull.
/// @throws DefError "stability 'NAME': field: reason".
System* define(World& world, const StabilityDef& def);

}  // namespace hawser
