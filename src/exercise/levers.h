// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file levers.h
/// What was asked of inputs, and what faults let through.

#include <hawser/exercise.h>

#include "exercise/names.h"

#include <deque>
#include <map>
#include <string>
#include <vector>

namespace hawser::exercise {

/// Copies are states to go back to.
class Levers {
  public:
    /// @param input  As resolved() gave it.
    void ask(const Session& session, const std::string& input, double value);
    /// The value last asked of an input, in its unit; NaN: nobody has asked.
    [[nodiscard]] double asked(const std::string& input) const noexcept;

    void begin(const Session& session, const Fault& fault);
    void end(const Fault& fault);

    /// Set what has changed, by what was asked for and the faults that there are.
    void apply(Session& session);
    /// After a state was restored: inputs are what that state has.
    void forget_applied();

  private:
    struct Lever {
        double asked = kDefault;                     ///< NaN: as it was at first, `start`.
        double start = 0.0;                          ///< Before anyone asked.
        double applied = kDefault;                   ///< NaN: not known.
        double passed = kDefault;                    ///< Last that came through being late.
        std::deque<std::pair<double, double>> late;  ///< Time at which it is due, value.
        std::vector<const Fault*> faults;            ///< In the order in which they began.
        bool mode = false;                           ///< Of a winch.
        std::map<const Fault*, double> stuck;        ///< Where each keeps it.
    };
    Lever& lever(const Session& session, const std::string& input);
    static double let_through(Lever& lever, double now);

    std::map<std::string, Lever, std::less<>> levers_;
};

}  // namespace hawser::exercise
