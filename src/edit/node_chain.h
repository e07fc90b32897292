// SPDX-License-Identifier: Apache-2.0
#pragma once
/// @file node_chain.h
/// The piece of a wire near a node in numbers, with and without the node.
///
/// All values are half a step before the poses, at the time of the velocities: y = x − (h/2) v.
/// There the scheme has its energy (hawser::Energy), and momenta are constant in between.

#include "edit/node_place.h"

#include <hawser/math.h>

#include <array>
#include <cstddef>

namespace hawser::context {
struct StepContext;
}  // namespace hawser::context

namespace hawser::edit {

/// Bodies along the wire, and the elements between neighbours.
struct NodeChain {
    static constexpr std::size_t kMaxNodes = 2 * kNodeReach + 3;
    struct ChainNode {
        std::int32_t body = -1;
        bool point = false;  ///< True for a node.
        bool moves = false;  ///< True if it is free, and all its interactions are included here.
        /// Mass [kg]; for another body: material that it takes over from the node.
        double mass = 0.0;
        Vec3 y{0, 0, 0};  ///< Position [m].
        Vec3 v{0, 0, 0};  ///< Velocity [m/s].
    };
    struct Piece {
        std::int32_t id = -1;
        bool one_sided = false;
        double mass = 0.0;  ///< Mass of its material [kg].
        double pair = 0.0;  ///< μ [kg], assembly::View::pair_mass.
        double EA = 0.0;    ///< Axial stiffness [N].
        double rest = 0.0;  ///< Rest length [m].
        double pull = 0.0;  ///< Force of its law at the poses [N].
        double rate = 0.0;  ///< Rate of its length [m/s].
    };
    std::array<ChainNode, kMaxNodes> lump{};
    std::array<Piece, kMaxNodes - 1> piece{};
    std::size_t count = 0;   ///< Number of nodes; there is one piece less.
    std::size_t middle = 0;  ///< Index of the node; after its removal, of the next node.
    double half = 0.0;       ///< h/2 [s]

    [[nodiscard]] Vec3 separation(std::size_t k) const { return lump[k + 1].y - lump[k].y; }
    [[nodiscard]] Vec3 separation_at_pose(std::size_t k) const {
        return separation(k) + half * (lump[k + 1].v - lump[k].v);
    }
};

[[nodiscard]] NodeChain nearby_chain(const context::StepContext& ctx,
                                     const NodeSurroundings& place) noexcept;

/// Return a chain of the same material without its middle node. The element before the node then
/// extends to the next node.
[[nodiscard]] NodeChain without_node(const NodeChain& chain) noexcept;

/// Return the kinetic and elastic energy of a chain of nodes and elements [J].
[[nodiscard]] double energy_of(const NodeChain& chain) noexcept;
/// Return the elastic energy of a chain of nodes and elements [J].
[[nodiscard]] double stretch_energy_of(const NodeChain& chain) noexcept;

struct NodeMomentum {
    Vec3 linear{0, 0, 0};   ///< Momentum [N s].
    Vec3 angular{0, 0, 0};  ///< Angular momentum [N m s].
};
/// Compute linear and angular momentum of the nodes of a chain.
/// @param about  Reference point of angular momentum [m].
[[nodiscard]] NodeMomentum momentum_of(const NodeChain& chain, const Vec3& about) noexcept;

/// Set the rest lengths of the elements at free nodes so that their forces remain unchanged at the
/// present poses.
void fit_lengths(NodeChain& chain) noexcept;

}  // namespace hawser::edit
