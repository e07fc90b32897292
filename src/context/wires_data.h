// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires_data.h
/// Wires and their energies in a step (guard.h).

#include <cstdint>
#include <vector>

namespace hawser::context {

/// Elements and nodes of one wire that are processed together.
struct WirePart {
    std::int32_t wire, element_begin, element_end, node_elements_begin, node_elements_end;
};

/// Energy balance of a wire, or of a part of it, in the step [J].
struct WireGain {
    double gain = 0.0;       ///< Created energy; negative: lost.
    double exchanged = 0.0;  ///< Sum of |changes|.
    double noise = 0.0;      ///< Effect of the rounding of positions.
    double unbooked = 0.0;   ///< Loss beyond the counted loss of rows (losses.cpp).
};

struct Wires {
    static constexpr std::int32_t kBeginsToRecoil = -1;

    // Data by topology.
    std::vector<std::int32_t> wire_of;  ///< Wire of each interaction, −1: none.
    std::vector<std::int32_t> place;    ///< Index of each interaction in `element`.
    std::vector<std::int32_t> element;  ///< Interactions, by wire.
    std::vector<std::int32_t> lump;     ///< Bodies of the nodes, by wire.
    std::vector<WirePart> parts;        ///< Parts, by wire.

    // Data by wire. Part of the state:
    std::vector<double>
        energy_allowance;  ///< Energy allowance: energy lost recently that may return [J].
    std::vector<std::int32_t> flag_steps;  ///< Number of coming steps in which the wire is damped.
    /// Number of coming steps in which the wire recoils after a break; kBeginsToRecoil: not
    /// determined yet.
    std::vector<std::int32_t> recoil;
    // Data of the present step:
    std::vector<std::uint8_t> fast;   ///< 1: its vibration is not resolved.
    std::vector<std::uint8_t> level;  ///< Number of rejections.
    std::vector<WireGain> gain;
    std::vector<WireGain> part_gain;  ///< Energy balance of each part.

    // Data of the present step, by element.
    std::vector<double> pull;         ///< Tension for the geometric stiffness [N].
    std::vector<std::uint8_t> holds;  ///< 1: slack at present, but taut in the bound.

    /// By interaction, 1: another force replaces its row in this step. Empty without wires.
    std::vector<std::uint8_t> replaced;
    bool again = false;      ///< True if the step is being solved again.
    bool replacing = false;  ///< True if some rows are replaced.
    bool measured = false;   ///< True if WireGain of fast wires belongs to the present step.
    bool stale = false;      ///< True if alerts of elements lag behind those of wires.

    [[nodiscard]] std::size_t count() const noexcept { return energy_allowance.size(); }
    [[nodiscard]] bool is_replaced(std::int32_t id) const noexcept {
        return replacing && replaced[static_cast<std::size_t>(id)] != 0;
    }
};

/// Scratch of make_wires().
struct WireWork {
    std::vector<std::int32_t> joined;  ///< First element of the wire of each interaction, −1: none.
    std::vector<std::int32_t> of_body;  ///< First element of each body, −1: none.
    std::vector<std::int32_t> begin;    ///< First element of each wire.
    std::vector<std::int32_t> cursor;   ///< Write position of each wire.
    std::vector<std::int32_t> had;      ///< Number of elements of each earlier wire.
    std::vector<std::uint8_t> seen;     ///< 1: body already visited.
    Wires made;
};

}  // namespace hawser::context
