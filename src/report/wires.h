// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file wires.h
/// Collect the figures of each wire for a report: tension along it, nodes, material, breaks. Nodes
/// may be added and removed during the run (hawser/wire.h).

#include <hawser/hawser.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace hawser::report {

/// A break of a wire.
struct BrokenWire {
    double time = 0.0;  ///< Time [s].
    std::string wire;   ///< Name of the wire; empty: the element belongs to no wire.
    std::string element;
    double s = 0.0;        ///< Material coordinate of the middle of the element [m].
    double length = 0.0;   ///< Length of the wire at that time, unstretched [m].
    double tension = 0.0;  ///< Tension at the break [N].
};

/// Tension in a part of a wire, over the steps in which the part existed [N].
struct TensionAlong {
    double least = 0.0, mean = 0.0, greatest = 0.0;
};

/// A count or a length over the run.
struct Course {
    double start = 0.0, now = 0.0, least = 0.0, most = 0.0;
};

/// Resolution of a wire at a time.
struct Resolved {
    double time = 0.0;                     ///< Time [s].
    double nodes = 0.0;                    ///< Number of nodes, as in WireFigures.
    double shortest = 0.0, longest = 0.0;  ///< Element, unstretched [m].
};

struct WireFigures {
    std::string name;
    double since = 0.0;           ///< Time of its creation [s].
    bool is_cut_piece = false;    ///< True if it is a piece of a wire that was cut in the run.
    Course nodes;                 ///< Number of nodes, including the bodies at the ends.
    Course length;                ///< Unstretched [m].
    Course shortest, longest;     ///< Element, unstretched [m].
    Course mass;                  ///< Mass of the elements' material, without those at drums [kg].
    std::vector<Resolved> times;  ///< Resolution at equidistant times, at most kMaxTimes.
    std::vector<TensionAlong>
        along;                   ///< Tensions in equal parts of its length, from the first end on.
    TensionAlong tension{};      ///< Tension over its whole length.
    double breaking_load = 0.0;  ///< Breaking load of its weakest element [N]; 0: unbreakable.
    std::vector<BrokenWire> broken_wires{};  ///< First breaks in the order of time.
};

/// Observes the wires at the start of a world and the pieces that are cut from them. Tensions are
/// sampled in each step, at a cost of O(elements). Lengths and the part of the wire of each element
/// are sampled every 32 steps and after changes of nodes.
class WireWatch {
  public:
    static constexpr int kSampleEvery = 32;  ///< Steps.
    static constexpr std::size_t kMaxTimes =
        64;  ///< Capacity of the times; if it is exceeded, every other time is removed.
    explicit WireWatch(const World& world);
    /// Call after each step with the events of that step.
    void after_step(const World& world, std::span<const Event> events);
    [[nodiscard]] std::vector<WireFigures> result(const World& world) const;
    /// Return the first breaks in the order of time.
    [[nodiscard]] const std::vector<BrokenWire>& broken_wires() const noexcept { return broken_; }

  private:
    struct Watched {
        WireId id;
        WireFigures figures;
        std::vector<InteractionId> elements{};  ///< Elements at the last sample …
        std::vector<std::int32_t>
            fraction{};             ///< … and the part of the wire of each; −1: it was removed.
        std::vector<double> sum{};  ///< Sum of the tensions of a part [N].
        std::vector<std::size_t> counted{};  ///< Number of tensions in that sum.
    };
    static void sample(const World& world, Watched& w, bool first);
    void add(const World& world, WireId id, bool is_cut_piece);
    void add_pieces(const World& world);
    void record_edit_times(const World& world);

    std::vector<Watched> wires_;
    std::vector<WireId> known_;  ///< Wires of the world at the last call of add_pieces().
    std::vector<BrokenWire> broken_;
    int steps_ = 0;
    int noted_every_ = kSampleEvery;  ///< Steps.
};

/// Return the lines of a report about the wires.
[[nodiscard]] std::string wire_lines(const std::vector<WireFigures>& wires,
                                     const std::vector<BrokenWire>& broken_wires);

}  // namespace hawser::report
