// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_power.h
/// Power bus of a vessel (vessel.h): switchboards, generators, consumers with priorities.
///
/// Each step the bus reads the power that each consumer would take without it, and grants power by
/// priority. A grant acts on a propulsor like a limit of its motor.
/// ```
///     generators --+-- board A --+-- tie --+-- board B --+-- generators
///                  |             |         |             |
///             consumers      hotel load            consumers
/// ```
/// *Capacity.* Sum of the generators of a board that run; 0 of a failed board. A closed tie joins
/// all boards that did not fail into one. `share` of the capacity goes to consumers; the rest is
/// reserve.
///
/// *Grants.* By ascending `priority` (1 first), each consumer gets its demand P/η while capacity
/// lasts. Consumers of one priority share the remainder in proportion to their demands. Withheld
/// power begins with the event `shed` of the body.
///
/// *Demand.* Propeller with a shaft: power of its motor within its own limits. Other propellers:
/// power at the ordered revolutions. Ideal propulsor: `power` times |order|³; a grant limits the
/// order to the cube root. Load (not a propulsor): the input NAME [W]. Signal: a signal of another
/// system in W, such as a winch. The bus serves it and does not limit it. Power that a propeller
/// gives back does not feed the bus.
///
/// Signals. Inputs: `tie` [0, 1] with two boards or more, GENERATOR_failed, BOARD_failed [0, 1],
/// NAME [W] of a load. Outputs: BOARD_load, BOARD_spare [W] (with a closed tie those of all joined
/// boards), NAME_shed: power withheld [W].
///
/// Limits: steady state of generators; no frequency, no start-up time, no blackout.

#include <string>
#include <vector>

namespace hawser {

struct GeneratorDef {
    std::string name{};  ///< Unique in the vessel. Required.
    double power = 0.0;  ///< Rated [W]. Required.
};

struct SwitchboardDef {
    std::string name{};                      ///< Unique in the vessel. Required.
    std::vector<GeneratorDef> generators{};  ///< Required.
};

struct ConsumerDef {
    /// Name of a propulsor of the vessel; otherwise name of a load, unique in the vessel. Required.
    std::string name{};
    std::string board{};  ///< Required.
    int priority = 1;     ///< 1 is served first.
    double power =
        0.0;  ///< Power of an ideal propulsor at full order, or of a load at the start [W].
    double efficiency = 0.9;  ///< η, from the board to the shaft [1].
    std::string signal{};     ///< "SYSTEM.SIGNAL" in W of another system; "": none.
};

struct PowerDef {
    std::vector<SwitchboardDef> boards{};  ///< Empty: no bus.
    std::vector<ConsumerDef> consumers{};
    double share = 0.9;  ///< Fraction of the capacity for consumers (DNV-ST-0111) [1].
    bool tied = false;   ///< The tie is closed at the start.
};

}  // namespace hawser
