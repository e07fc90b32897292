// SPDX-License-Identifier: Apache-2.0
#pragma once
// Shared parts of the cases in which a winch lowers an anchor and hauls it up again.
#include "validate/tools.h"

#include <hawser/winch.h>
#include <hawser/wire.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace hawser::validate::payout {

inline constexpr double kStep = 1.0 / 60.0;
inline constexpr double kLineMass = 23.0, kLineEA = 2.33e8;     // kg/m, N
inline constexpr double kTowAnchorMass = 13e3;                  // kg
inline constexpr double kPayoutStored = 1500.0, kWire = 0.076;  // m
inline constexpr double kRampSeconds = 10.0;                    // s, duration of a change of speed

/// Return the speed of the winch at time t as a fraction of its final value. It rises and falls
/// within kRampSeconds without a jump of acceleration, and is constant for `even` [s]. A jump would
/// let the anchor bounce for minutes if there is no damping.
inline double speed_at(double t, double even) {
    const auto ramp = [](double x) {
        const double u = std::clamp(x / kRampSeconds, 0.0, 1.0);
        return u - std::sin(2.0 * kPi * u) / (2.0 * kPi);
    };
    return ramp(t) - ramp(t - even - kRampSeconds);
}

/// Return the wire on the drum. @param element  Length of its elements [m]. @param damping
/// WireDef::axial_damping.
inline WireDef trial_line(int elements, double element, double damping) {
    WireDef def;
    def.name = "wire";
    def.elements = elements;
    def.length = element * elements;
    def.EA = kLineEA;
    def.mass_per_length = kLineMass;
    def.axial_damping = damping;
    def.consistent_mass = true;
    return def;
}

/// Return the winch of the trial wire, in the mode `speed`.
inline WinchDef trial_winch(WireId wire, int end = 0) {
    return {.name = "winch",
            .wire = wire,
            .end = end,
            .core_radius = 0.6,
            .width = 2.4,
            .flange_radius = 1.4,
            .wire_diameter = kWire,
            .mass_per_length = kLineMass,
            .stored = kPayoutStored,
            .inertia = 4e4,
            .mode = WinchMode::speed};
}

/// Changes of a tension in a step.
struct Changes {
    double elsewhere = 0.0;  ///< Largest change in a step far from an edit [N] …
    double at_edits = 0.0;   ///< … and within half a second of one.
    double tension = 0.0;    ///< Largest [N].
};
/// Return the largest changes of a tension per step, near edits and elsewhere. @param edits  Steps
/// after which nodes were added or removed, ascending.
inline Changes largest_changes(const std::vector<double>& pull,
                               const std::vector<std::size_t>& edits) {
    Changes r;
    std::size_t next = 0;
    for (std::size_t i = 120; i + 1 < pull.size(); ++i) {
        while (next < edits.size() && edits[next] + 30 < i) ++next;
        double& most = next < edits.size() && edits[next] <= i + 1 ? r.at_edits : r.elsewhere;
        most = std::max(most, std::abs(pull[i + 1] - pull[i]));
        r.tension = std::max(r.tension, pull[i]);
    }
    return r;
}

}  // namespace hawser::validate::payout
