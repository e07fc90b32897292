// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file start_forces.h
/// Estimate the forces at the start of a scene. Rows keep their violation, elements pull by their
/// stretch, and all other bodies fall freely. Contacts, damping of rows, and the change of the
/// Jacobian with the motion are neglected. Only the magnitude of a force is therefore reliable, not
/// three digits.

#include <hawser/hawser.h>

#include <array>
#include <vector>

namespace hawser::report::start {

class StartForces {
  public:
    /// Compute the forces at the present poses. @throws std::bad_alloc.
    explicit StartForces(const World& world);
    [[nodiscard]] bool known() const { return is_known_; }
    /// Return the norm of the force in the rows of an interaction that are in metres [N].
    [[nodiscard]] double push(InteractionId id) const;

  private:
    bool is_known_ = false;
    std::vector<double> push_;
};

}  // namespace hawser::report::start
