// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_chain.h
/// The piece of a wire about a node in numbers, as it is with the node and without.
///
/// All of it is half a step before the poses, where velocities live: y = x − (h/2) v. There the
/// scheme has its energy (hawser::Energy), and momenta are those of any time in between.

#include "step/node_place.h"

#include <hawser/math.h>

#include <array>
#include <cstddef>

namespace hawser::stepper {

struct StepContext;

/// Bodies along the wire, and the elements between one and the next.
struct NodeChain {
    static constexpr std::size_t kMost = 2 * kNodeReach + 3;
    struct Lump {
        std::int32_t body = -1;
        bool point = false;  ///< It is a lump.
        bool moves = false;  ///< And all that acts on it is here.
        /// [kg]; of another body: what it takes of the material that was the node's.
        double mass = 0.0;
        Vec3 y{0, 0, 0};  ///< [m]
        Vec3 v{0, 0, 0};  ///< [m/s]
    };
    struct Piece {
        std::int32_t id = -1;
        bool one_sided = false;
        double mass = 0.0;  ///< Of its material [kg].
        double pair = 0.0;  ///< μ [kg], assembly::View::pair_mass.
        double EA = 0.0;    ///< [N]
        double rest = 0.0;  ///< [m]
        double pull = 0.0;  ///< Of its law at the poses [N].
        double rate = 0.0;  ///< At which it grows [m/s].
    };
    std::array<Lump, kMost> lump{};
    std::array<Piece, kMost - 1> piece{};
    std::size_t count = 0;   ///< Lumps; one piece less.
    std::size_t middle = 0;  ///< The node; once it is away, the lump after its place.
    double half = 0.0;       ///< h/2 [s]

    [[nodiscard]] Vec3 apart(std::size_t k) const { return lump[k + 1].y - lump[k].y; }
    [[nodiscard]] Vec3 apart_at_pose(std::size_t k) const {
        return apart(k) + half * (lump[k + 1].v - lump[k].v);
    }
};

[[nodiscard]] NodeChain chain_about(const StepContext& ctx, const NodePlace& place) noexcept;

/// The same material without the node: the piece before it goes on to the lump behind.
[[nodiscard]] NodeChain without_node(const NodeChain& chain) noexcept;

/// Kinetic and elastic energy [J].
[[nodiscard]] double energy_of(const NodeChain& chain) noexcept;
/// Elastic energy alone [J].
[[nodiscard]] double stretch_energy_of(const NodeChain& chain) noexcept;

struct NodeMomentum {
    Vec3 linear{0, 0, 0};   ///< [N s]
    Vec3 angular{0, 0, 0};  ///< [N m s]
};
/// @param about  Point that angular momentum is taken about [m].
[[nodiscard]] NodeMomentum momentum_of(const NodeChain& chain, const Vec3& about) noexcept;

/// Lengths at rest at which the pieces about lumps that move pull as before at the poses.
void fit_lengths(NodeChain& chain) noexcept;

}  // namespace hawser::stepper
