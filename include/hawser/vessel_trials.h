// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_trials.h
/// Manoeuvring trials of a vessel in its world: turning circle, zig-zag, criteria of
/// IMO MSC.137(76), "Standards for ship manoeuvrability", 2002.
/// ```
///            transfer            Turning circle: rudder to δ at the start of the track.
///          |<------>|            Advance: way along the first heading to a change of 90°.
///      .--''''--.  ---           Transfer: way across it to there.
///    .'          '  ^            Tactical diameter: way across to a change of 180°.
///   |            |  | advance
///    '.          |  v            Zig-zag δ/ψ: rudder to δ; at a heading change ψ to −δ, at −ψ
///      '-.____.  | ---           to δ … (executes). Overshoot: heading change beyond ψ.
///   |<--------->|^ start
///    tactical diameter
/// ```
/// Tracks are the paths of VesselDef::origin; times and angles are interpolated between steps.

#include <hawser/vessel.h>

#include <string>
#include <vector>

namespace hawser {

/// Result of a turning circle.
struct TurningCircle {
    bool turned = false;                 ///< True if the ship reached a heading change of 180°.
    double advance = 0.0;                ///< Advance [m].
    double transfer = 0.0;               ///< Transfer [m].
    double tactical = 0.0;               ///< Tactical diameter [m].
    double time90 = 0.0, time180 = 0.0;  ///< Times of heading changes of 90° and 180° [s].
    double track10 = 0.0;                ///< Way along the track to a heading change of 10° [m].
    // Values at the end of the run.
    double speed = 0.0;      ///< Speed [m/s].
    double turn_rate = 0.0;  ///< Turn rate r, positive to starboard [rad/s].
    double drift = 0.0;      ///< Drift angle β [rad].
    double roll = 0.0;       ///< Roll φ, positive with starboard down [rad].
    double most_roll = 0.0;  ///< Largest |φ| since the start [rad].
};

/// Result of a zig-zag trial.
struct ZigZagTrial {
    std::vector<double> executes{};    ///< Times of the second and later rudder orders [s].
    std::vector<double> overshoots{};  ///< Overshoot angles in order [rad].
    double most_roll = 0.0;            ///< Largest |φ| since the start [rad].
};

/// Run a turning circle: put the rudder over by the signal NAME.rudder, and step the world.
/// @param rudder  Rudder order, positive turns to starboard [rad].
/// @param duration  Simulated time [s].
/// @throws DefError if a step fails, or if the vessel has no such signal.
[[nodiscard]] TurningCircle turning_circle(World& world, const VesselDef& vessel, double rudder,
                                           double duration);
/// Run a zig-zag trial until a number of overshoots or a time is reached.
/// @param rudder  Rudder angle δ of the first order; negative: first to port [rad].
/// @param heading  Heading change ψ > 0 at which the rudder is reversed [rad].
/// @param count  Number of overshoots.
/// @param most  Longest simulated time [s].
/// @throws DefError as turning_circle().
[[nodiscard]] ZigZagTrial zig_zag(World& world, const VesselDef& vessel, double rudder,
                                  double heading, int count, double most = 3600.0);

/// Criterion of IMO MSC.137(76), with the result of a ship.
struct ImoCriterion {
    std::string what{};               ///< Name of the criterion.
    double value = 0.0, limit = 0.0;  ///< Result and its upper limit, in `unit`.
    std::string unit{};               ///< Unit of both: "L" (ship lengths) or "deg".
    /// True if the ship meets the criterion.
    [[nodiscard]] bool met() const noexcept { return value <= limit; }
};
/// Compare trials with the IMO criteria. Criteria without a result in the trials are omitted.
/// @param length  Length of the ship [m].
/// @param speed  Approach speed [m/s].
/// @param turn  Turning circle with full rudder.
/// @param small  10°/10° zig-zag.
/// @param large  20°/20° zig-zag.
[[nodiscard]] std::vector<ImoCriterion> imo_criteria(double length, double speed,
                                                     const TurningCircle& turn,
                                                     const ZigZagTrial& small,
                                                     const ZigZagTrial& large);

}  // namespace hawser
