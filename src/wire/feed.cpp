// SPDX-License-Identifier: Apache-2.0
#include "wire/feed.h"

#include <hawser/world.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace hawser::wire {
namespace {

/// Bend limit: a node at a drum is removed unless the wire folds.
constexpr double kAnyBend = 1.6;
constexpr double kOtherLine =
    0.2;  ///< Relative difference of mass per length that no stretch explains.

}  // namespace

std::size_t node_slot(const World& world, InteractionId line, std::size_t fallback) {
    const InteractionDef& d = world.interaction_def(line);
    for (std::size_t slot = 0; slot < 2; ++slot)
        if (world.body_def(d.body[slot]).kind == BodyKind::lump) return slot;
    return fallback;
}

Vec3 weight_at(const World& world, InteractionId line, std::size_t node, double mass) {
    const BodyDef& body = world.body_def(world.interaction_def(line).body[node]);
    Vec3 each = body.gravity ? world.settings().gravity : Vec3::Zero().eval();
    if (body.kind == BodyKind::lump) each += body.force / body.mass;
    return mass * each;
}

void load_ends(const World& world, Loads& loads, InteractionId line, std::size_t node, double half,
               const Vec3& weight, const Vec3& held) {
    const InteractionDef& d = world.interaction_def(line);
    for (std::size_t slot = 0; slot < 2; ++slot) {
        const BodyId body = d.body[slot];
        const BodyDef& def = world.body_def(body);
        if (def.kind != BodyKind::lump && def.kind != BodyKind::rigid) continue;
        const Vec3 arm =
            slot == node ? (world.pose(body).orientation * d.point[slot]).eval() : held;
        loads.add_force(
            body, weight,
            def.kind == BodyKind::rigid ? arm.cross(weight).eval() : Vec3::Zero().eval());
        if (def.kind != BodyKind::lump) continue;
        loads.add_mass(body, (half * Mat3::Identity()).eval());
        loads.add_damping(body,
                          (half / def.mass * def.linear_damping).asDiagonal().toDenseMatrix());
    }
}

Vec3 element_chord(const World& world, InteractionId line, std::size_t node) {
    const std::array<Vec3, 2> ends = world.wires().ends(line);
    return ends[node] - ends[1 - node];
}

namespace {

/// Return the velocity of an end of an element [m/s].
Vec3 end_velocity(const World& world, InteractionId line, std::size_t end) {
    const InteractionDef& d = world.interaction_def(line);
    const Twist twist = world.velocity(d.body[end]);
    if (world.body_def(d.body[end]).kind == BodyKind::lump) return twist.linear;
    return twist.linear + twist.angular.cross(world.pose(d.body[end]).orientation * d.point[end]);
}

}  // namespace

double min_hauled_length(const World& world, InteractionId line, double element) {
    constexpr double kMostTurn = 0.1, kMostOfElement = 0.25;
    const double way = world.settings().step / kMostTurn;
    const Vec3 along = element_chord(world, line, 1).normalized();
    const Vec3 speed = end_velocity(world, line, 1) - end_velocity(world, line, 0);
    const double transverse = (speed - speed.dot(along) * along).norm();
    const double turns = std::max(world.settings().gravity.norm() * way * way, transverse * way);
    return std::min(turns, kMostOfElement * element);
}

void load_element(const World& world, Loads& loads, const ElementAtDrum& element,
                  std::size_t node) {
    const InteractionDef& line = world.interaction_def(element.line);
    const double half = 0.5 * element.mass_per_length * std::max(element.material, 0.0);
    const Vec3 weight = weight_at(world, element.line, node, half);
    const Vec3 u = element_chord(world, element.line, node).normalized();
    const BodyId fairlead = line.body[1 - node];
    load_ends(world, loads, element.line, node, half, weight,
              world.pose(fairlead).orientation * line.point[1 - node]);
    loads.add_force(element.drum, {element.radius * weight.dot(u), 0.0, 0.0});
    loads.add_mass(element.drum,
                   Eigen::Matrix<double, 1, 1>(half * element.radius * element.radius));
}

bool insert_feed_node(NodeEdits& nodes, const Feed& feed, double there, double& at) noexcept {
    const double beyond = feed.element / there, fraction = feed.ahead ? 1.0 - beyond : beyond;
    const double mass = feed.mass_per_length * there;
    // Use the bits that the world uses.
    const double fed_fraction = feed.ahead ? 1.0 - fraction : fraction;
    if (!nodes.insert_node(feed.line, fraction, mass).valid()) return false;
    at -= fed_fraction * there;
    return true;
}

bool feed_in_node(NodeEdits& nodes, const Feed& feed, std::size_t node, double& at) noexcept {
    const World& world = nodes.world;
    const BodyId lump = world.interaction_def(feed.line).body[node];
    if (world.body_def(lump).kind != BodyKind::lump) return false;
    const auto elements = world.wires().elements(world.wires().of(feed.line));
    std::size_t k = 0;
    while (k < elements.size() && elements[k] != feed.line) ++k;
    if (feed.ahead ? k + 1 >= elements.size() : k == 0 || k >= elements.size()) return false;
    const InteractionId next = elements[feed.ahead ? k + 1 : k - 1];
    if (!world.alive(next) || !world.intact(next)) return false;
    const InteractionDef& beyond = world.interaction_def(next);
    if (kind_info(beyond.kind).is(kWoundUp)) return false;
    const double mass = beyond.get("mass");
    // Wire of another line type stays outboard, because only the diameter and mass of this one are
    // known.
    const double line = mass / beyond.get("length");
    if (beyond.get("EA") != world.interaction_def(feed.line).get("EA") ||
        std::abs(line - feed.mass_per_length) > kOtherLine * feed.mass_per_length)
        return false;
    const BodyId far = beyond.body[node == 0 ? 0 : 1];
    const bool to_node = world.body_def(far).kind == BodyKind::lump;
    const double total_mass =
        world.body_def(lump).mass + (to_node ? world.body_def(far).mass : 0.0);
    if (!(mass > 0.0) || !nodes.remove_node(lump, kAnyBend)) return false;
    // Nodes may have kept some of their halves (edit/node_drum.cpp).
    const double returned_mass = total_mass - (to_node ? world.body_def(far).mass : -0.5 * mass);
    constexpr double kRounding = 1e-11;
    at += (std::abs(returned_mass - mass) > kRounding * mass ? returned_mass : mass) /
          feed.mass_per_length;
    return true;
}

}  // namespace hawser::wire
