// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file power.h
/// Grant power to the consumers of a bus (hawser/vessel_power.h).

#include <hawser/system.h>
#include <hawser/vessel.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace hawser::vessel {

/// Index of a signal of another system, found again if the list of signals changes.
class SignalRef {
  public:
    /// Create a reference to a signal.
    /// @param name  Name as "SYSTEM.SIGNAL".
    explicit SignalRef(const std::string& name);
    /// Return the value of the signal; 0 if the world has no such signal.
    [[nodiscard]] double value(const World& world) noexcept;

  private:
    std::string system_, name_;
    std::size_t index_ = 0;
};

/// Distribute power to consumers by priority.
class PowerBus {
  public:
    explicit PowerBus(const VesselDef& def);
    [[nodiscard]] bool any() const noexcept { return !boards_.empty(); }
    /// Return the rated power of an ideal propulsor on the bus; 0 if it is not on the bus [W].
    [[nodiscard]] double rated_power(std::size_t propulsor) const noexcept;
    /// Set the power that a propulsor requests at its shaft [W].
    void demand(std::size_t propulsor, double power) noexcept;
    /// Grant power to all consumers. Send events for consumers from which power begins to be
    /// withheld, and for failures.
    void grant_power(Prestep& now, BodyId body) noexcept;
    /// Return the power that a propulsor may take at its shaft, 1e300 without a bus [W].
    [[nodiscard]] double granted_power(std::size_t propulsor) const noexcept;
    /// Return the fraction of its full power that is available to a propulsor, 0 … 1; 1 without a
    /// bus.
    ///
    /// It depends on the present loads and demands of smaller `priority` numbers. Propulsors of the
    /// same priority count with their full power, so that the fraction does not depend on the
    /// orders that follow from it.
    /// @param full  Power of each propulsor at full order, at its shaft [W].
    [[nodiscard]] double available_fraction(std::size_t propulsor,
                                            const std::vector<double>& full) const noexcept;

    void visit_state(StateVisitor& visitor);
    void check_state(StateRules& rules) const;
    void signals(SignalTable& table);

  private:
    struct Part {
        std::string name;
        double failed = 0.0;  ///< Input.
        double power = 0.0;
        std::int32_t reported = 0;
    };
    struct Board {
        Part part;
        std::vector<Part> generators;
        double load = 0.0, spare = 0.0;  ///< Outputs [W].
    };
    struct Consumer {
        std::string name;
        int propulsor = -1;
        std::size_t board = 0;
        int priority = 1;
        double efficiency = 1.0, rated = 0.0;
        int signal = -1;
        double load = 0.0;                   ///< Input signal of a load [W].
        double demand = 0.0, granted = 0.0;  ///< At the board [W].
        double shed = 0.0;                   ///< Output [W].
        std::int32_t shedding = 0;
    };
    [[nodiscard]] bool is_load(const Consumer& c) const noexcept {
        return c.propulsor < 0 && c.signal < 0;
    }
    [[nodiscard]] static bool failed(const Part& part) noexcept { return part.failed >= 0.5; }
    [[nodiscard]] static double capacity(const Board& board) noexcept;
    /// Return true if two consumers use the capacity of one board, or of tied boards.
    [[nodiscard]] bool have_common_board(const Consumer& a, const Consumer& b) const noexcept;
    [[nodiscard]] const Consumer* find(std::size_t propulsor) const noexcept;
    /// Distribute a capacity among the consumers of one board, or of all boards that have not
    /// failed.
    void distribute(double capacity, int board) noexcept;
    void report_failures(Prestep& now, BodyId body) noexcept;

    double available_fraction_;
    double tie_;  ///< Input.
    std::vector<Board> boards_;
    std::vector<Consumer> consumers_;
    std::vector<std::size_t> order_;  ///< Consumers by priority.
    std::vector<int> of_propulsor_;   ///< Consumer of each propulsor, −1: none.
    std::vector<SignalRef> signal_refs_;
};

/// Check the bus of a definition. @throws DefError.
void check_power(const VesselDef& def);

}  // namespace hawser::vessel
