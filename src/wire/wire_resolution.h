// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_resolution.h
/// System of a resolution (hawser/resolution.h).
///
/// All decisions depend on the world: poses, forces of the last step, masses of elements, and
/// contacts of segments. The own state is the averaged tension and, for each node, the number of
/// consecutive samples in which it was not needed. So a restored snapshot continues bit for bit. A
/// failed step is retried with the nodes as they are. A second sample in the same step does
/// nothing, so the result is the same.

#include <hawser/resolution.h>
#include <hawser/system.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace hawser::wire {

class WireResolution final : public System {
  public:
    /// One line type of a wire, identified by its EA.
    struct Line {
        double EA = 0.0;               ///< [N]
        double mass_per_length = 0.0;  ///< [kg/m]
    };

    /// Create the system.
    /// @param def  With all values set.
    /// @param lines  Line types of the wire, at least one.
    /// @param room  Number of remembered nodes.
    /// @param phase  Phase of samples.
    /// @param nodes  Number of existing nodes.
    /// @param bodies  Number of bodies of the world. Memory for them is reserved, so that the first
    ///        sample allocates nothing.
    WireResolution(const ResolutionDef& def, std::vector<Line> lines, std::size_t room,
                   std::int64_t phase, double nodes, std::size_t bodies);

    [[nodiscard]] std::string_view name() const noexcept override { return def_.name; }
    [[nodiscard]] WireId wire() const noexcept { return def_.wire; }
    void before_step(NodeEdits& nodes) noexcept override;
    void prestep(Prestep& now, Loads& loads) noexcept override;
    void visit_state(StateVisitor& visitor) override;
    void check_state(const World& world, StateRules& rules) const override;
    void signals(SignalTable& table) override;
    [[nodiscard]] bool coarsens() const noexcept override { return nodes_ > 3.0; }
    [[nodiscard]] std::unique_ptr<System> clone() const override {
        return std::make_unique<WireResolution>(def_, lines_, max_nodes_, phase_, nodes_, bodies_);
    }

  private:
    /// Sampled data of an element.
    struct Element {
        InteractionId id{};
        double length = 0.0;           ///< Length of its material [m].
        double mass_per_length = 0.0;  ///< Mass of its line type [kg/m]; 0: unknown.
        double bound = 0.0;            ///< L [m].
        /// Bound for removing a node. It also covers contacts one element further out, since nodes
        /// near the end of a contact region alternate.
        double removal_bound = 0.0;
        double tension = 0.0;  ///< [N]
        Vec3 chord{0, 0, 0};   ///< [m]
        bool whole = false;    ///< True if it exists and is intact.
        bool plain = false;  ///< True if it is whole and may gain nodes or lose those at its ends.
        bool wound = false;  ///< True if a drum pays it out.
    };
    /// Node between element i − 1 and element i.
    struct Node {
        BodyId id{};
        double angle = 0.0, curvature = 0.0;  ///< [rad, 1/m]
        std::int32_t idle = 0;                ///< Samples in which it was not needed.
    };

    [[nodiscard]] double matching_mass_per_length(const InteractionDef& element) const noexcept;
    void sample(const World& world);
    void compute_bending(const World& world) noexcept;
    void average_tension(const World& world) noexcept;
    void bound_elements(const World& world);
    void restore_idle_counts() noexcept;
    void save_idle_counts() noexcept;
    void count_idle_samples() noexcept;
    bool refine(NodeEdits& nodes) noexcept;
    bool coarsen(NodeEdits& nodes) noexcept;
    void report_changes(const World& world) noexcept;
    [[nodiscard]] bool may_remove(std::size_t node) const noexcept;

    ResolutionDef def_;
    std::vector<Line> lines_;
    std::size_t max_nodes_, bodies_;
    std::int64_t phase_;

    // State.
    std::vector<std::int32_t> memory_;  ///< Index, generation and idle samples of known nodes.
    std::int32_t known_nodes_ = 0;
    std::int64_t sampled_ = -1;       ///< Step of the last sample.
    double tension_ = -1.0;           ///< Averaged [N]; negative: unknown.
    std::int32_t limited_node_ = -1;  ///< Index of a node where more nodes are needed than allowed.
    std::int32_t reported_ = 0;
    double nodes_ = 0.0, shortest_ = 0.0, longest_ = 0.0, material_ = 0.0;
    double inserted_ = 0.0, removed_ = 0.0;

    // Data of the current sample.
    std::vector<Element> elements_;
    std::vector<Node> at_;  ///< One more than elements.
    std::vector<std::uint8_t> touching_;
    double scale_ = 1.0;                 ///< Factor of lengths by the coarsening level.
    std::int32_t patience_samples_ = 0;  ///< Patience in samples.
};

}  // namespace hawser::wire
