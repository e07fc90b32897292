// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame_plan.h
/// What a frame of a world holds and in which order; made anew when pieces of the world come or go.
///
/// Nodes of wires are not bodies of a frame: a wire is a row of points there, whatever it is made
/// of at the time, so that winches and cuts, which make and take nodes while they work, change
/// nothing of what a client knows of the scene.
/// ```
///     wire ──o────o────o──.    guide      points of a frame: both ends of each element, the end of
///      element 0    1     ( )             one and the start of the next once where they agree,
///                          │ element 2    twice where a wheel lies between them
/// ```

#include <hawser/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::live {

/// An end of a piece that is held by a body where it always is.
struct HeldPoint {
    std::int32_t body = -1;     ///< Place.
    bool turns = false;         ///< Else the point is the body's centre.
    Vec3 point{0.0, 0.0, 0.0};  ///< In the body's frame [m].
};

struct PieceSource {
    InteractionId element{};
    HeldPoint end[2]{};
    bool routed = false;     ///< Its ends are those of World::ends().
    bool backwards = false;  ///< It runs from its second body to its first one.
    bool joint = false;      ///< Of a chain of rigid links: the force of the joint is its tension.
};

enum class WireKind : std::uint8_t { wire, links, line, rod };
[[nodiscard]] const char* to_string(WireKind kind) noexcept;

struct WireSource {
    WireKind kind = WireKind::wire;
    WireId wire{};  ///< Of kind wire.
    std::string name{};
    std::int32_t cable = -1;  ///< Of the scene, by its name; −1: none.
    std::vector<PieceSource> pieces{};
};

struct JointSource {
    InteractionId id{};
    std::int32_t body[2] = {-1, -1};
    Vec3 point{0.0, 0.0, 0.0};  ///< In the frame of the second body [m].
};

/// An input as clients know it.
struct InputSource {
    std::string name{}, unit{}, group{}, kind{};
    double min = -1e30, max = 1e30, nominal = 0.0, factor = 1.0;
    std::optional<double> spring{};
    std::vector<std::string> words{};  ///< Of the values 0, 1, …; empty: it is no choice.
    InputId id{};                      ///< Of the world, or …
    const double* signal = nullptr;    ///< … a system's number; the value is that over `factor`.
};

struct FramePlan {
    std::vector<BodyId> rigid, lumps, scalars, fixed;  ///< Without nodes of wires.
    std::vector<WireSource> wires;
    std::vector<JointSource> joints;
    std::vector<InputSource> inputs;
    std::vector<OutputId> outputs;
    std::vector<ShapeId> shapes;  ///< Without segments of wires.

    /// What it was made from, to see whether that has changed.
    std::vector<BodyId> all_bodies;
    std::vector<InteractionId> all_interactions;
    std::vector<ShapeId> all_shapes;
    std::vector<WireId> all_wires;
    std::vector<InputId> all_inputs;
    std::vector<OutputId> all_outputs;
    std::size_t all_signals = 0;

    [[nodiscard]] static FramePlan of(const scene::Scene& scene);
    /// Whether pieces of the world are still those that it was made of.
    [[nodiscard]] bool current(const World& world) const;
    /// Whether what clients know of the scene is the same: all but nodes of wires.
    [[nodiscard]] bool same_scene(const FramePlan& other) const;
};

}  // namespace hawser::live
