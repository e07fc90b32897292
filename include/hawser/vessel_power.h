// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file vessel_power.h
/// Power bus of a vessel (vessel.h): switchboards, generators, consumers with priorities.
///
/// In each step the bus determines the demand of each consumer and grants power by priority. A
/// grant limits a propulsor as a limit of its motor does.
/// ```
///     generators --+-- board A --+-- tie --+-- board B --+-- generators
///                  |             |         |             |
///             consumers      hotel load            consumers
/// ```
/// *Capacity.* The capacity of a board is the sum of its generators that have not failed, or 0 if
/// the board has failed. A closed tie joins all boards that have not failed into one. The fraction
/// `share` of the capacity is available to consumers; the rest is reserve.
///
/// *Grants.* In the order of `priority` (1 first), each consumer gets its demand P/η while capacity
/// is left. If it does not suffice for all consumers of a priority, they get it in proportion to
/// their demands. The body sends the event `shed` each time when power begins to be withheld.
///
/// *Demand* of the kinds of consumers:
/// - propeller with a shaft: power of its motor within its own limits;
/// - other propellers: power at the ordered revolutions;
/// - ideal propulsor: `power` times |order|³; a grant limits the order to the cube root of its
/// fraction;
/// - load that is no propulsor: the input NAME [W];
/// - signal of another system [W], such as a winch: the bus supplies it without a limit.
///
/// Power that a propeller returns does not feed the bus.
///
/// Inputs: `tie`, 1 closed, 0 open, if there are two boards or more; GENERATOR_failed,
/// BOARD_failed, 0 or 1; NAME of a load [W]. Outputs: BOARD_load, BOARD_spare, load and unused
/// capacity [W], with a closed tie those of all joined boards; NAME_shed, withheld power [W].
///
/// Limits: generators are in steady state, without frequency, start-up time and blackout.

#include <string>
#include <vector>

namespace hawser {

/// Generator of a switchboard.
struct GeneratorDef {
    std::string name{};  ///< Unique name in the vessel. Required.
    double power = 0.0;  ///< Rated power [W]. Required.
};

/// Switchboard with its generators.
struct SwitchboardDef {
    std::string name{};                      ///< Unique name in the vessel. Required.
    std::vector<GeneratorDef> generators{};  ///< Generators. Required.
};

/// Consumer of power: a propulsor, another load, or a signal of another system.
struct ConsumerDef {
    /// Name of a propulsor of the vessel; otherwise name of a load, unique in the vessel. Required.
    std::string name{};
    std::string board{};  ///< Name of the switchboard that supplies it. Required.
    int priority = 1;     ///< Priority; 1 is supplied first.
    /// Power of an ideal propulsor at full order, or of a load at the start [W].
    double power = 0.0;
    double efficiency = 0.9;  ///< Efficiency η from the board to the shaft [1].
    std::string signal{};     ///< Signal "SYSTEM.SIGNAL" of another system [W]; "": none.
};

/// Definition of the power bus of a vessel, VesselDef::power.
struct PowerDef {
    std::vector<SwitchboardDef> boards{};  ///< Switchboards; empty: no power bus.
    std::vector<ConsumerDef> consumers{};  ///< Consumers.
    double share = 0.9;  ///< Fraction of the capacity for consumers (DNV-ST-0111) [1].
    bool tied = false;   ///< True: the tie is closed at the start.
};

}  // namespace hawser
