// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file levers.h
/// Store the requested values of inputs, and apply the faults that modify them.

#include <hawser/exercise.h>

#include "exercise/names.h"

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace hawser::exercise {

/// Controls of an exercise. A copy is a state that can be restored.
class Controls {
  public:
    /// Request a value of an input. @param input  Name from resolved().
    void ask(const Session& session, const std::string& input, double value);
    /// Return the value last requested for an input, in its unit; NaN: no request yet.
    [[nodiscard]] double requested(const std::string& input) const noexcept;

    void begin(const Session& session, const Fault& fault);
    void end(const Fault& fault);

    /// Set the inputs that have changed, from the requests and the active faults.
    void apply(Session& session);
    /// Forget the applied values. Call after a state was restored, which sets inputs itself.
    void forget_applied();

  private:
    struct Control {
        double requested = kDefault;  ///< Requested value; NaN: none, `start` applies.
        double start = 0.0;           ///< Value before the first request.
        double applied = kDefault;    ///< Value last set; NaN: unknown.
        double passed = kDefault;     ///< Last delayed value that has become due.
        std::deque<std::pair<double, double>> delayed;  ///< Delayed values: due time [s], value.
        std::vector<const Fault*> faults;      ///< Active faults in the order of their start.
        bool mode = false;                     ///< True for the mode of a winch.
        std::map<const Fault*, double> stuck;  ///< Value at which each fault holds the input.
    };
    Control& control(const Session& session, const std::string& input);
    static double let_through(Control& control, double now);

    std::map<std::string, Control, std::less<>> controls_;
};

}  // namespace hawser::exercise
