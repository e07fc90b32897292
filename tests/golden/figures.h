// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file figures.h
/// Figures of a run that change with any change of its physics.
///
/// A projection is the sum of all numbers of a kind, each times a pseudo-random weight:
/// ```
///     p = sum_i w_i x_i,    0.5 <= |w_i| <= 1.5,    scale = sum_i |w_i x_i| + floor
/// ```
/// A change of any x_i changes p. The scale is the size that rounding errors are compared with.

#include <hawser/scene.h>
#include <hawser/session.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace hawser::golden {

/// Real number with its scale.
struct Real {
    double value = 0.0;
    double scale = 0.0;
    double tolerance = 0.0;  ///< Tolerance of a reference, relative to the scale; 0: the tolerance
                             ///< of its scene.
};

/// Figures of one scene, by name.
struct Figures {
    std::map<std::string, std::string> texts;
    std::map<std::string, std::int64_t> counts;
    std::map<std::string, Real> reals;
};

/// Return weight number `index` of a sequence: between 0.5 and 1.5 in size, with either sign.
[[nodiscard]] double weight(std::uint64_t sequence, std::uint64_t index);

/// Sum of weighted terms.
class Projection {
  public:
    /// Start a sum. @param floor  Smallest scale, in the unit of the terms: changes of terms far
    /// below it have no effect.
    Projection(std::uint64_t sequence, double floor) : sequence_(sequence), floor_(floor) {}
    /// Add the next term. A term that is not finite counts as 0.
    void add(double term);
    void add(const Vec3& terms);
    [[nodiscard]] Real result() const { return {sum_, size_ + floor_, 0.0}; }

  private:
    std::uint64_t sequence_, count_ = 0;
    double floor_, sum_ = 0.0, size_ = 0.0;
};

/// Sums over all steps of a run.
class StepSums {
  public:
    /// Add the state and the figures of the step taken last.
    void add(const World& world);
    void write(Figures& out) const;

  private:
    Projection motion_{101, 1e-3}, force_{102, 1e-3}, contact_{103, 1e-3}, energy_{104, 1e-3};
    std::map<std::string, std::int64_t> counts_;
    std::vector<ContactView> contacts_;
};

/// Write the figures of the state of a world.
/// @param start  Poses at the start by index of the body; a body added later starts at the origin.
void write_state(const World& world, const std::vector<Pose>& start, Figures& out);

}  // namespace hawser::golden
