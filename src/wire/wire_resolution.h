// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wire_resolution.h
/// What a resolution does before a step begins (hawser/resolution.h).
///
/// All that decides is read from the world: poses, forces of the last step, masses of elements, and
/// which segments touch. Own state is the averaged tension and, for each node, for how many looks
/// running it has not been needed: what a snapshot holds goes on bit for bit. A step that fails is
/// begun again with the nodes as they are; a second look in the same step does nothing, so that
/// what follows is the same.

#include <hawser/resolution.h>
#include <hawser/system.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace hawser::wire {

class WireResolution final : public System {
  public:
    /// One line type of a wire: elements of it have its EA.
    struct Line {
        double EA = 0.0;               ///< [N]
        double mass_per_length = 0.0;  ///< [kg/m]
    };

    /// @param def  All of it given. @param lines  What the wire is made of: at least one. @param
    /// room  Nodes that are remembered. @param phase  Of looks. @param nodes  That there are.
    /// @param bodies  Of the world: memory for them is reserved, so that the first look allocates
    /// nothing.
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
        return std::make_unique<WireResolution>(def_, lines_, room_, phase_, nodes_, bodies_);
    }

  private:
    /// Of an element as it is now.
    struct Element {
        InteractionId id{};
        double length = 0.0;           ///< Of its material [m].
        double mass_per_length = 0.0;  ///< Of its line type [kg/m]; 0: of none that is known.
        double bound = 0.0;            ///< L [m].
        /// The same for a node to go: where it touches something one element further out, since
        /// what is near comes and goes at the end of where it touches.
        double bound_to_go = 0.0;
        double tension = 0.0;  ///< [N]
        Vec3 chord{0, 0, 0};   ///< [m]
        bool whole = false;    ///< It is there and has not parted.
        bool plain = false;    ///< And it may get nodes, and lose those at its ends.
        bool wound = false;    ///< A drum pays it out.
    };
    /// Between the element of the same number and the one before.
    struct Node {
        BodyId id{};
        double angle = 0.0, curvature = 0.0;  ///< [rad, 1/m]
        std::int32_t idle = 0;                ///< Looks in which it was not needed.
    };

    [[nodiscard]] double mass_per_length_of(const InteractionDef& element) const noexcept;
    void look(const World& world);
    void bend(const World& world) noexcept;
    void average_tension(const World& world) noexcept;
    void bound_elements(const World& world);
    void recall() noexcept;
    void remember() noexcept;
    void count_idle() noexcept;
    bool refine(NodeEdits& nodes) noexcept;
    bool coarsen(NodeEdits& nodes) noexcept;
    void tell(const World& world) noexcept;
    [[nodiscard]] bool may_go(std::size_t node) const noexcept;

    ResolutionDef def_;
    std::vector<Line> lines_;
    std::size_t room_, bodies_;
    std::int64_t phase_;

    // State.
    std::vector<std::int32_t> memory_;  ///< Place, generation and idle looks of nodes known.
    std::int32_t known_ = 0;
    std::int64_t looked_ = -1;  ///< Step before which it looked last.
    double tension_ = -1.0;     ///< Averaged [N]; below 0: not known.
    std::int32_t wanted_ = -1;  ///< Place of a node at which more are wanted than there may be.
    std::int32_t told_ = 0;
    double nodes_ = 0.0, shortest_ = 0.0, longest_ = 0.0, material_ = 0.0;
    double inserted_ = 0.0, removed_ = 0.0;

    // Of the look under way.
    std::vector<Element> elements_;
    std::vector<Node> at_;  ///< One more than elements.
    std::vector<std::uint8_t> touching_;
    double scale_ = 1.0;         ///< Of lengths, by the level of coarsening.
    std::int32_t patience_ = 0;  ///< In looks.
};

}  // namespace hawser::wire
