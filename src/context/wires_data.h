// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires_data.h
/// Wires and what they did in a step (guard.h).

#include <cstdint>
#include <vector>

namespace hawser::stepper {

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
    static constexpr std::int32_t kBeginsToRecoil = -1;

    // By topology.
    std::vector<std::int32_t> wire_of;  ///< By interaction, −1: none.
    std::vector<std::int32_t> place;    ///< By interaction: where in `element`.
    std::vector<std::int32_t> element;  ///< Interactions, wire by wire.
    std::vector<std::int32_t> lump;     ///< Bodies, wire by wire.
    std::vector<WirePart> parts;        ///< Wire by wire.

    // By wire. Part of the state:
    std::vector<double> credit;       ///< Energy lost lately, that may come back [J].
    std::vector<std::int32_t> alert;  ///< So many steps to come are stepped more calmly.
    /// So many steps to come the wire recoils, since it parted; kBeginsToRecoil: to be found.
    std::vector<std::int32_t> recoil;
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

/// Memory to find wires in (make_wires()).
struct WireWork {
    std::vector<std::int32_t> joined;  ///< By interaction: the first element of its wire, −1: none.
    std::vector<std::int32_t> of_body;  ///< By body: its first element, −1: none.
    std::vector<std::int32_t> begin;    ///< By wire: where its elements begin.
    std::vector<std::int32_t> cursor;   ///< By wire.
    std::vector<std::int32_t> had;      ///< By wire of before: how many elements.
    std::vector<std::uint8_t> seen;     ///< By body.
    Wires made;
};

}  // namespace hawser::stepper
