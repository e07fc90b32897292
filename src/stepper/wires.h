// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// The guard over wires: no step leaves a wire with energy that nothing gave it.
///
/// A *wire* is a connected set of elastic lines between points, coupled by lumps. A step holds the
/// direction of each element, and the tension behind its geometric stiffness, as they were where it
/// began. Where an element swings far within a step, that brings energy out of nothing, and a wire
/// of lumps then shakes itself to pieces. So the energy of each wire is counted at the half steps
/// before and after, where velocities live, from its true lengths (wire_energy.cpp); a step that
/// gains more than a thousandth of what was exchanged, and more than lately was lost, is solved
/// again for the wires that gained, each time more carefully (wire_plan.cpp):
///
///   1-3  with a tension as large as the refused step has brought about; from 2 on without the
///        part of the stiffness that gives back what it held;
///   4-7  by a force that holds no more energy than the elements do: the step cannot gain then.
///
/// Source of the last: a convex quadratic bound of the elements' energy, as in
/// majorise-minimise methods (Lange, *MM optimization algorithms*, SIAM 2016): docs/methods.md, 12.
/// Wires whose swing the step resolves are not looked at.

#include <hawser/stats.h>

#include "assembly/view.h"

#include <cstdint>
#include <vector>

namespace hawser::stepper {

struct StepContext;

/// Elements and lumps of one wire that are looked at together.
struct WirePart {
    std::int32_t wire, element_begin, element_end, lump_begin, lump_end;
};

/// What a wire did in the step, or a part of it [J].
struct WireGain {
    double gain = 0.0;       ///< Energy out of nothing; negative: lost.
    double exchanged = 0.0;  ///< Sum of |changes|.
    double noise = 0.0;      ///< What rounding of positions makes of it.
    double unbooked = 0.0;   ///< Lost beyond what rows are counted to lose (losses.cpp).
};

struct Wires {
    // By topology.
    std::vector<std::int32_t> wire_of;  ///< By interaction, −1: none.
    std::vector<std::int32_t> place;    ///< By interaction: where in `element`.
    std::vector<std::int32_t> element;  ///< Interactions, wire by wire.
    std::vector<std::int32_t> lump;     ///< Bodies, wire by wire.
    std::vector<WirePart> parts;        ///< Wire by wire.

    // By wire. Part of the state:
    std::vector<double> credit;       ///< Energy lost lately, that may come back [J].
    std::vector<std::int32_t> alert;  ///< So many steps to come are stepped more calmly.
    // Of the step being taken:
    std::vector<std::uint8_t> fast;   ///< 1: its swing is not resolved.
    std::vector<std::uint8_t> level;  ///< How often it has been refused.
    std::vector<WireGain> gain;
    std::vector<WireGain> part_gain;  ///< By part.

    // By element, of the step being taken.
    std::vector<double> pull;         ///< Tension that its stiffness is to reckon with [N].
    std::vector<std::uint8_t> holds;  ///< Slack as it is, but taut in the bound.

    /// By interaction, 1: its row gives way to another force in this step. Empty without wires.
    std::vector<std::uint8_t> replaced;
    bool again = false;      ///< The step is being solved again.
    bool replacing = false;  ///< Some are replaced.
    bool measured = false;   ///< WireGain of fast wires is that of the step being taken.
    bool stale = false;      ///< Alerts of elements are behind those of wires.

    [[nodiscard]] std::size_t count() const noexcept { return credit.size(); }
    [[nodiscard]] bool gives_way(std::int32_t id) const noexcept {
        return replacing && replaced[static_cast<std::size_t>(id)] != 0;
    }
};

/// Find the wires, after bodies or interactions were added. @throws std::bad_alloc.
void make_wires(StepContext& ctx);
/// After the step has been solved, and before bodies move: solve it again where wires gain energy.
[[nodiscard]] Status guard_wires(StepContext& ctx) noexcept;
/// After the staggered start: lumps of fast wires begin with the velocity that they were given,
/// which is half a step late. That of half a step before follows from a trial step, which does not
/// resolve how fast elements swing along.
void calm_start(StepContext& ctx) noexcept;
/// Rows that gave way in a step that was not taken follow their law again.
void release_wires(StepContext& ctx) noexcept;
/// What the step that is being taken leaves for the next ones.
void remember_gains(StepContext& ctx) noexcept;
/// Write what refused wires are stepped with over what evaluate() wrote, of one strip.
void replan_wires(StepContext& ctx, const assembly::View& v, int strip) noexcept;
/// Multipliers and states of elements that gave way, once their losses are counted.
void settle_wires(StepContext& ctx) noexcept;
/// Steps that a wire is stepped more calmly for after it has been refused.
[[nodiscard]] std::int32_t most_alert(double step) noexcept;
/// What a restored state says of alerts becomes the elements'; what cannot be is mended.
void follow_alerts(StepContext& ctx) noexcept;

/// Elastic energy of an element at the half step before the poses at hand [J].
[[nodiscard]] double held_by_element(const assembly::View& v, std::int32_t id) noexcept;

// wire_energy.cpp
/// Mark wires that are not resolved. @return whether there are any.
[[nodiscard]] bool find_fast_wires(StepContext& ctx) noexcept;
/// Wires::gain of the fast ones.
void measure_wires(StepContext& ctx) noexcept;

// wire_plan.cpp
/// What refused wires are to be solved with next, from the solution that was refused.
void plan_wires(StepContext& ctx, std::int32_t wire) noexcept;

}  // namespace hawser::stepper
