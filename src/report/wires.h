// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// What a report tells of each wire of a world: tension along it, nodes, material, and where it
/// parted. Nodes may come and go meanwhile (hawser/wire.h).

#include <hawser/hawser.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::report {

/// A wire that has parted.
struct PartedWire {
    double time = 0.0;  ///< [s]
    std::string wire;   ///< Empty: the element is of no wire.
    std::string element;
    double s = 0.0;        ///< Material coordinate of the middle of the element [m].
    double length = 0.0;   ///< Of the wire then, unstretched [m].
    double tension = 0.0;  ///< With which it parted [N].
};

/// Tension in a stretch of a wire, over the steps in which something of the wire was there [N].
struct TensionAlong {
    double least = 0.0, mean = 0.0, greatest = 0.0;
};

/// A count or a length over the run.
struct Course {
    double start = 0.0, now = 0.0, least = 0.0, most = 0.0;
};

/// How fine a wire was at a time.
struct Resolved {
    double time = 0.0;                     ///< [s]
    double nodes = 0.0;                    ///< As WireFigures has them.
    double shortest = 0.0, longest = 0.0;  ///< Element, unstretched [m].
};

struct WireFigures {
    std::string name;
    double since = 0.0;        ///< When it was first there [s].
    bool came = false;         ///< It is a piece of a wire that was cut in the run.
    Course nodes;              ///< That there are, the bodies that hold it included.
    Course length;             ///< Unstretched [m].
    Course shortest, longest;  ///< Element, unstretched [m].
    Course mass;               ///< Of the material of its elements, those at drums left out [kg].
    std::vector<Resolved> times;       ///< At even times, up to kMostTimes of them.
    std::vector<TensionAlong> along;   ///< In equal shares of its length, from the first end on.
    TensionAlong tension{};            ///< In the whole of it.
    double breaking_load = 0.0;        ///< Of its weakest element [N]; 0: none parts.
    std::vector<PartedWire> parted{};  ///< The first ones, in order.
};

/// Watches the wires that a world starts with and the pieces that they are cut into: tensions in
/// each step, which costs O(elements), lengths and which share of the wire an element is in every
/// 32 steps and where nodes came or went.
class WireWatch {
  public:
    static constexpr int kLookEvery = 32;          ///< Steps.
    static constexpr std::size_t kMostTimes = 64;  ///< Half of them go where there are more.
    explicit WireWatch(const World& world);
    /// Call after each step with the events of that step.
    void after_step(const World& world, std::span<const Event> events);
    [[nodiscard]] std::vector<WireFigures> result(const World& world) const;
    /// In the order in which they parted, the first ones.
    [[nodiscard]] const std::vector<PartedWire>& parted() const noexcept { return parted_; }

  private:
    struct Watched {
        WireId id;
        WireFigures figures;
        std::vector<InteractionId> elements{};  ///< As looked at last …
        std::vector<std::int32_t> share{};      ///< Share each element lies in; −1: it is gone.
        std::vector<double> sum{};              ///< Sum of the tensions of a share [N].
        std::vector<std::size_t> counted{};     ///< Number of tensions in that sum.
    };
    static void look(const World& world, Watched& w, bool first);
    void add(const World& world, WireId id, bool came);
    void add_pieces(const World& world);
    void note_times(const World& world);

    std::vector<Watched> wires_;
    std::vector<WireId> known_;  ///< The wires of the world when it was last asked.
    std::vector<PartedWire> parted_;
    int steps_ = 0;
    int noted_every_ = kLookEvery;  ///< Steps.
};

/// The lines of a report about them.
[[nodiscard]] std::string wires_in_words(const std::vector<WireFigures>& wires,
                                         const std::vector<PartedWire>& parted);

}  // namespace hawser::report
