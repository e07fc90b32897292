// SPDX-License-Identifier: Apache-2.0
#include "deadline_load.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace hawser::bench {
namespace {

constexpr std::uint32_t kCargoDeck = 1U << 30,
                        kCargoBox = 1U << 31;  ///< collision groups that no scene uses
const Vec3 kPlace{5000.0, 0.0, 0.0};           ///< far from all other bodies [m]

}  // namespace

DeckCargo::DeckCargo(World& world, int stacks) : first_shape_(world.shape_count()) {
    MaterialDef material{.name = "deck cargo"};
    material.friction = kFriction;
    material.stiffness = 2.0 * kStiffness;  // At their static depth, the upper ones slightly
                                            // displaced sideways.
    ShapeDef shape;
    shape.kind = ShapeKind::box;
    shape.material = world.add_material(material);
    deck_ = world.add_body({.name = "cargo deck", .kind = BodyKind::kinematic, .position = kPlace});
    shape.body = deck_;
    shape.half_size = {200.0, 200.0, 1.0};
    shape.position = {0.0, 0.0, -1.0};
    shape.group = kCargoDeck;
    shape.touches = kCargoBox;
    (void)world.add_shape(shape);
    shape.half_size = {0.5, 0.5, 0.5};
    shape.position = Vec3::Zero();
    shape.group = kCargoBox;
    shape.touches = kCargoDeck | kCargoBox;
    for (int k = 0; k < kHigh * stacks; ++k) {
        const int stack = k / kHigh, level = k % kHigh;
        home_.push_back(kPlace + Vec3(3.0 * (stack % 20), 3.0 * (stack / 20), 50.0 + 3.0 * level));
        boxes_.push_back(world.add_body({.position = home_.back(),
                                         .mass = kMass,
                                         .inertia = Mat3::Identity() * (kMass / 6.0),
                                         .gravity = false}));
        shape.body = boxes_.back();
        (void)world.add_shape(shape);
    }
}

void DeckCargo::lower_deck(World& world) {
    const double g = -world.settings().gravity.z();
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
        const auto level = static_cast<double>(k % kHigh);
        // As deep as they will lie, the upper ones a little aside.
        const double sinks = kMass * g / (4.0 * kStiffness);
        const double z = 0.5 + level - sinks * (level + 1.0) * kHigh / 2.0;
        Pose pose;
        pose.position = Vec3(home_[k].x() + 0.02 * level, home_[k].y(), kPlace.z() + z);
        world.set_pose(boxes_[k], pose);
        world.set_force(boxes_[k], {0.0, 0.0, -kMass * g}, Vec3::Zero());
    }
    since_ = world.time();
    down_ = true;
}

void DeckCargo::remove_boxes(World& world) {
    for (std::size_t k = 0; k < boxes_.size(); ++k) {
        Pose pose;
        pose.position = home_[k];
        world.set_pose(boxes_[k], pose);
        world.set_velocity(boxes_[k], {});
        world.set_force(boxes_[k], Vec3::Zero(), Vec3::Zero());
    }
    down_ = false;
}

void DeckCargo::move_deck(World& world) const {
    Twist twist;
    if (down_) twist.linear = {kSpeed * std::sin(kFrequency * (world.time() - since_)), 0.0, 0.0};
    world.set_velocity(deck_, twist);
}

double DeckCargo::penetration(const World& world) const {
    double deepest = 0.0;
    for (const ContactView& c : world.contacts())
        if (c.shape[0].index >= first_shape_) deepest = std::max(deepest, -c.gap);
    return deepest;
}

double DeckCargo::speed(const World& world) const {
    double most = 0.0;
    for (const BodyId b : boxes_) most = std::max(most, world.velocity(b).linear.norm());
    return most;
}

}  // namespace hawser::bench
