// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file drum_feed_system.h
/// System of a bare drum that feeds a wire (hawser/drum_feed.h).
///
/// The element at the drum contains the material a [m]:
/// ```
///     a₊ = a + r Δθ      insert_feed_node(): a − f,   feed_in_node(): a + f      (feed.h)
/// ```
/// The rest length of the element is at its bound if l₀ + r (θ − θ₀) ≤ ε l₀ (kinds/lines.h). The
/// event `hauled_in` is reported in the first step that begins there. The velocity of the drum
/// gives the previous position, so the event needs no state.

#include <hawser/drum_feed.h>
#include <hawser/system.h>

#include <memory>
#include <string_view>

namespace hawser::wire {

class DrumFeedSystem final : public System {
  public:
    /// Create the system.
    /// @param line  Element at the drum.
    /// @param material  Its unstretched length [m].
    DrumFeedSystem(DrumFeedDef def, InteractionId line, double material, double angle);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void before_step(NodeEdits& nodes) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    void holds(HoldTable& table) const override;
    [[nodiscard]] double carried_mass(InteractionId element) const noexcept override {
        return element == line_ && makes_nodes() ? def_.mass_per_length * at_drum_ : 0.0;
    }
    [[nodiscard]] double paid_out(const World& world,
                                  InteractionId element) const noexcept override;
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<DrumFeedSystem>(def_, line_, at_drum_, angle_);
    }

  private:
    [[nodiscard]] bool makes_nodes() const noexcept { return def_.element > 0.0; }
    [[nodiscard]] std::size_t node_slot(const World& world) const noexcept;
    [[nodiscard]] double min_hauled_length(const World& world, double length) const noexcept;
    void stop_at_fairlead(Prestep& now, Loads& loads, const InteractionDef& line) noexcept;

    DrumFeedDef def_;
    InteractionId line_;
    double start_;  ///< Coordinate of the drum when the feed was added.
    // State.
    double at_drum_;  ///< Material of the element at the drum [m].
    double angle_;    ///< Coordinate of the drum at the start of the last step.
    // Output.
    double paid_ = 0.0;  ///< Line paid out [m].
};

}  // namespace hawser::wire
