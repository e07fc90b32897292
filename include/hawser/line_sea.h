// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file line_sea.h
/// Loads of a sea on nodes of wires, computed again in replays.
///
/// These loads are functions of poses, velocities, time and the inputs of the sea; they have no
/// memory. A recording therefore stores the definition of this part of the sea (LineSea) instead of
/// its loads, and a replay computes the loads from it (docs/recording.md):
/// ```cpp
/// std::shared_ptr<const hawser::LineSea> part = hawser::line_sea(world);   // in the run
/// hawser::LineLoads again(*part);                                          // in a replay
/// // in the prestep of a system of the replay:
/// if (again.compute(now, inputs)) again.add(loads, bodies_with_recorded_loads);
/// ```
/// The loads equal those of the run to the bit if the world has equal state and equal wires.

#include <hawser/id.h>
#include <hawser/sea.h>
#include <hawser/system.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace hawser {

/// Definition of the part of a sea that acts on nodes of wires.
struct LineSea {
    /// Element of a wire at the definition of the sea.
    struct Element {
        InteractionId id{};     ///< Interaction of the element.
        std::int32_t sort = 0;  ///< Index of its coefficients in `sorts`.
    };
    SeaDef sea{};                     ///< Level, waves and current; without wind, lines and bodies.
    double gravity = 9.81;            ///< Gravity [m/s²].
    std::vector<LineWater> sorts{};   ///< Different sets of water coefficients.
    std::vector<Element> elements{};  ///< Elements in the water, by ascending index.
    std::vector<BodyId> holders{};    ///< Bodies that hold ends of lines, ascending.
};

/// Largest index of an element in a LineSea.
inline constexpr std::int32_t kMaxLineElement = 10'000'000;

/// Return the part of a world's sea that acts on nodes of wires. The pointer is the same as long as
/// the world has the same sea. Null: no sea, or no line in it.
[[nodiscard]] std::shared_ptr<const LineSea> line_sea(const World& world) noexcept;
/// Return the inputs of a world's sea in its last step.
[[nodiscard]] SeaInputs acting_inputs(const World& world) noexcept;

/// Computes the loads of a LineSea.
class LineLoads {
  public:
    /// Copy the definition.
    /// @throws SeaError if it is invalid
    explicit LineLoads(const LineSea& of);
    ~LineLoads();
    LineLoads(const LineLoads&) = delete;
    LineLoads& operator=(const LineLoads&) = delete;

    /// Compute the loads in the state before a step.
    /// @param inputs  Inputs of the sea; those of the wind have no effect.
    /// @return true if allocation succeeded.
    [[nodiscard]] bool compute(Prestep& now, const SeaInputs& inputs) noexcept;
    /// Add the computed loads to a step, except those of some bodies.
    /// @param except  Bodies without these loads, ascending.
    void add(Loads& loads, std::span<const BodyId> except) const noexcept;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace hawser
