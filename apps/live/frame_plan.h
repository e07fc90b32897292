// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file frame_plan.h
/// Contents of a frame of a world and their order, rebuilt after objects were added or removed.
///
/// Nodes of wires are not bodies of a frame. A wire is a row of points there, independent of its
/// present nodes. Winches and cuts, which add and remove nodes, therefore change nothing in a
/// client's description of the scene.
/// ```
///     wire ──o────o────o──.    guide      points of a frame: both ends of each element, the end of
///      element 0    1     ( )             one and the start of the next once if they agree,
///                          │ element 2    twice if a wheel lies between them
/// ```

#include <hawser/scene.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hawser::live {

/// An end of a piece at a fixed point of a body.
struct HeldPoint {
    std::int32_t body = -1;  ///< Index of the body.
    bool turns = false;  ///< True: the point turns with the body. False: it is the body's centre.
    Vec3 point{0.0, 0.0, 0.0};  ///< Point in the body's frame [m].
};

struct PieceSource {
    InteractionId element{};
    HeldPoint end[2]{};
    bool routed = false;     ///< True if its ends come from WorldWires::ends().
    bool backwards = false;  ///< True if it leads from its second body to its first one.
    bool joint =
        false;  ///< True for a chain of rigid links: the force of the joint is its tension.
};

enum class WireKind : std::uint8_t { wire, links, line, rod };
[[nodiscard]] const char* to_string(WireKind kind) noexcept;

struct WireSource {
    WireKind kind = WireKind::wire;
    WireId wire{};  ///< Wire, for kind wire.
    std::string name{};
    std::int32_t cable = -1;  ///< Index of the scene's cable of this name; −1: none.
    std::vector<PieceSource> pieces{};
};

struct JointSource {
    InteractionId id{};
    std::int32_t body[2] = {-1, -1};
    Vec3 point{0.0, 0.0, 0.0};  ///< Point in the frame of the second body [m].
};

/// An input in the form for clients.
struct InputSource {
    std::string name{}, unit{}, group{}, kind{};
    double min = -1e30, max = 1e30, nominal = 0.0, factor = 1.0;
    std::optional<double> spring{};
    std::vector<std::string>
        words{};           ///< Words of the values 0, 1, …; empty: the input is no choice.
    std::string drives{};  ///< Signal that an input of the scene sets; "": none.
    InputId id{};          ///< Input of the world, or …
    const double* signal = nullptr;  ///< … a system's number; the value is that over `factor`.
};

struct FramePlan {
    std::vector<BodyId> rigid, lumps, scalars, fixed;  ///< Bodies without nodes of wires.
    std::vector<WireSource> wires;
    std::vector<JointSource> joints;
    std::vector<InputSource> inputs;
    std::vector<OutputId> outputs;
    std::vector<ShapeId> shapes;  ///< Shapes without segments of wires.

    /// Objects at the creation of the plan, to detect changes.
    std::vector<BodyId> all_bodies;
    std::vector<InteractionId> all_interactions;
    std::vector<ShapeId> all_shapes;
    std::vector<WireId> all_wires;
    std::vector<InputId> all_inputs;
    std::vector<OutputId> all_outputs;
    std::size_t all_signals = 0;

    [[nodiscard]] static FramePlan of(const scene::Scene& scene);
    /// True if the world still has the objects that it had when the plan was created.
    [[nodiscard]] bool current(const World& world) const;
    /// True if the scene is unchanged for clients: only nodes of wires may differ.
    [[nodiscard]] bool is_same_scene(const FramePlan& other) const;
};

}  // namespace hawser::live
