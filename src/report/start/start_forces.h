// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file start_forces.h
/// About the forces with which a scene starts: those that hold still what rows hold, let elements
/// pull as they are stretched, and let all else fall. Contacts, damping and centrifugal forces are
/// left out; so it tells the size of a force, not its third digit.

#include <hawser/hawser.h>

#include <array>
#include <vector>

namespace hawser::report::start {

class StartForces {
  public:
    /// At the present poses. @throws std::bad_alloc.
    explicit StartForces(const World& world);
    [[nodiscard]] bool known() const { return known_; }
    /// Norm of the force in the rows of an interaction that are in metres [N].
    [[nodiscard]] double push(InteractionId id) const;

  private:
    bool known_ = false;
    std::vector<double> push_;
};

}  // namespace hawser::report::start
